#include "help.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

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

std::vector<std::string> commandsOf(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* one : listedCommands(app)) names.push_back(one->get_name());
  return names;
}

constexpr std::string_view kOutOfRange = " not in range ";

bool isNumber(const std::string& text) {
  double value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  return !text.empty() && code == std::errc() && end == text.data() + text.size();
}

// "5.000000 to 200.000000" as 5 to 200.
std::string shortened(std::string range) {
  for (std::size_t point = range.find('.'); point != std::string::npos;
       point = range.find('.', point + 1)) {
    const std::size_t end =
        std::min(range.find_first_not_of("0123456789", point + 1), range.size());
    const std::size_t last = range.find_last_not_of('0', end - 1);
    range.erase(last == point ? point : last + 1, end - (last == point ? point : last + 1));
  }
  return range;
}

// How many letters are changed, left out or put in.
std::size_t slipsBetween(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t corner = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = corner + (a[i - 1] == b[j - 1] ? 0 : 1);
      corner = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

// The name that was probably meant, or none.
std::string nearestOf(const std::vector<std::string>& names, const std::string& typed) {
  std::string nearest;
  std::size_t fewest = std::max<std::size_t>(1, typed.size() / 3) + 1;
  for (const std::string& name : names) {
    const std::size_t slips =
        name.starts_with(typed) && typed.size() > 3 ? std::size_t{1} : slipsBetween(typed, name);
    if (slips >= fewest) continue;
    fewest = slips;
    nearest = name;
  }
  return nearest;
}

std::vector<std::string> optionsOf(const CLI::App* app) {
  std::vector<std::string> names;
  for (; app != nullptr; app = app->get_parent())
    for (const CLI::Option* option : app->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
      for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
  return names;
}

// Of the words that nothing on the command line takes, the first option; its value may have been
// taken for something else.
std::string unknownOption(const CLI::App& root) {
  for (const std::string& word : root.remaining(true))
    if (word.size() > 1 && word.starts_with('-') && word != "--")
      return word.substr(0, word.find('='));
  return {};
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
  // "--marker-mm: Value wide not in range 5 to 200"
  if (const std::size_t value = message.find(": Value "); value != std::string::npos)
    if (const std::size_t range = message.find(kOutOfRange, value); range != std::string::npos) {
      const std::string typed = message.substr(value + 8, range - value - 8);
      return name + " takes a number from " +
             shortened(message.substr(range + kOutOfRange.size())) +
             (isNumber(typed) ? "; not '" + typed + "'" : "; '" + typed + "' is not a number");
    }
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

std::vector<const CLI::App*> listedCommands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); });
}

std::string firstLine(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

std::shared_ptr<CLI::FormatterBase> plainHelp() {
  return std::make_shared<PlainHelp>();
}

std::string sentenceOf(const CLI::ParseError& error, const CLI::App& root) {
  const CLI::App* app = nullptr;
  const std::string command = commandOf(root, app);
  std::string words = inWords(error.what());
  if (words == "A subcommand is required")
    words = command + " needs one of its commands: " + joined(commandsOf(*app), ", ");
  if (const std::string option = unknownOption(root); !option.empty()) {
    const std::string nearest = nearestOf(optionsOf(app), option);
    words = "'" + option + "' is not an option of " + command +
            (nearest.empty() ? "" : "; the nearest is '" + nearest + "'");
  } else if (const auto& typed = root.get_option("PROJECT")->results(); !typed.empty()) {
    const std::string nearest = nearestOf(commandsOf(*app), typed.front());
    if (!nearest.empty()) words += "; the nearest command is '" + nearest + "'";
  }
  return words + ". See " + command + " --help.";
}

}  // namespace ostraka::app
