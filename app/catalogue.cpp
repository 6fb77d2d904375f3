#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "archive/archive.h"
#include "base/text.h"
#include "catalogue/batches.h"
#include "catalogue_commands.h"
#include "command.h"
#include "exchange/export_folder.h"
#include "intake/enter_results.h"
#include "intake/side_photographs.h"
#include "options.h"
#include "sherds/filter.h"
#include "sherds/numbers.h"
#include "sherds/sherds.h"
#include "shown.h"
#include "upkeep/file_check.h"
#include "upkeep/project.h"
#include "upkeep/repair.h"
#include "upkeep/value_check.h"

namespace ostraka::app {
namespace {

namespace fs = std::filesystem;
using exchange::Form;
using upkeep::Project;

constexpr const char* kProgram = "ostraka " OSTRAKA_VERSION;

struct Options {
  fs::path project, other, output;
  std::string filter, batch;
  records::ProjectRecord record;
  std::vector<Form> forms;
  std::size_t most_model_bytes = 0;
  drawing::Surface surface = drawing::Surface::Relief;
  drawing::Dpi dpi = drawing::Dpi::Usual;
  bool quick = false, with_damage = false, keep_both = false;
};

int runNew(const Options& options, Session& session) {
  const Result<Project> made = Project::create(options.output, options.record);
  if (!made) return fail(session, made.error());
  return finish(session, Whole,
                {{"output", options.output.string()}, {"code", options.record.code}},
                "A new project: " + options.output.string());
}

const std::map<std::string, Form>& formsByName() {
  static const std::map<std::string, Form> kForms = {{"csv", Form::Csv},
                                                     {"json", Form::Json},
                                                     {"ply", Form::Ply},
                                                     {"glb", Form::Glb},
                                                     {"obj", Form::Obj},
                                                     {"pictures", Form::Pictures},
                                                     {"photographs", Form::Photographs},
                                                     {"drawings", Form::Drawings},
                                                     {"ods", Form::Ods},
                                                     {"views", Form::Views}};
  return kForms;
}

std::vector<std::string> namesOf(const std::set<Form>& forms) {
  std::vector<std::string> names;
  for (const auto& [name, form] : formsByName())
    if (forms.contains(form)) names.push_back(name);
  return names;
}

int runExport(const Options& options, Session& session) {
  Result<Project> project = Project::open(options.project, {}, {session.stop, &session.progress});
  if (!project) return fail(session, project.error());
  const Result<sherds::Filter> filter = sherds::parseFilter(options.filter);
  if (!filter) return fail(session, filter.error());
  const auto rows = sherds::Sherds(project->catalogue()).rows(*filter, {});
  if (!rows) return fail(session, rows.error());
  exchange::ExportOptions how;
  how.target = options.output;
  how.program = kProgram;
  if (!options.forms.empty()) how.forms = {options.forms.begin(), options.forms.end()};
  how.most_model_bytes = options.most_model_bytes;
  how.drawing_surface = options.surface;
  how.drawing_dpi = options.dpi;
  session.progress.begin("export", 1.0);
  const auto done = exchange::exportFolder(project->catalogue(), project->folder(), *rows, how,
                                           session.progress, session.stop);
  if (!done) return fail(session, done.error());
  session.finishProgress();
  for (const Message& warning : done->warnings) show(stderr, "%s\n", warning.english().c_str());
  const std::vector<std::string> missing = namesOf(done->without_file);
  if (!missing.empty())
    show(stderr, "No files in these formats, since the sherds have none: %s.\n",
         joined(missing, ", ").c_str());
  if (!done->without_model.empty())
    show(stderr, "Sherds without a model: %s.\n", joined(done->without_model, ", ").c_str());
  const bool nothing = done->without_file.size() == how.forms.size();
  const int status = done->warnings.empty() && !nothing ? Whole : NotWhole;
  return finish(session, status,
                {{"output", options.output.string()},
                 {"sherds", done->sherds},
                 {"files", done->files},
                 {"bytes", done->bytes},
                 {"forms_without_file", missing},
                 {"without_model", done->without_model},
                 {"warnings", done->warnings}},
                std::to_string(done->sherds) + " sherds in " + std::to_string(done->files) +
                    " files: " + options.output.string());
}

int runEnter(const Options& options, Session& session) {
  Result<Project> project = Project::open(options.project, {}, {session.stop, &session.progress});
  if (!project) return fail(session, project.error());
  const auto batch = catalogue::Batches(project->catalogue()).byNumber(options.batch);
  if (!batch) return fail(session, batch.error());
  // It reads the whole catalogue: a damaged one, and a full disk, are found before anything is
  // entered.
  if (const auto saved = project->backUp(); !saved) return fail(session, saved.error());
  session.progress.begin("enter", 1.0);
  if (options.keep_both)
    if (const auto kept = intake::keepBoth(project->catalogue(), options.batch, kCommandLine);
        !kept)
      return fail(session, kept.error());
  const auto entered = intake::enterResults(project->catalogue(), project->folder(), batch->row,
                                            project->resultsFolder(options.batch), kCommandLine,
                                            session.progress, session.stop);
  if (!entered) return fail(session, entered.error());
  session.finishProgress();
  std::vector<Message> warnings;
  for (const auto& photographs : {entered->other_photographs, entered->more_photographs})
    if (photographs) warnings.push_back(*photographs);
  if (const auto saved = project->backUp(); !saved)
    warnings.push_back(inOne("The results are entered, but the backup afterwards failed.",
                             saved.error().sentence()));
  for (const Message& warning : warnings) show(stderr, "ostraka: %s\n", warning.english().c_str());
  const bool must_decide = entered->open > 0 || entered->other_photographs;
  const int status = must_decide ? PersonMustDecide : warnings.empty() ? Whole : NotWhole;
  return finish(session, status,
                {{"batch", options.batch},
                 {"new_sherds", entered->new_sherds},
                 {"models", entered->models},
                 {"open", entered->open},
                 {"warnings", warnings}},
                options.batch + ": " + std::to_string(entered->new_sherds) + " new sherds, " +
                    std::to_string(entered->models) + " models, " + std::to_string(entered->open) +
                    " to review.");
}

void printDamage(const std::vector<upkeep::DamagedFile>& damaged) {
  for (const upkeep::DamagedFile& file : damaged) show(stderr, "%s\n", sentenceOf(file).c_str());
}

nlohmann::ordered_json damageJson(const std::vector<upkeep::DamagedFile>& damaged) {
  constexpr const char* kWords[] = {"missing", "changed", "unreadable"};
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [file, damage] : damaged)
    list.push_back({{"path", file.path},
                    {"damage", kWords[static_cast<int>(damage)]},
                    {"role", file.role},
                    {"sherd", file.sherd},
                    {"batch", file.batch}});
  return list;
}

int runArchive(const Options& options, Session& session) {
  const Result<Project> project =
      Project::open(options.project, {}, {session.stop, &session.progress});
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
  for (const std::string& link : done->links)
    show(stderr, "%s is a link; move what it leads to into the project.\n", link.c_str());
  const std::string damaged = "damaged files: " + std::to_string(done->damage.size()) +
                              ", links: " + std::to_string(done->links.size());
  std::string words = "The whole project: " + options.output.string();
  if (!done->whole())
    words = done->sealed
                ? "The project, " + damaged + ", which damage.txt lists: " + options.output.string()
                : "Nothing was archived; " + damaged +
                      ". Put them back from a copy, or archive --with-damage.";
  return finish(session, done->whole() ? Whole : NotWhole,
                {{"output", options.output.string()},
                 {"sealed", done->sealed},
                 {"bytes", done->bytes},
                 {"damaged", damageJson(done->damage)},
                 {"links", done->links}},
                words);
}

int runRestore(const Options& options, Session& session) {
  const auto done =
      archive::restoreProject(options.other, options.output, session.progress, session.stop);
  if (!done) return fail(session, done.error());
  session.finishProgress();
  for (const Message& line : done->damage) show(stderr, "%s\n", line.english().c_str());
  return finish(session, done->damage.empty() ? Whole : NotWhole,
                {{"output", options.output.string()}, {"damage", done->damage}},
                done->damage.empty()
                    ? "The project is back: " + options.output.string()
                    : "The project is back with the damage that it was archived with; damaged "
                      "files: " +
                          std::to_string(done->damage.size()) + ": " + options.output.string());
}

int runCheck(const Options& options, Session& session) {
  const Result<Project> project =
      Project::open(options.project, {}, {session.stop, &session.progress});
  if (!project) return fail(session, project.error());
  const auto whole = project->catalogue().checkIntegrity();
  if (!whole) return fail(session, whole.error());
  std::string backup;
  if (!project->catalogue().readOnly()) {
    const auto saved = project->backUp();
    if (!saved) return fail(session, saved.error());
    backup = saved->string();
  }
  if (const auto good = upkeep::checkValues(project->catalogue()); !good)
    return fail(session, good.error());
  if (const auto block = sherds::numberBlock(project->catalogue()); !block)
    return fail(session, block.error());
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
  std::string files = std::to_string(checked->files);
  if (const std::int64_t earlier = checked->files - checked->checked; earlier > 0)
    files += " files (" + std::to_string(checked->checked) + " read now, " +
             std::to_string(earlier) + " by the check that this one continued)";
  else
    files += " files";
  return finish(session, good ? Whole : NotWhole,
                {{"whole", good},
                 {"backup", backup},
                 {"files", checked->files},
                 {"checked", checked->checked},
                 {"damaged", damageJson(checked->damaged)}},
                (good ? "The catalogue and its " + files + " are whole; "
                      : "Damaged: " + std::to_string(checked->damaged.size()) + " of " + files +
                            "; put them back from a copy. The catalogue itself is whole; ") +
                    (backup.empty() ? "this project can only be read, so no backup was made."
                                    : "a backup was made: " + backup));
}

int runRepair(const Options& options, Session& session) {
  session.progress.begin("repair", 1.0);
  const auto report = upkeep::repairCatalogue(options.project, session.progress, session.stop);
  if (!report) return fail(session, report.error());
  session.finishProgress();
  if (!report->warning.empty()) session.progress.note(NoteLevel::Warning, report->warning);
  const std::string backup = report->backup.filename().string();
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  int lost = 0;
  for (const upkeep::RepairedRow& row : report->rows) {
    const std::string words = row.words(backup).english();
    rows.push_back(words);
    lost += row.from == upkeep::RepairedRow::From::Nowhere ? 1 : 0;
    if (!session.json) show(stdout, "%s\n", words.c_str());
  }
  const bool whole = report->damaged.empty();
  const std::string pages = std::to_string(report->pages_by_bit) + " pages had one changed bit, " +
                            std::to_string(report->pages_by_backup) +
                            " were taken from a backup, " + std::to_string(report->pages_lost) +
                            " of " + std::to_string(report->pages) + " were lost";
  const std::string words =
      whole                 ? "The catalogue is whole; nothing was changed."
      : report->interrupted ? "An earlier repair was interrupted and is now finished. Check the "
                              "catalogue for missing changes; the damaged file is kept: " +
                                  report->damaged.string()
      : report->all_from_backup
          ? "Nothing in the damaged file could be read. The catalogue is that of " + backup +
                " again; the damaged file is kept: " + report->damaged.string()
          : "The catalogue is repaired: " + pages + "; " + std::to_string(report->rows.size()) +
                " rows are listed above, " + std::to_string(lost) +
                " of them not restored. The damaged file is kept: " + report->damaged.string();
  return finish(session,
                lost > 0 || report->all_from_backup || report->interrupted ? NotWhole : Whole,
                {{"damaged", report->damaged.string()},
                 {"backup", backup},
                 {"interrupted", report->interrupted},
                 {"all_from_backup", report->all_from_backup},
                 {"pages", report->pages},
                 {"pages_by_bit", report->pages_by_bit},
                 {"pages_by_backup", report->pages_by_backup},
                 {"pages_lost", report->pages_lost},
                 {"rows", rows}},
                words);
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
    workOf(*command, chosen, run, options);
    return command;
  };
  CLI::App* fresh = add("new", "Make an empty project", runNew);
  addOutput(fresh, *options, "New or empty folder for the project");
  fresh->add_option("--code", options->record.code, "2 to 8 capital letters or digits, as ARM")
      ->required();
  fresh->add_option("--title", options->record.title, "Name of the project");
  fresh->add_option("--numbering", options->record.numbering, "How sherds are numbered")
      ->capture_default_str();
  addCatalogueImport(*catalogue, chosen);
  addCatalogueMerge(*catalogue, chosen);
  CLI::App* out = add("export", "Write sherds as a folder with checksums", runExport);
  addProject(*out, options->project);
  addOutput(out, *options, "New folder for the export");
  out->add_option("--filter", options->filter, "Which sherds, as in the window: rim thickness>6");
  out->add_option("--forms", options->forms, "Formats to write")
      ->delimiter(',')
      ->transform(CLI::CheckedTransformer(formsByName()))
      ->default_str("csv,json,ply,glb,pictures");
  addChoice(*out, "--size", options->most_model_bytes,
            {{"full", 0}, {"web", exchange::kWebBytes}, {"phone", exchange::kPhoneBytes}}, "full",
            "How large a GLB may be: as it is (full), 5 MB (web) or 1 MB (phone); PLY and OBJ "
            "get the same surface");
  addSurface(*out, options->surface, options->dpi);
  CLI::App* enter = add("enter", "Enter the results of 'ostraka process' of a batch", runEnter);
  addProject(*enter, options->project);
  enter->add_option("BATCH", options->batch, "Number of the batch, as B0031")->required();
  enter->add_flag("--keep-both", options->keep_both,
                  "Also when another batch has the same photographs; their sherds are then in the "
                  "catalogue twice");
  CLI::App* archive =
      add("archive", "Write the whole project as a folder with checksums", runArchive);
  addProject(*archive, options->project);
  addOutput(archive, *options, "New folder for the archive");
  archive->add_flag("--with-damage", options->with_damage,
                    "Archive it though files are missing or changed, and list them in it");
  CLI::App* restore = add("restore", "Make a project from an archive", runRestore);
  addProject(*restore, options->other, "ARCHIVE", "Folder that 'catalogue archive' wrote");
  addOutput(restore, *options, "New folder for the project");
  CLI::App* check = add("check", "Check the catalogue and its files, and back it up", runCheck);
  addProject(*check, options->project);
  check->add_flag("--quick", options->quick,
                  "Only names and sizes of the files, not what is in them");
  addProject(*add("repair", "Restore a damaged catalogue from its backups and history", runRepair),
             options->project);
}

}  // namespace ostraka::app
