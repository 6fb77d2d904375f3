#include "upkeep/peoples_file_check.h"

#include <gmock/gmock.h>

#include "base/uuid.h"
#include "batch/peoples_files.h"
#include "catalogue/files.h"
#include "catalogue/settings.h"
#include "decisions/decisions.h"
#include "decisions/mask_strokes.h"
#include "files/files.h"
#include "sherds/pair_decisions.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

// Two batches, B0001 and B0002; of the second a person set the first front aside.
class CheckedDecisions : public catalogue::SmallProject {
 protected:
  CheckedDecisions() {
    records::FileRecord report;  // so that its results are entered
    report.path = "results/B0002/report.json";
    report.role = "report";
    report.sha256 = sha256("{}");
    report.bytes = 2;
    report.batch = second_;
    EXPECT_TRUE(writeFileAtomically(project_->folder() / report.path, "{}"));
    EXPECT_TRUE(catalogue::Files(catalogue()).save(report, anna));
    decide(1);
  }
  void decide(int index) {
    decisions::PairDecision aside;
    aside.kind = decisions::DecisionKind::Aside;
    aside.by = "AP";
    aside.scans = {{batch::Side::Front, "f00" + std::to_string(index), {1, 2}, {}}};
    const decisions::PairDecision written =
        catalogue::valueIn(decisions::appendDecision(results(), aside));
    enter(written.id, index);
  }
  void enter(const std::string& id, int index) {
    records::PairDecision entered;
    entered.decision = id;
    entered.batch = second_;
    entered.front = scan(second_, batch::Side::Front, index);
    entered.verdict = records::Verdict::Aside;
    entered.by = anna.person;
    ASSERT_TRUE(sherds::PairDecisions(catalogue()).add(entered, anna));
  }
  fs::path results() const { return project_->folder() / "results/B0002"; }
  std::vector<std::string> damaged() {
    const OpenFolder project = catalogue::valueIn(OpenFolder::open(project_->folder()));
    std::vector<std::string> all;
    for (const DamagedFile& file : catalogue::valueIn(checkPeoplesFiles(catalogue(), project)))
      all.push_back(sentenceOf(file));
    return all;
  }
  store::BatchRow first_ = newBatch({bag4}), second_ = newBatch({bag5});
};

TEST_F(CheckedDecisions, AreWholeWhereTheFileHasThemAmongOthers) {
  EXPECT_THAT(damaged(), IsEmpty());
  decisions::PairDecision more;
  more.kind = decisions::DecisionKind::Aside;
  more.by = "AP";
  more.scans = {{batch::Side::Back, "b001", {1, 2}, {}}};
  ASSERT_TRUE(decisions::appendDecision(results(), more));
  EXPECT_THAT(damaged(), IsEmpty()) << "one that the catalogue has not learned of yet";
}

TEST_F(CheckedDecisions, MissTheOneThatAnOlderCopyOfTheFileLacks) {
  const std::string older = *readFile(results() / "decisions.json");
  decide(2);
  EXPECT_THAT(damaged(), IsEmpty());
  ASSERT_TRUE(writeFileAtomically(results() / "decisions.json", older));
  EXPECT_THAT(damaged(), ElementsAre("results/B0002/decisions.json (batch B0002) has changed since "
                                     "it was entered."));
}

TEST_F(CheckedDecisions, CannotBeReadFromWhatIsNoFileOfThem) {
  const auto unreadable = ElementsAre("results/B0002/decisions.json (batch B0002) cannot be read.");
  for (const char* text : {"", "[", "{\"format\":\"other/1\"}", "\xFF\xFE"}) {
    ASSERT_TRUE(writeFileAtomically(results() / "decisions.json", text));
    EXPECT_THAT(damaged(), unreadable) << text;
  }
  fs::remove(results() / "decisions.json");
  fs::create_directory(results() / "decisions.json");
  EXPECT_THAT(damaged(), unreadable) << "a folder";
}

// What somebody put in its place may be read, but is not the project's.
TEST_F(CheckedDecisions, AreNotReadThroughALinkOutOfTheProject) {
  fs::rename(results() / "decisions.json", folder_.path() / "elsewhere.json");
  fs::create_symlink(folder_.path() / "elsewhere.json", results() / "decisions.json");
  EXPECT_THAT(damaged(), testing::SizeIs(1));
}

TEST_F(CheckedDecisions, OfAWholeFolderThatIsGoneAreMissing) {
  fs::remove_all(results());
  EXPECT_THAT(damaged(), ElementsAre("results/B0002/decisions.json (batch B0002) is missing."));
}

// A batch of which nobody decided anything has no such file, and none is missed.
TEST_F(CheckedDecisions, AreAskedOfTheirOwnBatchAlone) {
  const fs::path other = project_->folder() / "results/B0001";
  fs::create_directories(other);
  fs::rename(results() / "decisions.json", other / "decisions.json");
  EXPECT_THAT(damaged(), ElementsAre("results/B0002/decisions.json (batch B0002) is missing."));
}

TEST_F(CheckedDecisions, AndStrokesAreToldByBatchAndName) {
  decisions::MaskStroke stroke;
  stroke.radius_px = 5;
  stroke.path_px = {{1, 10}};
  stroke.photograph = sha256("a");
  for (const char* number : {"B0001", "B0002"})
    ASSERT_TRUE(catalogue::Settings(catalogue())
                    .setValue(std::string(decisions::kKnownStrokes) + number,
                              decisions::knownText({stroke})));
  fs::remove(results() / "decisions.json");
  EXPECT_THAT(damaged(), testing::UnorderedElementsAre(
                             "results/B0001/mask_strokes.json (batch B0001) is missing.",
                             "results/B0002/decisions.json (batch B0002) is missing.",
                             "results/B0002/mask_strokes.json (batch B0002) is missing."));
}

}  // namespace
}  // namespace ostraka::upkeep
