// `ostraka catalogue import`: tables and export folders into a project.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/limits.h"
#include "base/text.h"
#include "catalogue_commands.h"
#include "exchange/read_back.h"
#include "files/files.h"
#include "files/open_folder.h"
#include "files/output_place.h"
#include "options.h"
#include "shown.h"
#include "tables/column_names.h"
#include "tables/refused_rows.h"
#include "upkeep/project.h"

namespace ostraka::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::size_t kMostSaid = 20;

struct ImportArguments {
  fs::path project, source, refusals;
  std::vector<std::string> columns, confirmed;
  bool enter = false, make_places = false, keep_both = false;
};

const char* chosenBy(const tables::ColumnChoice& choice) {
  if (choice.isOnlyShown()) return "only shown, never read";
  switch (choice.by) {
    case tables::ChosenBy::Name:
      return "by its name";
    case tables::ChosenBy::Earlier:
      return "as in the last table with these columns";
    case tables::ChosenBy::Person:
      return "as --map says";
    case tables::ChosenBy::Nobody:
      break;
  }
  return "a custom field";
}

// What was mapped, a line a column.
void printMapping(const tables::TableMapping& mapping) {
  if (!mapping.kind.empty()) show(stderr, "%s\n", mapping.kind.english().c_str());
  for (const tables::ColumnChoice& choice : mapping.columns) {
    const std::string unit = choice.unit.empty() ? std::string() : " in " + choice.unit;
    show(stderr, "column '%s': %s%s (%s%s)\n", choice.column.c_str(),
         choice.field.empty() ? "left out" : choice.field.c_str(), unit.c_str(), chosenBy(choice),
         choice.unit_guessed ? "; the unit is a guess" : "");
  }
}

// As a shell takes it: in single quotation marks, whatever is in it.
std::string mapOption(const tables::ColumnChoice& choice) {
  std::string text = choice.column + "=" + choice.field + ":" + choice.unit;
  for (std::size_t at = text.find('\''); at != std::string::npos; at = text.find('\'', at + 4))
    text.replace(at, 1, "'\\''");
  return "--map '" + text + "'";
}

// What a person has to state before anything enters.
std::vector<std::string> openUnits(const tables::TableMapping& mapping) {
  std::vector<std::string> sentences;
  for (const tables::ColumnChoice& choice : mapping.columns)
    if (choice.unit_guessed)
      sentences.push_back("The unit of the column '" + choice.column +
                          "' is a guess from its values: " + choice.unit +
                          ". State it to enter the table: " + mapOption(choice) + " (or " +
                          joined(tables::unitsOf(choice.field), ", ") + ").");
  return sentences;
}

ordered_json mappingJson(const tables::TableMapping& mapping) {
  ordered_json columns = ordered_json::array();
  for (const tables::ColumnChoice& choice : mapping.columns)
    columns.push_back({{"column", choice.column},
                       {"field", choice.field},
                       {"unit", choice.unit},
                       {"chosen", chosenBy(choice)},
                       {"unit_guessed", choice.unit_guessed}});
  return columns;
}

ordered_json refusalsJson(const std::vector<tables::Refusal>& refusals) {
  ordered_json list = ordered_json::array();
  for (const tables::Refusal& refusal : refusals)
    list.push_back({{"line", refusal.line},
                    {"column", refusal.column},
                    {"value", refusal.value},
                    {"reason", refusal.reason}});
  return list;
}

ordered_json changesJson(const std::vector<tables::ChangedValue>& changes) {
  ordered_json list = ordered_json::array();
  for (const tables::ChangedValue& change : changes)
    list.push_back({{"line", change.line},
                    {"number", change.name},
                    {"field", change.field},
                    {"old", change.old_value},
                    {"new", change.new_value}});
  return list;
}

void printChanges(const std::vector<tables::ChangedValue>& changes) {
  for (std::size_t i = 0; i < std::min(changes.size(), kMostSaid); ++i)
    show(stderr, "%s, %s: '%s' becomes '%s'\n", changes[i].name.c_str(), changes[i].field.c_str(),
         changes[i].old_value.c_str(), changes[i].new_value.c_str());
  if (changes.size() > kMostSaid)
    show(stderr, "%zu more values change; --json lists all.\n", changes.size() - kMostSaid);
}

