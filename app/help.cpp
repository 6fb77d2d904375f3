#include "help.h"

#include <CLI/CLI.hpp>

#include "base/text.h"

namespace ostraka::app {
namespace {

// "builtin->0,colmap->1" of "ENUM:value in {builtin->0,colmap->1} OR {0,1}"; empty without any.
std::string listIn(const std::string& text) {
  const std::size_t begin = text.find('{');
  const std::size_t end = text.find('}', begin);
  return begin == std::string::npos || end == std::string::npos
             ? std::string()
             : text.substr(begin + 1, end - begin - 1);
}

std::vector<std::string> wordsIn(const std::string& text) {
  std::vector<std::string> words;
  const std::string list = listIn(text);
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t comma = std::min(list.find(',', at), list.size());
    const std::string item = list.substr(at, comma - at);
    words.push_back(item.substr(0, item.find("->")));
    at = comma + 1;
  }
  return words;
}

class PlainHelp final : public CLI::Formatter {
 public:
  std::string make_footer(const CLI::App* app) const override {
    const std::string own = app->get_footer();
    return own + (own.empty() ? "" : "\n\n") + kExitStatusWords + "\n";
  }
  std::string make_option_opts(const CLI::Option* option) const override {
    const std::string word = valueWord(*option);
    if (word.empty()) return {};
    std::string text = option->get_positional() ? "" : " " + word;
    if (option->get_expected_max() == CLI::detail::expected_max_vector_size) text += " ...";
    if (option->get_required()) text += " (required)";
    return text;
  }
  std::string make_option_desc(const CLI::Option* option) const override {
    const std::string standard = option->get_default_str();
    return option->get_description() +
           (standard.empty() || valueWord(*option).empty() ? "" : "; else " + standard);
  }
};

// The command that was being read when the trouble came: "ostraka rig simulate".
std::string commandOf(const CLI::App& root, const CLI::App*& app) {
  std::string command = root.get_name();
  for (app = &root; !app->get_subcommands().empty();) {
    app = app->get_subcommands().front();
    command += " " + app->get_name();
  }
  return command;
}

std::string commandsOf(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* one : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!one->get_group().empty()) names.push_back(one->get_name());
  return joined(names, ", ");
}

// The parser's "--side: Check x value in {back->1,front->0} OR {1,0} FAILED" and the like.
std::string inWords(const std::string& message) {
  const std::size_t colon = message.find(": ");
  const std::string name = message.substr(0, colon);
  const std::string list = listIn(message);
  if (const std::size_t check = message.find(": Check "); check != std::string::npos) {
    const std::size_t value = check + 8;
    const std::size_t end = message.find(" value in ", value);
    if (end != std::string::npos && !list.empty())
      return name + " takes " + joined(wordsIn(message), ", ") + "; not '" +
             message.substr(value, end - value) + "'";
  }
  if (const std::size_t none = message.find(" not in {"); none != std::string::npos)
    return name + " takes " + joined(wordsIn(message), ", ") + "; not '" +
           message.substr(colon + 2, none - colon - 2) + "'";
  if (message.starts_with("Could not convert: "))  // "Could not convert: --diameter = abc"
    if (const std::size_t equals = message.find(" = "); equals != std::string::npos)
      return message.substr(colon + 2, equals - colon - 2) + " takes a number; not '" +
             message.substr(equals + 3) + "'";
  if (message.find(" required ") != std::string::npos && message.ends_with(" missing"))
    return name + " needs a value";
  return message;
}

}  // namespace

std::vector<std::string> choicesOf(const CLI::Option& option) {
  return wordsIn(option.get_type_name());
}

std::string valueWord(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return {};
  if (const std::vector<std::string> words = choicesOf(option); !words.empty())
    return joined(words, "|");
  const std::string type = option.get_type_name();
  if (type.find("DIR") != std::string::npos) return "FOLDER";
  if (type.find("FILE") != std::string::npos || type.find("PATH") != std::string::npos)
    return "PATH";
  for (const char* number : {"INT", "UINT", "FLOAT"})
    if (type.starts_with(number)) return "NUMBER";
  return type.empty() ? "" : "TEXT";
}

std::shared_ptr<CLI::FormatterBase> plainHelp() {
  return std::make_shared<PlainHelp>();
}

std::string sentenceOf(const CLI::ParseError& error, const CLI::App& root) {
  const CLI::App* app = nullptr;
  const std::string command = commandOf(root, app);
  std::string words = inWords(error.what());
  if (words == "A subcommand is required")
    words = command + " needs one of its commands: " + commandsOf(*app);
  return words + ". See " + command + " --help.";
}

}  // namespace ostraka::app
