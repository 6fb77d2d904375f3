// `ostraka catalogue merge`: what another project holds comes into this one.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "catalogue_commands.h"
#include "merge/merge.h"
#include "options.h"
#include "shown.h"
#include "upkeep/project.h"

namespace ostraka::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::size_t kMostConflicts = 20;

struct MergeArguments {
  fs::path a, b, settled;
  bool dry_run = false;
};

std::string subjectOf(const merge::Conflict& conflict) {
  std::string subject = conflict.table;
  if (!conflict.name.empty()) subject += " " + conflict.name;
  if (!conflict.field.empty()) subject += ", " + conflict.field;
  return subject;
}

std::string textOf(const merge::Conflict& conflict, const merge::Version& version) {
  std::string text;
  for (const auto& [field, value] : version.values)
    text += (text.empty() ? "" : ", ") + (field == conflict.field ? "" : field + ": ") + value;
  return text;
}

std::vector<std::string> takesOf(const merge::Conflict& conflict) {
  std::vector<std::string> takes;
  for (const merge::Take take : conflict.takes) takes.emplace_back(merge::nameOf(take));
  return takes;
}

std::string newNumber(const std::string& words, const std::string& proposed) {
  return words + (proposed.empty() ? std::string() : ", for example " + proposed) + "\n";
}

void printConflicts(const merge::MergeReport& report) {
  std::size_t open = 0;
  for (const merge::Conflict& conflict : report.conflicts) {
    if (conflict.settled || ++open > kMostConflicts) continue;
    show(stderr, "%s\n  id: %s (%s)\n  a:  %s\n  b:  %s\n", subjectOf(conflict).c_str(),
         conflict.id.c_str(), joined(takesOf(conflict), ", ").c_str(),
         textOf(conflict, conflict.a).c_str(), textOf(conflict, conflict.b).c_str());
    if (!conflict.isOfTwoSherds()) continue;
    show(stderr, "%s%s%s", newNumber("  a: B's sherd gets another number", conflict.new_b).c_str(),
         newNumber("  b: A's sherd gets another number", conflict.new_a).c_str(),
         conflict.offers(merge::Take::One) ? "  one: one sherd, both records become one\n" : "");
  }
  if (open > kMostConflicts)
    show(stderr, "%zu more conflicts; --json lists all.\n", open - kMostConflicts);
}

ordered_json conflictsJson(const std::vector<merge::Conflict>& conflicts) {
  ordered_json list = ordered_json::array();
  for (const merge::Conflict& conflict : conflicts)
    list.push_back({{"id", conflict.id},
                    {"subject", subjectOf(conflict)},
                    {"a", textOf(conflict, conflict.a)},
                    {"b", textOf(conflict, conflict.b)},
                    {"takes", takesOf(conflict)},
                    {"new_a", conflict.new_a},
                    {"new_b", conflict.new_b},
                    {"settled", conflict.settled}});
  return list;
}

ordered_json numbersJson(
    const std::map<std::string, std::pair<std::string, std::string>>& numbers) {
  ordered_json list = ordered_json::array();
  for (const auto& [id, number] : numbers)
    list.push_back({{"id", id}, {"before", number.first}, {"now", number.second}});
  return list;
}

std::string summaryOf(const merge::MergeReport& report) {
  const auto open = std::count_if(report.conflicts.begin(), report.conflicts.end(),
                                  [](const merge::Conflict& one) { return !one.settled; });
  const std::string counts =
      std::to_string(report.added) + " rows added, " + std::to_string(report.changed) + " changed";
  if (open > 0)
    return "Nothing was merged; conflicts to settle: " + std::to_string(open) +
           ". Write each of their ids and what to take into a file and name it with --settle.";
  if (!report.entered) return counts + "; a preview: nothing was merged.";
  return counts + ", " + std::to_string(report.files) + " files copied.";
}

int runMerge(const MergeArguments& arguments, Session& session) {
  merge::Settled settled;
  if (!arguments.settled.empty()) {
    Result<merge::Settled> read = merge::readSettled(arguments.settled);
    if (!read) return fail(session, read.error());
    settled = std::move(*read);
  }
  Result<upkeep::Project> project =
      upkeep::Project::open(arguments.a, {}, {session.stop, &session.progress});
  if (!project) return fail(session, project.error());
  session.progress.begin("merge", 1.0);
  const auto mode = arguments.dry_run ? merge::MergeMode::Preview : merge::MergeMode::Enter;
  const auto report = merge::mergeInto(*project, arguments.b, mode, settled, kCommandLine,
                                       session.progress, session.stop);
  if (!report) return fail(session, report.error());
  session.finishProgress();
  if (!session.json) printConflicts(*report);
  for (const auto& [there, here] : report->renumbered)
    show(stderr, "Batch %s of B is batch %s here.\n", there.c_str(), here.c_str());
  for (const auto& [id, numbers] : report->new_numbers)
    show(stderr, "Sherd %s has another number here: %s.\n", numbers.first.c_str(),
         numbers.second.c_str());
  for (const std::string& file : report->missing)
    show(stderr, "B does not have this file, which its catalogue names: %s\n", file.c_str());
  const int status = report->unsettled()                                 ? PersonMustDecide
                     : !report->missing.empty() || !report->kept.empty() ? NotWhole
                                                                         : Whole;
  return finish(session, status,
                {{"merged", report->entered},
                 {"added", report->added},
                 {"changed", report->changed},
                 {"files", report->files},
                 {"bytes", report->bytes},
                 {"batches", report->renumbered},
                 {"numbers", numbersJson(report->new_numbers)},
                 {"missing", report->missing},
                 {"kept", report->kept},
                 {"conflicts", conflictsJson(report->conflicts)}},
                summaryOf(*report));
}

}  // namespace

void addCatalogueMerge(CLI::App& catalogue, Command& chosen) {
  CLI::App* command = catalogue.add_subcommand(
      "merge", "Bring what project B holds into project A; B is only read");
  const auto arguments = std::make_shared<MergeArguments>();
  workOf(*command, chosen, runMerge, arguments);
  command->footer(
      "For example, to see what would come from another laptop, and then bring it:\n"
      "  ostraka catalogue merge Hill Hill-laptop --dry-run\n"
      "  ostraka catalogue merge Hill Hill-laptop --settle choices.json\n"
      "choices.json has a choice for the id of each conflict that the first command lists:\n"
      "  [{\"id\": \"sherd/UUID/ware\", \"take\": \"b\"},\n"
      "   {\"id\": \"number/UUID\", \"take\": \"a\", \"number\": \"ARM1-T3-0012-0099\"},\n"
      "   {\"id\": \"number/UUID\", \"take\": \"one\"}]\n"
      "Of a number that two sherds have: a or b keeps it, and the other sherd gets \"number\",\n"
      "or the next free one; one: they are one sherd, and both records become one.");
  addProject(*command, arguments->a, "A", "Folder of the project that is changed");
  addProject(*command, arguments->b, "B", "Folder of the project that is read");
  command->add_option("--settle", arguments->settled, "What to take of each conflict, as JSON")
      ->check(CLI::ExistingFile);
  command->add_flag("--dry-run", arguments->dry_run, "Only say what would happen");
}

}  // namespace ostraka::app
