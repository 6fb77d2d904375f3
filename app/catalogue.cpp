#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "archive/archive.h"
#include "base/limits.h"
#include "catalogue/batches.h"
#include "command.h"
#include "damage.h"
#include "exchange/export_folder.h"
#include "exchange/read_back.h"
#include "files/files.h"
#include "intake/enter_results.h"
#include "sherds/filter.h"
#include "sherds/sherds.h"
#include "upkeep/file_check.h"
#include "upkeep/project.h"
#include "upkeep/repair.h"

namespace ostraka::app {
namespace {

namespace fs = std::filesystem;
using exchange::Form;
using upkeep::Project;

constexpr const char* kProgram = "ostraka " OSTRAKA_VERSION;
const records::Provenance kAct = {{}, "command line", {}};

struct Options {
  fs::path project, other, output, refusals;
  std::string filter, batch;
  records::ProjectRecord record;
  std::vector<Form> forms;
  std::vector<std::string> columns, confirmed;
  double lighter_mm = 0;
  bool enter = false, make_places = false, quick = false, with_damage = false;
};

int said(Session& session, nlohmann::ordered_json json, const std::string& words) {
  session.finishProgress();
  json.emplace("exit_status", static_cast<int>(Whole));
  if (session.json)
    printJson(json);
  else
    std::printf("%s\n", words.c_str());
  return json["exit_status"];
}

const char* chosenBy(tables::ChosenBy by) {
  switch (by) {
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
  for (const tables::ColumnChoice& choice : mapping.columns) {
    const std::string unit = choice.unit.empty() ? std::string() : " in " + choice.unit;
    std::fprintf(stderr, "column '%s': %s%s (%s%s)\n", choice.column.c_str(),
                 choice.field.empty() ? "left out" : choice.field.c_str(), unit.c_str(),
                 chosenBy(choice.by), choice.unit_guessed ? "; the unit by the values" : "");
  }
}

nlohmann::ordered_json mappingJson(const tables::TableMapping& mapping) {
  nlohmann::ordered_json columns = nlohmann::ordered_json::array();
  for (const tables::ColumnChoice& choice : mapping.columns)
    columns.push_back({{"column", choice.column},
                       {"field", choice.field},
                       {"unit", choice.unit},
                       {"chosen", chosenBy(choice.by)},
                       {"unit_guessed", choice.unit_guessed}});
  return columns;
}

nlohmann::ordered_json refusalsJson(const std::vector<tables::Refusal>& refusals) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const tables::Refusal& refusal : refusals)
    list.push_back({{"line", refusal.line},
                    {"column", refusal.column},
                    {"value", refusal.value},
                    {"reason", refusal.reason}});
  return list;
}

int reported(Session& session, const tables::ImportReport& report, const Options& options) {
  if (!options.refusals.empty()) {
    const Result<void> written = writeFileAtomically(options.refusals, tables::refusalsCsv(report));
    if (!written) return fail(session, written.error());
  }
  session.finishProgress();
  if (!session.json) {
    printMapping(report.mapping);
    for (const auto* list : {&report.refusals, &report.questions})
      for (const tables::Refusal& refusal : *list)
        std::fprintf(stderr, "line %d, %s '%s': %s%s\n", refusal.line, refusal.column.c_str(),
                     refusal.value.c_str(), refusal.reason.c_str(),
                     list == &report.questions ? (" Not entered; --confirm " +
                                                  std::to_string(refusal.line) + " enters the row.")
                                                     .c_str()
                                               : "");
    for (const std::string& warning : report.warnings)
      std::fprintf(stderr, "%s\n", warning.c_str());
  }
  const int status = report.refused > 0 ? NotWhole : report.asked > 0 ? PersonMustDecide : Whole;
  return said(session,
              {{"entered", options.enter},
               {"new", report.fresh},
               {"same", report.same},
               {"changed", report.changed},
               {"refused", report.refused},
               {"to_confirm", report.asked},
               {"refusals", refusalsJson(report.refusals)},
               {"questions", refusalsJson(report.questions)},
               {"columns", mappingJson(report.mapping)},
               {"warnings", report.warnings},
               {"exit_status", status}},
              std::to_string(report.fresh) + " new, " + std::to_string(report.same) + " same, " +
                  std::to_string(report.changed) + " changed, " + std::to_string(report.refused) +
                  " refused, " + std::to_string(report.asked) + " to confirm" +
                  (options.enter ? "." : "; a preview: nothing was entered, --enter does it."));
}

tables::ImportMode modeOf(const Options& options) {
  return options.enter ? tables::ImportMode::Enter : tables::ImportMode::Preview;
}

Result<tables::ImportOptions> importOptions(const Options& options) {
  tables::ImportOptions how;
  how.mode = modeOf(options);
  if (options.make_places) how.unknown_places = tables::UnknownPlaces::Make;
  for (const std::string& text : options.columns) {
    Result<tables::ColumnChoice> choice = tables::parseColumnChoice(text);
    if (!choice) return choice.error();
    how.columns.push_back(std::move(*choice));
  }
  for (const std::string& text : options.confirmed) {
    int line = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), line);
    if (text == "all")
      how.asked_rows = tables::AskedRows::Enter;
    else if (code == std::errc() && end == text.data() + text.size() && line > 0)
      how.confirmed_lines.insert(line);
    else
      return Error{ErrorCode::UnusableInput,
                   "--confirm takes numbers of lines, or all; not '" + text + "'.",
                   {}};
  }
  return how;
}

