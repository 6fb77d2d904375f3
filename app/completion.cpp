#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "command.h"

namespace ostraka::app {
namespace {

struct Node {
  std::string path;  // "ostraka process"
  std::string description;
  std::vector<std::pair<std::string, std::string>> options;   // long name, description
  std::vector<std::pair<std::string, std::string>> commands;  // name, description
};

std::string firstLine(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

void collect(const CLI::App& app, const std::string& path, std::vector<Node>& nodes) {
  Node node{path, firstLine(app.get_description()), {}, {}};
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames())
      node.options.emplace_back("--" + name, firstLine(option->get_description()));
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  for (const CLI::App* command : commands)
    node.commands.emplace_back(command->get_name(), firstLine(command->get_description()));
  nodes.push_back(node);
  for (const CLI::App* command : commands)
    collect(*command, path + " " + command->get_name(), nodes);
}

std::string escaped(const std::string& text, const std::string& special) {
  std::string result;
  for (const char c : text) {
    if (special.find(c) != std::string::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string lastWord(const std::string& path) {
  return path.substr(path.rfind(' ') + 1);
}

std::string bashScript(const std::vector<Node>& nodes) {
  std::string script =
      "_ostraka() {\n"
      "  local word=\"${COMP_WORDS[COMP_CWORD]}\" path=ostraka w\n"
      "  for w in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n    case \"$path $w\" in\n";
  for (const Node& node : nodes)
    if (node.path != "ostraka") script += "      '" + node.path + "') path='" + node.path + "';;\n";
  script += "    esac\n  done\n  local words=\n  case \"$path\" in\n";
  for (const Node& node : nodes) {
    script += "    '" + node.path + "') words='";
    for (const auto& [name, text] : node.commands) script += name + " ";
    for (const auto& [name, text] : node.options) script += name + " ";
    for (const auto& [name, text] : nodes.front().options)
      if (node.path != "ostraka" && name != "--help" && name != "--version") script += name + " ";
    script += "';;\n";
  }
  return script +
         "  esac\n"
         "  if [[ $word == -* ]] || [[ $path == ostraka ]] || [[ $path == 'ostraka rig' ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
         "  else\n    COMPREPLY=($(compgen -f -- \"$word\"))\n  fi\n"
         "}\n"
         "complete -o filenames -F _ostraka ostraka\n";
}

std::string zshScript(const std::vector<Node>& nodes) {
  std::string script =
      "#compdef ostraka\n"
      "_ostraka() {\n  local p=ostraka w\n  local -a words_of\n"
      "  for w in ${words[2,CURRENT-1]}; do\n    case \"$p $w\" in\n";
  for (const Node& node : nodes)
    if (node.path != "ostraka") script += "      ('" + node.path + "') p='" + node.path + "';;\n";
  script += "    esac\n  done\n  case \"$p\" in\n";
  for (const Node& node : nodes) {
    script += "    ('" + node.path + "') words_of=(";
    const auto add = [&](const auto& list) {
      for (const auto& [name, text] : list) {
        std::string clean;
        for (const char c : text) clean += c == '\'' ? '"' : c;
        script += "'" + escaped(name, ":") + ":" + clean + "' ";
      }
    };
    add(node.commands);
    add(node.options);
    script += ");;\n";
  }
  return script +
         "  esac\n  _describe 'ostraka' words_of\n  _files\n}\n"
         "compdef _ostraka ostraka\n";
}

std::string fishScript(const std::vector<Node>& nodes) {
  std::string script;
  for (const Node& node : nodes) {
    std::string when = "__fish_use_subcommand";
    if (node.path != "ostraka") when = "__fish_seen_subcommand_from " + lastWord(node.path);
    const auto line = [&](const std::string& rest, const std::string& text) {
      script +=
          "complete -c ostraka -n '" + when + "' " + rest + " -d '" + escaped(text, "'\\") + "'\n";
    };
    for (const auto& [name, text] : node.commands) line("-f -a " + name, text);
    for (const auto& [name, text] : node.options) line("-l " + name.substr(2), text);
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
    chosen = [script](Session&) {
      std::fputs(script.c_str(), stdout);
      return static_cast<int>(Whole);
    };
  });
}

}  // namespace ostraka::app
