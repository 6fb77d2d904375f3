// Whatever text a person or a file offers: it is refused, or what it becomes part of can be
// archived and restored.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "archive/archive.h"
#include "base/limits.h"
#include "base/text.h"
#include "decisions/decisions.h"
#include "files/json.h"
#include "intake/review_decisions.h"
#include "merge/merge.h"
#include "tests/core/exchange/exported_project.h"

namespace ostraka::archive {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::vector<std::string> manyTexts() {
  return {"",
          "  ",
          "Գառնի, \"quoted\"; <b>&amp;</b>",
          "two\nlines\r\nand\ta tab",
          "./../../etc",
          "9\u202E\u200B",
          "e\u0301 \U0001F3FA",
          "\x7F\u0085",
          std::string(limits::kValueBytes.most, 'x'),
          std::string("8\0x", 3),
          "\x1B[31m",
          "\uFFFE",
          "\xFF\xFE",
          "\xED\xA0\x80",
          std::string(limits::kValueBytes.most + 1, 'x')};
}

class StoredTexts : public exchange::ExportedProject {
 protected:
  fs::path at(const std::string& name) const { return folder_.path() / name; }
  void copyTo(const std::string& name) {
    fs::remove_all(at("archive"));
    const Result<Archived> archived =
        archiveProject(*project_, {at("archive"), "ostraka 1.0.0"}, quiet, {});
    ASSERT_TRUE(archived) << archived.error().sentence();
    ASSERT_TRUE(archived->sealed);
    const Result<Restored> restored = restoreProject(at("archive"), at(name), quiet, {});
    EXPECT_TRUE(restored) << restored.error().sentence();
  }
  void expectRestorable() {
    copyTo("back");
    fs::remove_all(at("back"));
  }
  // JSON cannot hold what is not UTF-8.
  static std::string written(const json& value) {
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
  }
  static bool isStorableOnceWritten(const std::string& text) {
    return storable(json::parse(written(text)).get<std::string>());
  }
  static bool storable(const std::string& text) { return checkText(text).has_value(); }
};

TEST_F(StoredTexts, OfSherdsAndPlacesAreRefusedOrRestored) {
  for (const std::string& text : manyTexts()) {
    SCOPED_TRACE(text.substr(0, 20));
    EXPECT_EQ(set(rows[0], "note", text).has_value(), storable(text));
    records::ContextRecord context = *catalogue::Places(catalogue()).context(context12);
    context.note = text;
    EXPECT_EQ(catalogue::Places(catalogue()).save(context, anna).has_value(), storable(text));
    expectRestorable();
  }
}

TEST_F(StoredTexts, OfResultsAreRefusedOrRestored) {
  const fs::path results = project_->resultsFolder("B0001");
  const json pairs = *readJson(results / "pairs.json"), report = *readJson(results / "report.json");
  const auto enters = [&] {
    catalogue::ResultFolder::noteReports(results);
    return intake::enterResults(catalogue(), project_->folder(), batch, results, {}, quiet, {})
        .has_value();
  };
  for (const std::string& text : manyTexts()) {
    SCOPED_TRACE(text.substr(0, 20));
    json changed = pairs;
    changed["pairs"][0]["reason"] = text;
    put(results / "pairs.json", written(changed));
    const bool is_good = isStorableOnceWritten(text);
    EXPECT_EQ(enters(), is_good);
    put(results / "pairs.json", written(pairs));
    changed = report;
    changed["scale_doubts"] = json::array({text});
    put(results / "report.json", written(changed));
    const bool entered = enters();
    EXPECT_LE(entered, is_good) << "quoted in a list, the longest is too long";
    if (entered) expectRestorable();
    put(results / "report.json", written(report));
    EXPECT_TRUE(enters());
    if (!entered) expectRestorable();
  }
}

TEST_F(StoredTexts, OfDecisionsAreRefusedOrRestored) {
  const fs::path results = project_->resultsFolder("B0001");
  json kept = {{"format", 1}, {"unit", "mm"}, {"decisions", json::array()}};
  int n = 10;
  for (const std::string& text : manyTexts()) {
    SCOPED_TRACE(text.substr(0, 20));
    const json scan = {{"side", "front"}, {"id", "f001"}, {"place_mm", {40, 0}}};
    const json decision = {{"id", "0190a0b0-0000-7000-8000-0000000000" + std::to_string(n++)},
                           {"replaces", json::array()},
                           {"kind", "aside"},
                           {"at", ""},
                           {"by", "AP"},
                           {"note", text},
                           {"scans", json::array({scan})}};
    json more = kept;
    more["decisions"].push_back(decision);
    put(results / "decisions.json", written(more));
    const bool is_good = isStorableOnceWritten(text);
    const Result<int> entered = intake::followDecisions(catalogue(), "B0001", results);
    EXPECT_EQ(entered.has_value(), is_good);
    if (!entered) {
      EXPECT_EQ(entered.error().where, (results / "decisions.json").string());
      put(results / "decisions.json", written(kept));
    }
    decisions::PairDecision typed;
    typed.kind = decisions::DecisionKind::Aside;
    typed.by = "AP";
    typed.note = text;
    typed.scans = {{batch::Side::Front, "f002", {80, 0}}};
    EXPECT_EQ(decisions::appendDecision(results, typed).has_value(), storable(text));
    EXPECT_TRUE(intake::followDecisions(catalogue(), "B0001", results));
    kept = *readJson(results / "decisions.json");
    expectRestorable();
  }
}

TEST_F(StoredTexts, OfASettledMergeAreRefusedOrRestored) {
  int n = 0;
  for (const std::string& text : manyTexts()) {
    SCOPED_TRACE(text.substr(0, 20));
    fs::remove_all(at("b"));
    copyTo("b");
    upkeep::Project b =
        catalogue::valueIn(upkeep::Project::open(at("b"), [this] { return now_ms += 1; }));
    const std::string number = "C-" + std::to_string(++n);
    for (upkeep::Project* project : {project_.get(), &b}) {
      records::ContextRecord context;
      context.site = site;
      context.trench = trench;
      context.number = number;
      context.period = project == &b ? "Roman" : "Iron Age";
      ASSERT_TRUE(catalogue::Places(project->catalogue()).save(context, anna));
    }
    const auto merged = [&](merge::MergeMode mode, const merge::Settled& settled) {
      return merge::mergeInto(*project_, b.folder(), mode, settled, anna, quiet, {});
    };
    const auto preview = merged(merge::MergeMode::Preview, {});
    ASSERT_TRUE(preview) << preview.error().sentence();
    ASSERT_EQ(preview->conflicts.size(), 1u);
    const std::string id = preview->conflicts.front().id;
    const auto settled = merged(merge::MergeMode::Enter, {{id, {merge::Take::Number, text}}});
    if (settled && settled->entered) {
      EXPECT_TRUE(storable(text));
    } else {
      const auto other =
          merged(merge::MergeMode::Enter, {{id, {merge::Take::Number, "M-" + number}}});
      ASSERT_TRUE(other) << other.error().sentence();
      EXPECT_TRUE(other->entered);
    }
  }
  expectRestorable();
}

}  // namespace
}  // namespace ostraka::archive
