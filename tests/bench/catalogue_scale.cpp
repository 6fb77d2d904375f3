// bench_catalogue_scale FOLDER [ROWS [changes|merge]]: makes a project of so many sherds in FOLDER
// by importing a table, unless it is there, then measures opening, paging and searching.
// Milliseconds on the clock and of the processor (what is left of the first when nobody else
// computes), the median and the worst of seven runs. merge: only merges two projects of so many
// sherds, which it makes in FOLDER.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>

#include "merge/merge.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/filter.h"
#include "sherds/many_changes.h"
#include "sherds/sherds.h"
#include "tables/csv.h"
#include "tables/import_table.h"
#include "upkeep/project.h"

namespace {

using namespace ostraka;

double processor_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double milliseconds(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

void measure(const char* what, const std::function<std::size_t()>& work) {
  std::vector<double> times, computed;
  std::size_t rows = 0;
  for (int i = 0; i < 7; ++i) {
    const double before = processor_ms();
    times.push_back(milliseconds([&] { rows = work(); }));
    computed.push_back(processor_ms() - before);
  }
  std::sort(times.begin(), times.end());
  std::sort(computed.begin(), computed.end());
  std::printf(
      "%-40s %8zu rows  clock: median %7.1f ms  worst %7.1f ms  processor: median %6.1f ms  worst "
      "%6.1f ms\n",
      what, rows, times[3], times[6], computed[3], computed[6]);
  std::fflush(stdout);
}

std::string tableOf(int first, int rows) {
  const char* parts[] = {"rim", "neck", "shoulder", "body", "base", "handle", "spout", "lid"};
  const char* wares[] = {"grey", "red slipped", "black burnished", "cooking", "painted fine"};
  const char* surfaces[] = {"plain", "smoothed", "burnished", "slipped", "washed"};
  std::string text = tables::csvLine({"number", "site", "trench", "context", "bag", "part", "ware",
                                      "surface_out", "munsell_out", "condition", "length_mm",
                                      "thickness_mean_mm", "weight_g", "note"});
  for (int i = first; i < first + rows; ++i) {
    const std::string trench = "T" + std::to_string(i / 20'000 + 1);
    const std::string context = std::to_string(10'001 + i / 200).substr(1);
    const std::string n = std::to_string(10'001 + i % 200).substr(1);
    text += tables::csvLine(
        {"ARM1-" + trench + "-" + context + "-" + n, "ARM1", trench, context,
         std::to_string(i / 50 % 4 + 1), parts[i % 8], wares[i % 5], surfaces[i % 5], "10YR 3/1",
         i % 7 == 0 ? "burnt" : "worn", std::to_string(20 + i % 90),
         std::to_string(3 + i % 12) + ".5", std::to_string(5 + i % 60),
         i % 100 == 0 ? "found close to the oven in the north-east corner" : ""});
  }
  return text;
}

std::size_t importTable(catalogue::Catalogue& into, const std::string& table) {
  QuietProgress quiet;
  const auto report =
      tables::importTable(into, table, "table",
                          {tables::ImportMode::Enter, tables::UnknownPlaces::Make}, {}, quiet, {});
  return report ? static_cast<std::size_t>(report->fresh) : 0;
}

// One field of all sherds, there and back, as the window's bulk edit does it.
int changeAll(catalogue::Catalogue& all, const std::vector<store::SherdRow>& ids) {
  QuietProgress quiet;
  std::vector<records::FieldChange> changes;
  for (const store::SherdRow& row : ids) changes.push_back({row, "vessel", "V1"});
  std::size_t undone = 0;
  for (const char* what : {"a field of all rows changed", "and taken back"}) {
    Result<std::vector<records::FieldChange>> undo = std::vector<records::FieldChange>();
    const double time =
        milliseconds([&] { undo = sherds::changeMany(all, changes, {}, quiet, {}); });
    if (!undo) return std::fprintf(stderr, "%s\n", undo.error().sentence().english().c_str()), 1;
    undone = undo->size();
    std::printf("%-40s %8zu rows  %9.1f s\n", what, undone, time / 1000);
    changes = std::move(*undo);
  }
  return undone == ids.size() ? 0 : 1;
}

// Half of the sherds of both projects are those of their common origin, which B described further;
// the second merge finds nothing to do.
int mergeTwo(const std::filesystem::path& folder, int rows) {
  QuietProgress quiet;
  const int half = rows / 2;
  records::ProjectRecord record;
  record.code = "ARM";
  std::filesystem::create_directories(folder / "b");
  Result<upkeep::Project> a = upkeep::Project::create(folder / "a", record);
  if (!a) return std::fprintf(stderr, "%s\n", a.error().sentence().english().c_str()), 1;
  importTable(a->catalogue(), tableOf(0, half));
  if (!a->catalogue().backup(folder / "b/catalogue.sqlite")) return 1;
  Result<upkeep::Project> b = upkeep::Project::open(folder / "b");
  if (!b) return std::fprintf(stderr, "%s\n", b.error().sentence().english().c_str()), 1;
  const std::vector<store::SherdRow> common = *sherds::Sherds(b->catalogue()).rows({}, {});
  std::vector<records::FieldChange> changes;
  for (const store::SherdRow& row : common) changes.push_back({row, "vessel", "V1"});
  if (!sherds::changeMany(b->catalogue(), changes, {}, quiet, {})) return 1;
  importTable(a->catalogue(), tableOf(half, half));
  importTable(b->catalogue(), tableOf(rows, half));
  for (const char* what : {"merge of two projects", "and once more"}) {
    Result<merge::MergeReport> report = merge::MergeReport();
    const double time = milliseconds([&] {
      report = merge::mergeInto(*a, b->folder(), merge::MergeMode::Enter, {}, {}, quiet, {});
    });
    if (!report)
      return std::fprintf(stderr, "%s\n", report.error().sentence().english().c_str()), 1;
    std::printf("%-40s %8d rows  %9.1f s\n", what, report->added + report->changed, time / 1000);
  }
  return 0;
}

int run(const std::filesystem::path& folder, int rows, const std::string& changes) {
  if (!upkeep::Project::isProject(folder)) {
    records::ProjectRecord record;
    record.code = "ARM";
    Result<upkeep::Project> made = upkeep::Project::create(folder, record);
    if (!made) return std::fprintf(stderr, "%s\n", made.error().sentence().english().c_str()), 1;
    std::size_t entered = 0;
    const std::string table = tableOf(0, rows);
    const double time = milliseconds([&] { entered = importTable(made->catalogue(), table); });
    std::printf("%-40s %8zu rows  %9.1f s\n", "import of a table", entered, time / 1000);
  }
  measure("open the project, all rows by number", [&] {
    Result<upkeep::Project> project = upkeep::Project::open(folder);
    return sherds::Sherds(project->catalogue()).rows({}, {})->size();
  });
  Result<upkeep::Project> project = upkeep::Project::open(folder);
  if (!project)
    return std::fprintf(stderr, "%s\n", project.error().sentence().english().c_str()), 1;
  catalogue::Catalogue& all = project->catalogue();
  const std::vector<store::SherdRow> ids = *sherds::Sherds(all).rows({}, {});
  std::size_t jump = 0;
  measure("a page of 128 somewhere", [&] {
    jump = (jump + 37'777) % (ids.size() - 128);
    return sherds::Sherds(all).of(std::span(ids).subspan(jump, 128))->size();
  });
  for (const char* line :
       {"rim T3 thickness>6", "burnished", "oven", "ARM1-T3-0212", "T3", "burnt", "ware:grey",
        "part:rim -burnt", "thickness>12", "note:*", "context:0300", "zzz"})
    measure(line, [&] { return sherds::Sherds(all).rows(*sherds::parseFilter(line), {})->size(); });
  for (const char* field : {"number", "length_mm", "thickness_mean_mm", "weight_g", "context",
                            "bag", "ware", "part", "state", "updated"})
    measure((std::string("all, ordered by ") + field).c_str(), [&] {
      return sherds::Sherds(all).rows({}, {field, true})->size();
    });
  return changes == "changes" ? changeAll(all, ids) : 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2)
    return std::fprintf(stderr, "bench_catalogue_scale FOLDER [ROWS [changes|merge]]\n"), 2;
  const std::string also = argc > 3 ? argv[3] : "";
  const int rows = argc > 2 ? std::atoi(argv[2]) : 100'000;
  return also == "merge" ? mergeTwo(argv[1], rows) : run(argv[1], rows, also);
}
