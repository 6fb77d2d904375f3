#include "intake/read_results.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "files/files.h"
#include "files/json.h"
#include "store/database.h"
#include "tests/core/intake/entering.h"

namespace ostraka::intake {
namespace {

namespace fs = std::filesystem;

class DamagedResults : public Entering {};

// A disk that was full, a copy that broke off, a folder that somebody packed with links.
TEST_F(DamagedResults, AreNotEnteredWhereAFileIsCutEmptiedMissingOrALink) {
  out.photographs = "first";  // with a table of candidates, which names the scans
  out.write();
  const fs::path results = project_->resultsFolder("B0001");
  const auto refusal = [&] {
    const auto entered =
        enterResults(catalogue(), project_->folder(), batch, results, {}, quiet, {});
    EXPECT_FALSE(entered);
    return entered ? Error::unusable("entered") : entered.error();
  };
  for (const char* name :
       {"sherds/02/model.ply", "sherds/02/model.glb", "sherds/02/preview.png", "report.html",
        "work/model_02/stage.json", "work/texture_02/stage.json", "work/scans_front/f001.ply",
        "work/scans_front/stage.json", "work/pairs/stage.json"}) {
    SCOPED_TRACE(name);
    const fs::path file = results / name, aside = folder_.path() / "aside";
    const std::string whole = *readFile(file);
    ASSERT_TRUE(writeFileAtomically(file, ""));
    EXPECT_EQ(refusal().where, file);
    fs::rename(file, aside);
    EXPECT_EQ(refusal().where, file);
    ASSERT_TRUE(writeFileAtomically(aside, whole));
    fs::create_symlink(aside, file);
    EXPECT_EQ(refusal().where, file) << "a link, though to the same bytes";
    fs::remove(file);
    ASSERT_TRUE(writeFileAtomically(file, whole));
  }
  ASSERT_TRUE(writeFileAtomically(results / "sherds/03/model.glb", "model of f003b003model"));
  EXPECT_EQ(refusal().where, results / "sherds/03/model.glb") << "cut";
  EXPECT_TRUE(sherds().empty()) << "nothing is entered by halves";
  out.write();
  EXPECT_EQ(enter().models, 3);
}

// The scan of another batch would become this one's.
TEST_F(DamagedResults, AreNotEnteredWhereATableNamesScansOutsideTheirWork) {
  out.photographs = "first";  // with a table of candidates
  out.write();
  const fs::path results = project_->resultsFolder("B0001"),
                 other = project_->resultsFolder("B0002") / "work/scans_front",
                 table = results / "work/pairs/candidates.json";
  fs::create_directories(other);
  fs::copy_file(results / "work/scans_front/f001.ply", other / "f001.ply");
  const nlohmann::json whole = *readJson(table);
  for (const std::string& name :
       {std::string("../../B0002/work/scans_front/f001.ply"), (other / "f001.ply").string(),
        std::string("scans_front/../scans_front/f001.ply"), std::string()}) {
    nlohmann::json changed = whole;
    changed["fronts"][0]["file"] = name;
    ASSERT_TRUE(writeFileAtomically(table, changed.dump()));
    const auto entered =
        enterResults(catalogue(), project_->folder(), batch, results, {}, quiet, {});
    ASSERT_FALSE(entered) << name;
    EXPECT_EQ(entered.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(entered.error().where, table.string());
  }
  EXPECT_TRUE(sherds().empty());
}

TEST_F(DamagedResults, AreNotEnteredWithAMeasurementThatNoSherdHas) {
  const fs::path file = project_->resultsFolder("B0001") / "report.json";
  const nlohmann::json whole = *readJson(file);
  for (const double length_mm : {1e300, 10001.0}) {
    nlohmann::json changed = whole;
    changed["sherds"][0]["figures"]["measures"]["length_mm"] = length_mm;
    ASSERT_TRUE(writeFileAtomically(file, changed.dump()));
    catalogue::ResultFolder::noteReports(file.parent_path());
    const auto entered = enterResults(catalogue(), project_->folder(), batch,
                                      project_->resultsFolder("B0001"), {}, quiet, {});
    ASSERT_FALSE(entered) << length_mm;
    EXPECT_EQ(entered.error().where, file.string());
  }
  EXPECT_TRUE(sherds().empty());
}

// As `process` notes them: of scans in the record of their stage, of the reports in their own.
TEST_F(DamagedResults, AreNotEnteredWhereAScanOrAReportIsNotAsItWasWritten) {
  const fs::path results = project_->resultsFolder("B0001");
  nlohmann::ordered_json stage;
  for (const char* name : {"f001.ply", "f002.ply", "f003.ply"})
    stage["files"][name] = sha256(*readFile(results / "work/scans_front" / name));
  ASSERT_TRUE(writeJson(results / "work/scans_front/stage.json", stage));
  const auto refusal = [&] {
    const auto entered =
        enterResults(catalogue(), project_->folder(), batch, results, {}, quiet, {});
    return entered ? Error::unusable("entered") : entered.error();
  };
  for (const char* name : {"pairs.json", "report.html", "work/scans_front/f002.ply"}) {
    const std::string whole = *readFile(results / name);
    std::string flipped = whole;
    flipped[flipped.find_last_of("0123456789>")] ^= 1;
    ASSERT_TRUE(writeFileAtomically(results / name, flipped));
    EXPECT_EQ(refusal().where, (results / name).string());
    ASSERT_TRUE(writeFileAtomically(results / name, whole));
  }
  ASSERT_TRUE(writeJson(results / "work/batch.json", {{"front/a.jpg", "of this batch"}}));
  nlohmann::ordered_json record = *readJson(results / "work/reports.json");
  record["files"]["work/batch.json"] = sha256("of another batch");
  ASSERT_TRUE(writeJson(results / "work/reports.json", record));
  EXPECT_EQ(refusal().where, (results / "work/batch.json").string());
  catalogue::ResultFolder::noteReports(results);
  const std::string report = *readFile(results / "report.json");
  nlohmann::ordered_json edited = *readJson(results / "report.json");
  edited["sherds"][0]["figures"]["measures"]["volume_mm3"] = 123456;
  ASSERT_TRUE(writeJson(results / "report.json", edited));
  EXPECT_EQ(refusal().where, (results / "report.json").string());
  EXPECT_THAT(refusal().what.english(), testing::HasSubstr("differs from what 'ostraka process'"));
  ASSERT_TRUE(writeFileAtomically(results / "report.json", report));
  for (const char* other : {"{}", "[]", R"({"files": {}})"}) {
    ASSERT_TRUE(writeFileAtomically(results / "work/reports.json", other));
    EXPECT_THAT(refusal().what.english(), testing::HasSubstr("incomplete")) << other;
  }
  fs::remove(results / "work/reports.json");
  EXPECT_EQ(refusal().where, (results / "work/reports.json").string());
  EXPECT_TRUE(sherds().empty());
  out.write();
  EXPECT_EQ(enter().models, 3);
}

TEST_F(DamagedResults, AreNotEnteredWithTextsThatTheCatalogueCannotStore) {
  using nlohmann::ordered_json;
  const fs::path results = project_->resultsFolder("B0001");
  const auto refusedFile = [&] {
    const auto entered =
        enterResults(catalogue(), project_->folder(), batch, results, {}, quiet, {});
    out.write();
    return entered ? std::string() : fs::path(entered.error().where).filename().string();
  };
  for (const std::string& text :
       {std::string("a\0b", 3), std::string("\x1B[2J"), std::string(2'000'000, 'x')}) {
    ordered_json pairs = *readJson(results / "pairs.json");
    pairs["pairs"][1]["reason"] = text;
    ASSERT_TRUE(writeJson(results / "pairs.json", pairs));
    catalogue::ResultFolder::noteReports(results);
    EXPECT_EQ(refusedFile(), "pairs.json") << text.size();
    ordered_json report = *readJson(results / "report.json");
    report["scale_doubts"] = ordered_json::array({text});
    ASSERT_TRUE(writeJson(results / "report.json", report));
    catalogue::ResultFolder::noteReports(results);
    EXPECT_EQ(refusedFile(), "report.json") << text.size();
    const ordered_json scan = {{"side", "front"}, {"id", "f001"}, {"place_mm", {40, 0}}};
    const ordered_json decision = {{"id", "0190a0b0-0000-7000-8000-000000000007"},
                                   {"replaces", ordered_json::array()},
                                   {"kind", "aside"},
                                   {"at", ""},
                                   {"by", "AP"},
                                   {"note", text},
                                   {"scans", ordered_json::array({scan})}};
    ASSERT_TRUE(
        writeJson(results / "decisions.json",
                  {{"format", 1}, {"unit", "mm"}, {"decisions", ordered_json::array({decision})}}));
    EXPECT_EQ(refusedFile(), "decisions.json") << text.size();
    fs::remove(results / "decisions.json");
  }
  EXPECT_TRUE(sherds().empty());
  EXPECT_EQ(enter().models, 3);
}

TEST_F(DamagedResults, AreRefusedWhereAModelIsGone) {
  fs::remove(project_->resultsFolder("B0001") / "sherds/02/model.ply");
  const auto entered = enterResults(catalogue(), project_->folder(), batch,
                                    project_->resultsFolder("B0001"), {}, quiet, {});
  ASSERT_FALSE(entered);
  EXPECT_EQ(entered.error().code, ErrorCode::Missing);
  EXPECT_THAT(entered.error().where, testing::HasSubstr("sherds/02/model.ply"));
  EXPECT_TRUE(sherds().empty()) << "nothing is entered by halves";
}

TEST(PathsOfResults, AreThoseWithinTheProject) {
  EXPECT_EQ(relativeTo("/digs/a", "/digs/a/results/B0001/report.json"),
            "results/B0001/report.json");
  EXPECT_EQ(relativeTo("/digs/a", "/digs/a/results/../batches/x.png"), "batches/x.png");
  for (const char* outside : {"/digs/b/report.json", "/digs/a/../b", "/digs/abc/x"})
    EXPECT_THROW(relativeTo("/digs/a", outside), store::Refused) << outside;
}

TEST(PathsOfResults, TellWhatKindOfFileLiesThere) {
  EXPECT_EQ(mediaTypeOf("a/model.glb"), "model/gltf-binary");
  EXPECT_EQ(mediaTypeOf("preview.png"), "image/png");
  EXPECT_EQ(mediaTypeOf("report.json"), "application/json");
  EXPECT_EQ(mediaTypeOf("model.ply"), "application/octet-stream");
}

}  // namespace
}  // namespace ostraka::intake
