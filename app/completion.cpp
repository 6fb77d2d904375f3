#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/text.h"
#include "command.h"
#include "help.h"

namespace ostraka::app {
namespace {

struct Choice {
  std::string name;  // "--dense"; empty for a positional
  std::string description;
  bool takes_value = false;
  std::vector<std::string> values;  // empty: files
};

struct Node {
  std::string path;                                           // "ostraka process"
  std::vector<Choice> options;                                // by long name
  std::vector<std::string> first_words;                       // of a positional that is a choice
  std::vector<std::pair<std::string, std::string>> commands;  // name, description
};

void collect(const CLI::App& app, const std::string& path, std::vector<Node>& nodes) {
  Node node{path, {}, {}, {}};
  for (const CLI::Option* option : app.get_options()) {
    const std::vector<std::string> values = choicesOf(*option);
    for (const std::string& name : option->get_lnames())
      node.options.push_back({"--" + name, firstLine(option->get_description()),
                              option->get_items_expected_max() > 0 && !valueWord(*option).empty(),
                              values});
    if (option->get_positional() && node.first_words.empty()) node.first_words = values;
  }
  const auto commands = listedCommands(app);
  for (const CLI::App* command : commands)
    node.commands.emplace_back(command->get_name(), firstLine(command->get_description()));
  nodes.push_back(node);
  for (const CLI::App* command : commands)
    collect(*command, path + " " + command->get_name(), nodes);
}

// Of every command, behind its own.
bool isOfEveryCommand(const Choice& option) {
  return option.name != "--help" && option.name != "--version";
}

std::string escaped(const std::string& text, const std::string& special) {
  std::string result;
  for (const char c : text) {
    if (special.find(c) != std::string::npos) result += '\\';
    result += c;
  }
  return result;
}

// `case` branches that follow the words typed so far down to the command they name.
std::string pathBranches(const std::vector<Node>& nodes, const std::string& open) {
  std::string script;
  for (const Node& node : nodes)
    if (node.path != "ostraka")
      script += "      " + open + "'" + node.path + "') p='" + node.path + "';;\n";
  return script;
}

std::string bashScript(const std::vector<Node>& nodes) {
  std::string script =
      "_ostraka() {\n"
      "  local word=\"${COMP_WORDS[COMP_CWORD]}\" before=\"${COMP_WORDS[COMP_CWORD-1]}\"\n"
      "  local p=ostraka options= words= values= w\n"
      "  for w in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n    case \"$p $w\" in\n" +
      pathBranches(nodes, "") + "    esac\n  done\n  case \"$p\" in\n";
  for (const Node& node : nodes) {
    script += "    '" + node.path + "') options='";
    for (const Choice& option : node.options) script += option.name + " ";
    if (node.path != "ostraka")
      for (const Choice& option : nodes.front().options)
        if (isOfEveryCommand(option)) script += option.name + " ";
    script += "' words='" + joined(node.first_words, " ");
    for (const auto& [name, text] : node.commands) script += name + " ";
    script += "';;\n";
  }
  script += "  esac\n  case \"$p $before\" in\n";
  for (const Node& node : nodes)
    for (const Choice& option : node.options)
      if (option.takes_value)
        script += "    '" + node.path + " " + option.name + "') values='" +
                  (option.values.empty() ? "FILES" : joined(option.values, " ")) + "';;\n";
  return script +
         "  esac\n"
         "  if [[ $values == FILES ]]; then\n    COMPREPLY=($(compgen -f -- \"$word\"))\n"
         "  elif [[ -n $values ]]; then\n    COMPREPLY=($(compgen -W \"$values\" -- \"$word\"))\n"
         "  elif [[ $word == -* ]]; then\n    COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
         "  else\n"
         "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
         "    [[ $p == ostraka || -z $words ]] && COMPREPLY+=($(compgen -f -- \"$word\"))\n"
         "  fi\n"
         "}\n"
         "complete -o filenames -F _ostraka ostraka\n";
}

std::string zshScript(const std::vector<Node>& nodes) {
  const auto described = [](const std::string& name, const std::string& text) {
    std::string clean;
    for (const char c : text) clean += c == '\'' ? '"' : c;
    return "'" + escaped(name, ":") + ":" + clean + "' ";
  };
  std::string script =
      "#compdef ostraka\n"
      "_ostraka() {\n  local p=ostraka w\n  local -a words_of values\n"
      "  for w in ${words[2,CURRENT-1]}; do\n    case \"$p $w\" in\n" +
      pathBranches(nodes, "(") +
      "    esac\n  done\n"
      "  case \"$p $words[CURRENT-1]\" in\n";
  for (const Node& node : nodes)
    for (const Choice& option : node.options)
      if (option.takes_value)
        script +=
            "    ('" + node.path + " " + option.name + "') " +
            (option.values.empty() ? "_files; return" : "values=(" + joined(option.values, " ")) +
            (option.values.empty() ? ";;\n" : ");;\n");
  script +=
      "  esac\n"
      "  if (( $#values )); then compadd -a values; return; fi\n"
      "  case \"$p\" in\n";
  for (const Node& node : nodes) {
    script += "    ('" + node.path + "') words_of=(";
    for (const std::string& word : node.first_words) script += word + " ";
    for (const auto& [name, text] : node.commands) script += described(name, text);
    for (const Choice& option : node.options) script += described(option.name, option.description);
    if (node.path != "ostraka")
      for (const Choice& option : nodes.front().options)
        if (isOfEveryCommand(option)) script += described(option.name, option.description);
    script += ");;\n";
  }
  return script +
         "  esac\n  _describe 'ostraka' words_of\n  _files\n}\n"
         "compdef _ostraka ostraka\n";
}

// "ostraka rig simulate" was typed when all its words were seen and none of a command below it.
std::string fishCondition(const Node& node) {
  if (node.path == "ostraka") return "__fish_use_subcommand";
  std::string when;
  for (std::size_t at = node.path.find(' '); at != std::string::npos;) {
    const std::size_t next = node.path.find(' ', at + 1);
    when += (when.empty() ? "" : "; and ") + std::string("__fish_seen_subcommand_from ") +
            node.path.substr(at + 1, next == std::string::npos ? next : next - at - 1);
    at = next;
  }
  if (!node.commands.empty()) when += "; and not __fish_seen_subcommand_from";
  for (const auto& [name, text] : node.commands) when += " " + name;
  return when;
}

std::string fishScript(const std::vector<Node>& nodes) {
  std::string script;
  for (const Node& node : nodes) {
    const std::string when = fishCondition(node);
    const auto line = [&](const std::string& condition, const std::string& rest,
                          const std::string& text) {
      script += "complete -c ostraka " + condition + rest + " -d '" + escaped(text, "'\\") + "'\n";
    };
    const std::string here = "-n '" + when + "' ";
    for (const auto& [name, text] : node.commands) line(here, "-f -a " + name, text);
    if (!node.first_words.empty()) line(here, "-f -a '" + joined(node.first_words, " ") + "'", "");
    for (const Choice& option : node.options) {
      std::string value = option.takes_value ? " -r" : "";
      if (!option.values.empty()) value = " -x -a '" + joined(option.values, " ") + "'";
      const bool everywhere = node.path == "ostraka" && option.name != "--version";
      if (everywhere || option.name != "--help")
        line(everywhere ? "" : here, "-l " + option.name.substr(2) + value, option.description);
    }
  }
  return script;
}

}  // namespace

void addCompletion(CLI::App& root, Command& chosen) {
  CLI::App* command =
      root.add_subcommand("completion", "Print the shell's completion script: bash, zsh or fish");
  command->footer(
      "For example: ostraka completion bash > ~/.local/share/bash-completion/completions/ostraka");
  auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->callback([shell, &root, &chosen] {
    std::vector<Node> nodes;
    collect(root, "ostraka", nodes);
    const std::string script = *shell == "bash"  ? bashScript(nodes)
                               : *shell == "zsh" ? zshScript(nodes)
                                                 : fishScript(nodes);
    chosen = [shell, script](Session& session) {
      return finish(session, Whole, {{"shell", *shell}, {"script", script}},
                    [&] { std::fputs(script.c_str(), stdout); });
    };
  });
}

}  // namespace ostraka::app
