#include "exchange/read_back.h"

#include <gmock/gmock.h>

#include "catalogue/database.h"
#include "exported_project.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;
using namespace catalogue;

class ReadingBack : public ExportedProject {
 protected:
  Project empty(const std::string& name) {
    ProjectRecord record;
    record.code = "ARM";
    return std::move(*Project::create(folder_.path() / name, record));
  }
};

TEST_F(ReadingBack, GivesAnEmptyProjectTheSameRecordsAndFiles) {
  ASSERT_TRUE(exportTo("out", all));
  Project other = empty("other");
  const Result<ImportReport> report =
      readBack(other, folder_.path() / "out", ImportMode::Enter, {}, quiet, {});
  ASSERT_TRUE(report) << report.error().sentence();
  EXPECT_EQ(report->fresh, 3);
  EXPECT_EQ(report->refused, 0) << (report->refusals.empty() ? "" : report->refusals[0].reason);
  for (const SherdRow row : rows) {
    const SherdRecord was = *catalogue().sherd(row);
    const SherdRow now_row = *other.catalogue().sherdById(was.id);
    ASSERT_TRUE(now_row) << was.number;
    const SherdRecord now = *other.catalogue().sherd(now_row);
    for (const SherdField& field : sherdFields())
      EXPECT_EQ(textOf(now, field.name), textOf(was, field.name)) << was.number << field.name;
    EXPECT_EQ(textOf(now, "extra.drawer"), textOf(was, "extra.drawer"));
    const auto measured = *other.catalogue().measurements(now_row);
    const auto before = *catalogue().measurements(row);
    ASSERT_EQ(measured.size(), before.size());
    for (const Measurement& m : before)
      EXPECT_TRUE(std::any_of(measured.begin(), measured.end(), [&](const Measurement& n) {
        return n.kind == m.kind && n.value == m.value && n.method == m.method &&
               n.model_sha256 == m.model_sha256;
      })) << m.kind;
    EXPECT_TRUE(fs::exists(other.absolute(now.model_path)));
    EXPECT_TRUE(fs::exists(other.absolute(now.preview_path)));
    for (const FileRecord& file : valueIn(other.catalogue().files(now_row)))
      EXPECT_EQ(sha256(*readFile(other.absolute(file.path))), file.sha256) << file.path;
  }
  EXPECT_EQ(other.catalogue().contexts()->front().id, catalogue().context(context12)->id);
  EXPECT_EQ(other.catalogue().batchByNumber("B0001")->id, catalogue().batch(batch)->id);
  EXPECT_TRUE(other.catalogue().checkIntegrity());
  // Its own export is the same again.
  ExportOptions options;
  options.target = folder_.path() / "again";
  options.forms = {Form::Json};
  options.program = "ostraka 1.0.0";
  ASSERT_TRUE(exportFolder(other.catalogue(), other.folder(),
                           *other.catalogue().sherdRows(Filter{}, {}), options, quiet, {}));
}

TEST_F(ReadingBack, TwiceGivesOnceAndADifferenceStaysAsItIs) {
  ASSERT_TRUE(exportTo("out", all));
  Project other = empty("other");
  ASSERT_TRUE(readBack(other, folder_.path() / "out", ImportMode::Enter, {}, quiet, {}));
  const SherdRow row = *other.catalogue().sherdByNumber("ARM1-T3-0012-0001");
  const FieldChange change{row, "ware", "red"};
  ASSERT_TRUE(other.catalogue().change(std::span(&change, 1), {}));
  const Result<ImportReport> again =
      readBack(other, folder_.path() / "out", ImportMode::Enter, {}, quiet, {});
  ASSERT_TRUE(again) << again.error().sentence();
  EXPECT_EQ(again->fresh, 0);
  EXPECT_EQ(again->same, 2);
  EXPECT_EQ(again->refused, 1);
  EXPECT_EQ(again->refusals[0].value, "ARM1-T3-0012-0001");
  EXPECT_EQ(other.catalogue().sherd(row)->ware, "red");
  EXPECT_GE(other.backups().size(), 2u) << "backed up before";
}

TEST_F(ReadingBack, APreviewChangesNothing) {
  ASSERT_TRUE(exportTo("out", all));
  Project other = empty("other");
  const Result<ImportReport> preview =
      readBack(other, folder_.path() / "out", ImportMode::Preview, {}, quiet, {});
  ASSERT_TRUE(preview) << preview.error().sentence();
  EXPECT_EQ(preview->fresh, 3);
  EXPECT_TRUE(other.catalogue().contexts()->empty());
  EXPECT_FALSE(fs::exists(other.folder() / "imported"));
}

TEST_F(ReadingBack, NothingEntersWhenAFileWasChanged) {
  ASSERT_TRUE(exportTo("out", all));
  put(folder_.path() / "out/data/models/ARM1-T3-0012-0002.ply", "changed");
  Project other = empty("other");
  const Result<ImportReport> report =
      readBack(other, folder_.path() / "out", ImportMode::Enter, {}, quiet, {});
  ASSERT_FALSE(report);
  EXPECT_NE(report.error().sentence().find("changed after the export"), std::string::npos);
  EXPECT_TRUE(other.catalogue().sherdRows(Filter{}, {})->empty());
}

TEST_F(ReadingBack, AnArchiveOnAnEmptyLaptopIsTheSameProject) {
  const Result<std::int64_t> bytes =
      archiveProject(*project_, folder_.path() / "archive", "ostraka 1.0.0", quiet, {});
  ASSERT_TRUE(bytes) << bytes.error().sentence();
  const Result<void> restored =
      restoreProject(folder_.path() / "archive", folder_.path() / "laptop", quiet, {});
  ASSERT_TRUE(restored) << restored.error().sentence();
  Result<Project> laptop = Project::open(folder_.path() / "laptop");
  ASSERT_TRUE(laptop) << laptop.error().sentence();
  EXPECT_EQ(laptop->catalogue().historyLength(), catalogue().historyLength());
  EXPECT_EQ(laptop->catalogue().sherd(rows[0])->note, catalogue().sherd(rows[0])->note);
  for (const FileRecord& file : valueIn(catalogue().files()))
    EXPECT_EQ(sha256(*readFile(laptop->absolute(file.path))), file.sha256) << file.path;
  EXPECT_FALSE(restoreProject(folder_.path() / "archive", folder_.path() / "laptop", quiet, {}))
      << "never over a project";
  EXPECT_FALSE(archiveProject(*project_, project_->folder() / "inside", "ostraka", quiet, {}));
}

}  // namespace
}  // namespace ostraka::exchange