int runNew(const Options& options, Session& session) {
  const Result<Project> made = Project::create(options.output, options.record);
  if (!made) return fail(session, made.error());
  return said(session, {{"output", options.output.string()}, {"code", options.record.code}},
              "A new project: " + options.output.string());
}

int runImport(const Options& options, Session& session) {
  Result<Project> project = Project::open(options.project);
  if (!project) return fail(session, project.error());
  session.progress.begin("import", 1.0);
  if (fs::is_directory(options.other)) {
    const auto report = exchange::readBack(*project, options.other, modeOf(options), kAct,
                                           session.progress, session.stop);
    return report ? reported(session, *report, options) : fail(session, report.error());
  }
  const Result<std::string> bytes = readFile(options.other, limits::kTableBytes.most);
  if (!bytes) return fail(session, bytes.error());
  const Result<tables::ImportOptions> how = importOptions(options);
  if (!how) return fail(session, how.error());
  if (options.enter)
    if (const auto saved = project->backUp(); !saved) return fail(session, saved.error());
  const auto report = tables::importTable(project->catalogue(), *bytes, options.other.string(),
                                          *how, kAct, session.progress, session.stop);
  if (report && report->not_reached > 0)
    std::fprintf(stderr, "Stopped: %d rows are not entered; the same command enters them.\n",
                 report->not_reached);
  return report ? reported(session, *report, options) : fail(session, report.error());
}

int runExport(const Options& options, Session& session) {
  Result<Project> project = Project::open(options.project);
  if (!project) return fail(session, project.error());
  const Result<sherds::Filter> filter = sherds::parseFilter(options.filter);
  if (!filter) return fail(session, filter.error());
  const auto rows = sherds::Sherds(project->catalogue()).rows(*filter, {});
  if (!rows) return fail(session, rows.error());
  exchange::ExportOptions how;
  how.target = options.output;
  how.program = kProgram;
  if (!options.forms.empty()) how.forms = {options.forms.begin(), options.forms.end()};
  how.deviation_mm = options.lighter_mm;
  session.progress.begin("export", 1.0);
  const auto done = exchange::exportFolder(project->catalogue(), project->folder(), *rows, how,
                                           session.progress, session.stop);
  if (!done) return fail(session, done.error());
  session.finishProgress();
  for (const std::string& warning : done->warnings) std::fprintf(stderr, "%s\n", warning.c_str());
  const int status = done->warnings.empty() ? Whole : NotWhole;
  return said(session,
              {{"output", options.output.string()},
               {"sherds", done->sherds},
               {"files", done->files},
               {"bytes", done->bytes},
               {"warnings", done->warnings},
               {"exit_status", status}},
              std::to_string(done->sherds) + " sherds in " + std::to_string(done->files) +
                  " files: " + options.output.string());
}

