// Manual pages from what the command line says of itself, so that the two never differ.
#include <CLI/CLI.hpp>
#include <cctype>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "command.h"
#include "files/files.h"
#include "help.h"

namespace ostraka::app {
namespace {

// Text as roff prints it: no line begins with a control character, hyphens stay what they are.
std::string roff(const std::string& text) {
  std::string result;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
    line_begins = c == '\n';
  }
  return result;
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

void addOptions(const CLI::App& app, std::string& page) {
  for (const CLI::Option* option : app.get_options()) {
    std::string name = option->get_name(false, true);
    if (name.empty()) continue;
    for (std::size_t at = 0; (at = name.find(',', at)) != std::string::npos; at += 2)
      name.insert(at + 1, " ");
    page += ".TP\n.B " + roff(name);
    // A positional is named by its word already.
    if (const std::string word = valueWord(*option); !word.empty() && !option->get_positional())
      page += " " + roff(word);
    page += "\n" + roff(option->get_description());
    if (!option->get_default_str().empty())
      page += ". Without it: " + roff(option->get_default_str()) + ".";
    page += "\n";
  }
}

// The sentence of --help, one line a status.
std::string exitStatus() {
  return ".SH EXIT STATUS\n"
         ".TP\n.B 0\nThe result is complete.\n"
         ".TP\n.B 1\nThe result is incomplete: cancelled (run the same command to continue), disk "
         "full, a sherd without a model, a goal of evaluate \\-\\-gate missed, something that "
         "doctor "
         "finds missing.\n"
         ".TP\n.B 2\nThe command line or the input cannot be used; the message names the file and "
         "what to do.\n"
         ".TP\n.B 3\nNeeds review: ambiguous pairs, or a photographed side that looks wrong.\n"
         ".PP\nWith \\-\\-json the object also contains the status, as exit_status.\n";
}

std::string pageOf(const CLI::App& app, const CLI::App& root, const std::string& name,
                   const std::string& command) {
  std::string page = ".TH " + upper(roff(name)) +
                     " 1 \"\" \"ostraka " OSTRAKA_VERSION "\" \"Ostraka\"\n.SH NAME\n" +
                     roff(name) + " \\- " + roff(firstLine(app.get_description())) +
                     "\n.SH SYNOPSIS\n.B " + roff(command) + "\n";
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_positional()) continue;
    const std::string word = roff(option->get_name(true));
    page += option->get_required() ? word + "\n" : "[" + word + "]\n";
  }
  page += "[OPTIONS]\n.SH DESCRIPTION\n" + roff(app.get_description()) + "\n";
  const auto commands = listedCommands(app);
  if (!commands.empty()) page += ".SH COMMANDS\n";
  for (const CLI::App* one : commands)
    page += ".TP\n.B " + roff(command + " " + one->get_name()) + "\n" +
            roff(firstLine(one->get_description())) + "\n";
  page += ".SH OPTIONS\n";
  addOptions(app, page);
  if (&app != &root) {
    page += ".SS Of every command\n";
    addOptions(root, page);
  }
  if (!app.get_footer().empty()) page += ".SH NOTES\n.nf\n" + roff(app.get_footer()) + "\n.fi\n";
  return page + exitStatus();
}

// One page for the program, one per command: ostraka.1, ostraka-process.1, ostraka-rig-predict.1.
// Returns how many.
Result<int> writePages(const CLI::App& app, const CLI::App& root, const std::string& name,
                       const std::string& command, const std::filesystem::path& folder) {
  if (const Result<void> written =
          writeFileAtomically(folder / (name + ".1"), pageOf(app, root, name, command));
      !written)
    return written.error();
  int pages = 1;
  for (const CLI::App* one : listedCommands(app)) {
    const Result<int> below = writePages(*one, root, name + "-" + one->get_name(),
                                         command + " " + one->get_name(), folder);
    if (!below) return below.error();
    pages += *below;
  }
  return pages;
}

}  // namespace

void addManPages(CLI::App& root, Command& chosen) {
  CLI::App* command = root.add_subcommand("man-pages", "Write the manual pages into a folder");
  command->group("");  // for packagers: not shown in the list
  const auto folder = std::make_shared<std::string>();
  command->add_option("FOLDER", *folder, "Where to")->required();
  command->callback([&root, &chosen, folder] {
    chosen = [&root, folder](Session& session) -> int {
      std::error_code failed;
      std::filesystem::create_directories(*folder, failed);
      const Result<int> pages = writePages(root, root, "ostraka", "ostraka", *folder);
      if (!pages) return fail(session, pages.error());
      return finish(session, Whole, {{"output", *folder}, {"pages", *pages}},
                    std::to_string(*pages) + " manual pages: " + *folder);
    };
  });
}

}  // namespace ostraka::app