void printRefusal(const tables::Refusal& refusal, const std::string& remedy) {
  show(stderr, "line %d, %s '%s': %s%s\n", refusal.line, refusal.column.c_str(),
       refusal.value.c_str(), refusal.reason.english().c_str(), remedy.c_str());
}

void printRefusals(const tables::ImportReport& report) {
  const std::size_t refused = std::min(report.refusals.size(), kMostSaid),
                    asked = std::min(report.questions.size(), kMostSaid);
  for (std::size_t i = 0; i < refused; ++i) printRefusal(report.refusals[i], {});
  for (std::size_t i = 0; i < asked; ++i)
    printRefusal(
        report.questions[i],
        " Not entered; --confirm " + std::to_string(report.questions[i].line) + " enters the row.");
  if (const std::size_t more = report.refusals.size() + report.questions.size() - refused - asked;
      more > 0)
    show(stderr, "%zu more reasons why rows were not entered; --refusals and --json list all.\n",
         more);
}

void printReport(const tables::ImportReport& report) {
  printMapping(report.mapping);
  printRefusals(report);
  printChanges(report.changed_values);
  for (const Message& warning : report.warnings) show(stderr, "%s\n", warning.english().c_str());
}

ExitStatus statusOf(const tables::ImportReport& report, bool units_open, bool refusals_lost) {
  if (report.not_reached > 0 || refusals_lost) return NotWhole;
  if (units_open) return PersonMustDecide;
  return report.refused > 0 ? NotWhole : report.asked > 0 ? PersonMustDecide : Whole;
}

std::string summaryOf(const tables::ImportReport& report, const ImportArguments& arguments) {
  const std::string counts = std::to_string(report.fresh) + " new, " + std::to_string(report.same) +
                             " same, " + std::to_string(report.changed) + " changed, " +
                             std::to_string(report.refused) + " refused, " +
                             std::to_string(report.asked) + " to confirm";
  if (report.held) return counts + "; nothing was entered: state the guessed units first.";
  return counts + (arguments.enter ? "." : "; a preview: nothing was entered, --enter does it.");
}

int reported(Session& session, const tables::ImportReport& report,
             const ImportArguments& arguments) {
  session.finishProgress();
  // What was entered is told even if its refusals cannot be written any more.
  Result<void> written;
  if (!arguments.refusals.empty())
    written = writeFileAtomically(
        arguments.refusals,
        tables::refusedRowsCsv(report, [](const Message& reason) { return reason.english(); }));
  if (!session.json) printReport(report);
  const std::vector<std::string> open = openUnits(report.mapping);
  for (const std::string& sentence : open) show(stderr, "%s\n", sentence.c_str());
  if (report.not_reached > 0)
    show(stderr, "Stopped: %d rows are not entered; the same command enters them.\n",
         report.not_reached);
  if (!written) show(stderr, "ostraka: %s\n", written.error().sentence().english().c_str());
  ordered_json json = {{"entered", arguments.enter && !report.held},
                       {"new", report.fresh},
                       {"same", report.same},
                       {"changed", report.changed},
                       {"refused", report.refused},
                       {"to_confirm", report.asked},
                       {"not_reached", report.not_reached},
                       {"refusals", refusalsJson(report.refusals)},
                       {"questions", refusalsJson(report.questions)},
                       {"changes", changesJson(report.changed_values)},
                       {"columns", mappingJson(report.mapping)},
                       {"units_to_state", open},
                       {"warnings", report.warnings}};
  if (!written) json["error"] = written.error().sentence();
  return finish(session, statusOf(report, !open.empty(), !written), std::move(json),
                summaryOf(report, arguments));
}

tables::ImportMode modeOf(const ImportArguments& arguments) {
  return arguments.enter ? tables::ImportMode::Enter : tables::ImportMode::Preview;
}

Result<tables::ImportOptions> importOptions(const ImportArguments& arguments) {
  tables::ImportOptions how;
  how.mode = modeOf(arguments);
  if (arguments.make_places) how.unknown_places = tables::UnknownPlaces::Make;
  for (const std::string& text : arguments.columns) {
    Result<tables::ColumnChoice> choice = tables::parseColumnChoice(text);
    if (!choice) return choice.error();
    how.columns.push_back(std::move(*choice));
  }
  for (const std::string& text : arguments.confirmed) {
    int line = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), line);
    if (text == "all")
      how.asked_rows = tables::AskedRows::Enter;
    else if (code == std::errc() && end == text.data() + text.size() && line > 0)
      how.confirmed_lines.insert(line);
    else
      return Error::unusable("--confirm takes numbers of lines, or all; not '" + text + "'.");
  }
  return how;
}