int runEnter(const Options& options, Session& session) {
  Result<Project> project = Project::open(options.project);
  if (!project) return fail(session, project.error());
  const auto batch = catalogue::Batches(project->catalogue()).byNumber(options.batch);
  if (!batch) return fail(session, batch.error());
  session.progress.begin("enter", 1.0);
  const auto entered = intake::enterResults(project->catalogue(), project->folder(), batch->row,
                                            project->resultsFolder(options.batch), kAct,
                                            session.progress, session.stop);
  if (!entered) return fail(session, entered.error());
  if (const auto saved = project->backUp(); !saved) return fail(session, saved.error());
  return said(session,
              {{"batch", options.batch},
               {"new_sherds", entered->new_sherds},
               {"models", entered->models},
               {"open", entered->open},
               {"exit_status", entered->open > 0 ? PersonMustDecide : Whole}},
              options.batch + ": " + std::to_string(entered->new_sherds) + " new sherds, " +
                  std::to_string(entered->models) + " models, " + std::to_string(entered->open) +
                  " want a person.");
}

int runArchive(const Options& options, Session& session) {
  const Result<Project> project = Project::open(options.project);
  if (!project) return fail(session, project.error());
  session.progress.begin("archive", 1.0);
  const auto done = archive::archiveProject(
      *project,
      {options.output, kProgram,
       options.with_damage ? archive::DamagedFiles::Seal : archive::DamagedFiles::Refuse},
      session.progress, session.stop);
  if (!done) return fail(session, done.error());
  session.finishProgress();
  printDamage(done->damage);
  const std::string damaged = "damaged files: " + std::to_string(done->damage.size());
  std::string words = "The whole project: " + options.output.string();
  if (!done->damage.empty())
    words = done->sealed
                ? "The project, " + damaged + ", which damage.txt lists: " + options.output.string()
                : "Nothing was archived; " + damaged +
                      ". Put them back from a copy, or archive --with-damage.";
  return said(session,
              {{"output", options.output.string()},
               {"sealed", done->sealed},
               {"bytes", done->bytes},
               {"damaged", damageJson(done->damage)},
               {"exit_status", done->damage.empty() ? Whole : NotWhole}},
              words);
}

int runRestore(const Options& options, Session& session) {
  session.progress.begin("restore", 1.0);
  const auto done =
      archive::restoreProject(options.other, options.output, session.progress, session.stop);
  if (!done) return fail(session, done.error());
  session.finishProgress();
  for (const std::string& line : done->damage) std::fprintf(stderr, "%s\n", line.c_str());
  return said(session,
              {{"output", options.output.string()},
               {"damage", done->damage},
               {"exit_status", done->damage.empty() ? Whole : NotWhole}},
              done->damage.empty()
                  ? "The project is back: " + options.output.string()
                  : "The project is back with the damage that it was archived with; damaged "
                    "files: " +
                        std::to_string(done->damage.size()) + ": " + options.output.string());
}

