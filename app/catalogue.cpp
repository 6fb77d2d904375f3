#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/limits.h"
#include "catalogue/enter_results.h"
#include "catalogue/file_check.h"
#include "catalogue/filter.h"
#include "catalogue/project.h"
#include "command.h"
#include "damage.h"
#include "exchange/archive.h"
#include "exchange/export_folder.h"
#include "exchange/read_back.h"

namespace ostraka::app {
namespace {

namespace fs = std::filesystem;
using catalogue::Project;
using exchange::Form;

constexpr const char* kProgram = "ostraka " OSTRAKA_VERSION;
const catalogue::Act kAct = {{}, "command line", {}};

struct Options {
  fs::path project, other, output, refusals;
  std::string filter, batch;
  catalogue::ProjectRecord record;
  std::vector<Form> forms;
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

int reported(Session& session, const exchange::ImportReport& report, const Options& options) {
  if (!options.refusals.empty()) {
    const Result<void> written =
        writeFileAtomically(options.refusals, exchange::refusalsCsv(report));
    if (!written) return fail(session, written.error());
  }
  session.finishProgress();
  nlohmann::ordered_json refusals = nlohmann::ordered_json::array();
  for (const exchange::Refusal& refusal : report.refusals) {
    refusals.push_back({{"line", refusal.line},
                        {"column", refusal.column},
                        {"value", refusal.value},
                        {"reason", refusal.reason}});
    if (!session.json)
      std::fprintf(stderr, "line %d, %s '%s': %s\n", refusal.line, refusal.column.c_str(),
                   refusal.value.c_str(), refusal.reason.c_str());
  }
  if (!session.json)
    for (const std::string& warning : report.warnings)
      std::fprintf(stderr, "%s\n", warning.c_str());
  const int status = report.refused > 0 ? NotWhole : Whole;
  return said(session,
              {{"entered", options.enter},
               {"new", report.fresh},
               {"same", report.same},
               {"changed", report.changed},
               {"refused", report.refused},
               {"refusals", refusals},
               {"warnings", report.warnings},
               {"exit_status", status}},
              std::to_string(report.fresh) + " new, " + std::to_string(report.same) + " same, " +
                  std::to_string(report.changed) + " changed, " + std::to_string(report.refused) +
                  " refused" +
                  (options.enter ? "." : "; a preview: nothing was entered, --enter does it."));
}

exchange::ImportMode modeOf(const Options& options) {
  return options.enter ? exchange::ImportMode::Enter : exchange::ImportMode::Preview;
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
  if (options.enter)
    if (const auto saved = project->backUp(); !saved) return fail(session, saved.error());
  const exchange::ImportOptions how = {modeOf(options), options.make_places
                                                            ? exchange::UnknownPlaces::Make
                                                            : exchange::UnknownPlaces::Refuse};
  const auto report = exchange::importTable(project->catalogue(), *bytes, options.other.string(),
                                            how, kAct, session.progress, session.stop);
  if (report && report->not_reached > 0)
    std::fprintf(stderr, "Stopped: %d rows are not entered; the same command enters them.\n",
                 report->not_reached);
  return report ? reported(session, *report, options) : fail(session, report.error());
}

int runExport(const Options& options, Session& session) {
  Result<Project> project = Project::open(options.project);
  if (!project) return fail(session, project.error());
  const Result<catalogue::Filter> filter = catalogue::parseFilter(options.filter);
  if (!filter) return fail(session, filter.error());
  const auto rows = project->catalogue().sherdRows(*filter, {});
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
  const auto batch = project->catalogue().batchByNumber(options.batch);
  if (!batch) return fail(session, batch.error());
  session.progress.begin("enter", 1.0);
  const auto entered = catalogue::enterResults(project->catalogue(), project->folder(), batch->row,
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
  const auto done = exchange::archiveProject(
      *project,
      {options.output, kProgram,
       options.with_damage ? exchange::DamagedFiles::Seal : exchange::DamagedFiles::Refuse},
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
      exchange::restoreProject(options.other, options.output, session.progress, session.stop);
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
  const auto saved = project->backUp();
  if (!saved) return fail(session, saved.error());
  session.progress.begin("check", 1.0);
  const auto checked = catalogue::checkFiles(
      project->catalogue(), project->folder(),
      options.quick ? catalogue::CheckDepth::NamesAndSizes : catalogue::CheckDepth::Hashes,
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
               {"backup", saved->string()},
               {"files", checked->files},
               {"checked", checked->checked},
               {"damaged", damageJson(checked->damaged)},
               {"exit_status", good ? Whole : NotWhole}},
              good ? "The catalogue and its " + files +
                         " files are whole; a backup was made: " + saved->string()
                   : "Damaged files: " + std::to_string(checked->damaged.size()) + " of " + files +
                         "; put them back from a copy. The catalogue itself is whole; a backup "
                         "was made: " +
                         saved->string());
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
}

}  // namespace ostraka::app
