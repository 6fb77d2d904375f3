#pragma once
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
class FormatterBase;
class Option;
class ParseError;
}  // namespace CLI

namespace ostraka::app {

/// What the help of each command says of the shell's status.
inline constexpr const char* kExitStatusWords =
    "Exit status: 0 complete, 1 incomplete or cancelled (run the same command to continue),\n"
    "2 unusable input, 3 needs review (ambiguous pairs).";

/// The words among which an option's value is, as builtin, colmap and openmvs; empty: any value.
std::vector<std::string> choicesOf(const CLI::Option& option);

/// What stands for an option's value in help: "builtin|colmap|openmvs", "NUMBER", "FOLDER"; empty
/// for an option without a value.
std::string valueWord(const CLI::Option& option);

/// Its commands that the help lists; the others are for packagers.
std::vector<const CLI::App*> listedCommands(const CLI::App& app);

/// The first line of a description.
std::string firstLine(const std::string& text);

/// Help in the words of people instead of the parser's.
std::shared_ptr<CLI::FormatterBase> plainHelp();

/// One sentence for a command line that cannot be used, and where to read on.
std::string sentenceOf(const CLI::ParseError& error, const CLI::App& root);

}  // namespace ostraka::app