int runCheck(const Options& options, Session& session) {
  const Result<Project> project = Project::open(options.project);
  if (!project) return fail(session, project.error());
  const auto whole = project->catalogue().checkIntegrity();
  if (!whole) return fail(session, whole.error());
  std::string backup;
  if (!project->catalogue().readOnly()) {
    const auto saved = project->backUp();
    if (!saved) return fail(session, saved.error());
    backup = saved->string();
  }
  session.progress.begin("check", 1.0);
  const auto checked = upkeep::checkFiles(
      project->catalogue(), project->folder(),
      options.quick ? upkeep::CheckDepth::NamesAndSizes : upkeep::CheckDepth::Hashes,
      session.progress, session.stop);
  if (!checked)
    return fail(session, checked.error(),
                options.quick ? WhenStopped::BeginsAnew : WhenStopped::GoesOn);
  session.finishProgress();
  printDamage(checked->damaged);
  const bool good = checked->damaged.empty();
  const std::string files = std::to_string(checked->files);
  return said(session,
              {{"whole", good},
               {"backup", backup},
               {"files", checked->files},
               {"checked", checked->checked},
               {"damaged", damageJson(checked->damaged)},
               {"exit_status", good ? Whole : NotWhole}},
              (good ? "The catalogue and its " + files + " files are whole; "
                    : "Damaged files: " + std::to_string(checked->damaged.size()) + " of " + files +
                          "; put them back from a copy. The catalogue itself is whole; ") +
                  (backup.empty() ? "this project can only be read, so no backup was made."
                                  : "a backup was made: " + backup));
}

// One line for each row: what it is, and where it came from.
std::string wordsOf(const upkeep::RepairedRow& row, const std::string& backup) {
  using From = upkeep::RepairedRow::From;
  std::string words = row.table;
  if (row.row > 0) words += " " + std::to_string(row.row);
  if (!row.name.empty()) words += " (" + row.name + ")";
  if (!row.field.empty()) words += ", " + row.field;
  return words + (row.from == From::Backup    ? ": from " + backup
                  : row.from == From::History ? ": from the history"
                                              : ": not restored");
}

int runRepair(const Options& options, Session& session) {
  session.progress.begin("repair", 1.0);
  const auto report = upkeep::repairCatalogue(options.project, session.progress, session.stop);
  if (!report) return fail(session, report.error());
  session.finishProgress();
  const std::string backup = report->backup.filename().string();
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  int lost = 0;
  for (const upkeep::RepairedRow& row : report->rows) {
    const std::string words = wordsOf(row, backup);
    rows.push_back(words);
    lost += row.from == upkeep::RepairedRow::From::Nowhere ? 1 : 0;
    if (!session.json) std::printf("%s\n", words.c_str());
  }
  const bool whole = report->damaged.empty();
  const std::string pages = std::to_string(report->pages_by_bit) + " pages had one changed bit, " +
                            std::to_string(report->pages_by_backup) +
                            " were taken from a backup, " + std::to_string(report->pages_lost) +
                            " of " + std::to_string(report->pages) + " were lost";
  const std::string words =
      whole ? "The catalogue is whole; nothing was changed."
      : report->all_from_backup
          ? "Nothing in the damaged file could be read. The catalogue is that of " + backup +
                " again; the damaged file is kept: " + report->damaged.string()
          : "The catalogue is repaired: " + pages + "; " + std::to_string(report->rows.size()) +
                " rows are listed above, " + std::to_string(lost) +
                " of them not restored. The damaged file is kept: " + report->damaged.string();
  return said(session,
              {{"damaged", report->damaged.string()},
               {"backup", backup},
               {"all_from_backup", report->all_from_backup},
               {"pages", report->pages},
               {"pages_by_bit", report->pages_by_bit},
               {"pages_by_backup", report->pages_by_backup},
               {"pages_lost", report->pages_lost},
               {"rows", rows},
               {"exit_status", lost > 0 || report->all_from_backup ? NotWhole : Whole}},
              words);
}

CLI::Option* addProject(CLI::App* command, Options& options) {
  return command->add_option("PROJECT", options.project, "Folder of the project")
      ->required()
      ->check(CLI::ExistingDirectory);
}

CLI::Option* addOutput(CLI::App* command, Options& options, const char* words) {
  return command->add_option("--output,-o", options.output, words)->required();
}

}  // namespace