// A new file in a folder that is there, never in a project or a sealed folder: an earlier one may
// hold rows that somebody corrected since. An empty path is none.
Result<void> checkRefusalsFile(const fs::path& file) {
  if (file.empty()) return {};
  if (Result<void> good = checkOutputPlace(file); !good) return good;
  std::error_code failed;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, failed))
    return Error::unusable("There is no such folder; create it, or choose another location.",
                           folder.string());
  if (!file.has_filename())
    return Error::unusable("This is a folder, not a file; add the name of the table.",
                           file.string());
  if (Message other = otherThanAFile(file); !other.empty())
    return Error::unusable(std::move(other), file.string());
  if (fs::exists(fs::symlink_status(file, failed)))
    return Error::unusable(
        "A file with this name already exists and is not overwritten; choose another name.",
        file.string());
  if (!mayBeWritten(folder))
    return Error::unusable(
        "The folder cannot be written to; check its permissions, or choose another location.",
        folder.string());
  return {};
}

int runImport(const ImportArguments& arguments, Session& session) {
  if (const Result<void> good = checkRefusalsFile(arguments.refusals); !good)
    return fail(session, good.error());
  Result<upkeep::Project> project =
      upkeep::Project::open(arguments.project, {}, {session.stop, &session.progress});
  if (!project) return fail(session, project.error());
  session.progress.begin("import", 1.0);
  if (fs::is_directory(arguments.source)) {
    const auto report = exchange::readBack(*project, arguments.source, modeOf(arguments),
                                           kCommandLine, session.progress, session.stop,
                                           arguments.keep_both ? exchange::SamePhotographs::KeepBoth
                                                               : exchange::SamePhotographs::Refuse);
    return report ? reported(session, *report, arguments) : fail(session, report.error());
  }
  const Result<std::string> bytes = readFile(arguments.source, limits::kTableBytes.most);
  if (!bytes) return fail(session, bytes.error());
  const Result<tables::ImportOptions> how = importOptions(arguments);
  if (!how) return fail(session, how.error());
  if (arguments.enter)
    if (const auto saved = project->backUp(); !saved) return fail(session, saved.error());
  const auto report = tables::importTable(project->catalogue(), *bytes, arguments.source.string(),
                                          *how, kCommandLine, session.progress, session.stop);
  if (!report) return fail(session, report.error());
  if (report->mapping.missing.empty()) return reported(session, *report, arguments);
  if (!session.json) printMapping(report->mapping);
  return fail(session, Error::unusable(report->mapping.missing, arguments.source.string()));
}

}  // namespace

void addCatalogueImport(CLI::App& catalogue, Command& chosen) {
  CLI::App* command = catalogue.add_subcommand(
      "import", "Read a CSV table or an export folder; a preview without --enter");
  const auto arguments = std::make_shared<ImportArguments>();
  workOf(*command, chosen, runImport, arguments);
  addProject(*command, arguments->project);
  command->add_option("FILE", arguments->source, "Table (CSV) of sherds or contexts, or an export")
      ->required()
      ->check(CLI::ExistingPath);
  command->add_flag("--enter", arguments->enter, "Enter it; otherwise only say what would happen");
  command->add_flag("--make-places", arguments->make_places,
                    "Make sites, trenches, contexts and bags that are not there");
  command->add_flag("--keep-both", arguments->keep_both,
                    "Of an export: also batches whose photographs another batch has, too; their "
                    "sherds are then in the catalogue twice");
  command->add_option(
      "--refusals", arguments->refusals,
      "Write the refused rows with their reasons to a new table (CSV), to be corrected");
  command->add_option("--map", arguments->columns,
                      "A column's field and unit, as Gewicht=weight_g:kg; COLUMN=- leaves it out");
  command
      ->add_option("--confirm", arguments->confirmed,
                   "Lines with a doubtful measurement that enter all the same, or all")
      ->delimiter(',');
}

}  // namespace ostraka::app
