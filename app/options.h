#pragma once
#include <CLI/CLI.hpp>
#include <map>
#include <optional>
#include <string>

namespace ostraka::app {

template <class Value>
struct ChoiceOf {
  using type = Value;
};
template <class Value>
struct ChoiceOf<std::optional<Value>> {
  using type = Value;
};

/// An option whose value is one of these words; standard: the word that is meant without it.
template <class Value>
CLI::Option* addChoice(CLI::App& command, const char* name, Value& value,
                       const std::map<std::string, typename ChoiceOf<Value>::type>& words,
                       const char* standard, const char* description) {
  return command.add_option(name, value, description)
      ->transform(CLI::CheckedTransformer(words))
      ->default_str(standard);
}

/// PROJECT, or another name for a folder of a project that is there.
inline CLI::Option* addProject(CLI::App& command, auto& folder, const char* name = "PROJECT",
                               const char* description = "Folder of the project") {
  return command.add_option(name, folder, description)->required()->check(CLI::ExistingDirectory);
}

}  // namespace ostraka::app