void addCatalogue(CLI::App& root, Command& chosen) {
  CLI::App* catalogue =
      root.add_subcommand("catalogue", "The sherds of a project: tables in and out, archives");
  catalogue->require_subcommand(1);
  auto options = std::make_shared<Options>();
  const auto add = [&](const char* name, const char* words, int (*run)(const Options&, Session&)) {
    CLI::App* command = catalogue->add_subcommand(name, words);
    command->callback([options, run, &chosen] {
      chosen = [options, run](Session& session) { return run(*options, session); };
    });
    return command;
  };
  CLI::App* fresh = add("new", "Make an empty project", runNew);
  addOutput(fresh, *options, "New or empty folder for the project");
  fresh->add_option("--code", options->record.code, "2 to 8 capital letters or digits, as ARM")
      ->required();
  fresh->add_option("--title", options->record.title, "Name of the project");
  fresh->add_option("--numbering", options->record.numbering, "How sherds are numbered")
      ->capture_default_str();
  CLI::App* import =
      add("import", "Read a CSV table or an export folder; a preview without --enter", runImport);
  addProject(import, *options);
  import->add_option("FILE", options->other, "Table (CSV) of sherds or contexts, or an export")
      ->required()
      ->check(CLI::ExistingPath);
  import->add_flag("--enter", options->enter, "Enter it; otherwise only say what would happen");
  import->add_flag("--make-places", options->make_places,
                   "Make sites, trenches, contexts and bags that are not there");
  import->add_option("--refusals", options->refusals, "Write what was refused, and why, as CSV");
  import->add_option("--map", options->columns,
                     "A column's field and unit, as Gewicht=weight_g:kg; COLUMN=- leaves it out");
  import
      ->add_option("--confirm", options->confirmed,
                   "Lines with a doubtful measurement that enter all the same, or all")
      ->delimiter(',');
  CLI::App* out = add("export", "Write sherds as a folder with checksums", runExport);
  addProject(out, *options);
  addOutput(out, *options, "New folder for the export");
  out->add_option("--filter", options->filter, "Which sherds, as in the window: rim thickness>6");
  out->add_option("--forms", options->forms, "What is written")
      ->delimiter(',')
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, Form>{{"csv", Form::Csv},
                                                              {"json", Form::Json},
                                                              {"ply", Form::Ply},
                                                              {"glb", Form::Glb},
                                                              {"obj", Form::Obj},
                                                              {"pictures", Form::Pictures},
                                                              {"photographs", Form::Photographs},
                                                              {"drawings", Form::Drawings},
                                                              {"ods", Form::Ods},
                                                              {"views", Form::Views}}))
      ->default_str("csv,json,ply,glb,pictures");
  out->add_option("--lighter", options->lighter_mm,
                  "Models with fewer triangles, 99.9 % of each within this many mm")
      ->check(CLI::Range(0.01, 1.0));
  CLI::App* enter = add("enter", "Enter the results of 'ostraka process' of a batch", runEnter);
  addProject(enter, *options);
  enter->add_option("BATCH", options->batch, "Number of the batch, as B0031")->required();
  CLI::App* archive =
      add("archive", "Write the whole project as a folder with checksums", runArchive);
  addProject(archive, *options);
  addOutput(archive, *options, "New folder for the archive");
  archive->add_flag("--with-damage", options->with_damage,
                    "Archive it though files are missing or changed, and list them in it");
  CLI::App* restore = add("restore", "Make a project from an archive", runRestore);
  restore->add_option("ARCHIVE", options->other, "Folder that 'catalogue archive' wrote")
      ->required()
      ->check(CLI::ExistingDirectory);
  addOutput(restore, *options, "New folder for the project");
  CLI::App* check = add("check", "Check the catalogue and its files, and back it up", runCheck);
  addProject(check, *options);
  check->add_flag("--quick", options->quick,
                  "Only names and sizes of the files, not what is in them");
  addProject(add("repair", "Restore a damaged catalogue from its backups and history", runRepair),
             *options);
}

}  // namespace ostraka::app
