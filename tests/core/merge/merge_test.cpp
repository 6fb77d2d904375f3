// What one house changed comes to the other, once.
#include "merge/merge.h"

#include <gmock/gmock.h>

#include "two_houses.h"

namespace ostraka::merge {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;
using namespace catalogue;

using MergingProjects = TwoCopies;

TEST_F(MergingProjects, CopiesAreTheSame) {
  const std::string before = contentIn(*project_);
  const MergeReport report = merged(*project_, b_);
  EXPECT_TRUE(report.entered);
  EXPECT_EQ(report.added + report.changed + report.files, 0);
  EXPECT_EQ(contentIn(*project_), before);
}

TEST_F(MergingProjects, TakesWhatOnlyOneOfThemChangedAndOnce) {
  say(*project_, rows[0], "ware", "grey");
  say(b_, rows[0], "note", "a handle");
  say(b_, rows[1], "vessel", "jug");
  say(b_, rows[2], "weight_g", "31");
  say(b_, rows[1], "joins", "");
  const std::string added = sherds::Sherds(b_.catalogue()).get(newSherd(b_, context12, true))->id;
  const MergeReport report = merged(*project_, b_);
  EXPECT_TRUE(report.entered);
  EXPECT_THAT(report.conflicts, IsEmpty());
  EXPECT_EQ(valueOf(rows[0], "ware"), "grey");
  EXPECT_EQ(valueOf(rows[0], "note"), "a handle");
  EXPECT_EQ(valueOf(rows[1], "vessel"), "jug");
  EXPECT_EQ(valueOf(rows[2], "weight_g"), "31");
  EXPECT_EQ(valueOf(rows[0], "joins") + valueOf(rows[1], "joins"), "");
  EXPECT_EQ(saidOf(*project_, added, "number"), saidOf(b_, added, "number"));
  EXPECT_THAT(found("handle"), testing::ElementsAre("ARM1-T3-0012-0001")) << "and is found";
  EXPECT_TRUE(project_->catalogue().checkIntegrity());
  const std::string after = contentIn(*project_);
  merged(*project_, b_);
  EXPECT_EQ(contentIn(*project_), after) << "once more changes nothing";
}

// Pair by pair: what else was done to the same sherds says nothing of it.
TEST_F(MergingProjects, SherdsThatOneProjectPartedStayParted) {
  say(*project_, rows[1], "joins", "");
  say(b_, rows[0], "joins", "ARM1-T3-0012-0002; ARM1-T3-0012-0003");
  merged(b_, *project_);
  merged(*project_, b_);
  for (const upkeep::Project* project : {&*project_, &b_}) {
    EXPECT_EQ(saidOf(*project, idOf(rows[0]), "joins"), "ARM1-T3-0012-0003");
    EXPECT_EQ(saidOf(*project, idOf(rows[1]), "joins"), "");
    EXPECT_EQ(saidOf(*project, idOf(rows[2]), "joins"), "ARM1-T3-0012-0001");
  }
}

TEST_F(MergingProjects, SherdsThatOnePartedAndTheOtherJoinedAgainStayJoined) {
  say(*project_, rows[1], "joins", "");
  say(b_, rows[1], "joins", "");
  say(b_, rows[0], "joins", "ARM1-T3-0012-0002");
  merged(*project_, b_);
  EXPECT_EQ(valueOf(rows[1], "joins"), "ARM1-T3-0012-0001");
}

class MergingTerms : public MergingProjects {
 protected:
  static std::vector<std::string> termsOf(const upkeep::Project& project) {
    std::vector<std::string> names;
    for (const records::Term& term : valueIn(Settings(project.catalogue()).vocabulary("condition")))
      names.push_back(term.term);
    return names;
  }
  void change(upkeep::Project& project, const std::string& without, const std::string& with) {
    std::vector<records::Term> terms =
        valueIn(Settings(project.catalogue()).vocabulary("condition"));
    std::erase_if(terms, [&](const records::Term& term) { return term.term == without; });
    if (!with.empty()) {
      terms.emplace_back();
      terms.back().term = with;
    }
    EXPECT_TRUE(Settings(project.catalogue()).setVocabulary("condition", terms, anna));
  }
};

TEST_F(MergingTerms, ThatOneProjectTookAwayGoThoughTheOtherAddedOthers) {
  const std::string gone = termsOf(b_).front();
  change(*project_, gone, "");
  change(b_, "", "smoked");
  merged(b_, *project_);
  merged(*project_, b_);
  for (const upkeep::Project* project : {&*project_, &b_}) {
    EXPECT_THAT(termsOf(*project), testing::Not(testing::Contains(gone)));
    EXPECT_THAT(termsOf(*project), testing::Contains("smoked"));
  }
}

TEST_F(MergingTerms, ThatASherdHasStay) {
  const std::string used = termsOf(b_).front();
  change(*project_, used, "");
  say(b_, rows[0], "condition", used);
  merged(b_, *project_);
  merged(*project_, b_);
  for (const upkeep::Project* project : {&*project_, &b_})
    EXPECT_THAT(termsOf(*project), testing::Contains(used));
}

TEST_F(MergingTerms, AreCalledAsTheOneProjectSaysThatChangedThem) {
  std::vector<records::Term> terms = valueIn(Settings(b_.catalogue()).vocabulary("condition"));
  terms.front().labels["de"] = "angekohlt";
  ASSERT_TRUE(Settings(b_.catalogue()).setVocabulary("condition", terms, anna));
  EXPECT_THAT(merged(*project_, b_).conflicts, IsEmpty());
  EXPECT_EQ(valueIn(Settings(catalogue()).vocabulary("condition")), terms);
}

TEST_F(MergingProjects, OnlySaysWhatItWouldDoWhenAsked) {
  say(b_, rows[0], "note", "a handle");
  const std::string before = contentIn(*project_);
  const MergeReport report =
      valueIn(mergeInto(*project_, b_.folder(), MergeMode::Preview, {}, anna, quiet, {}));
  EXPECT_FALSE(report.entered);
  EXPECT_EQ(report.changed, 1);
  EXPECT_EQ(contentIn(*project_), before);
}

TEST_F(MergingProjects, TwoProjectsThatWereNeverOneBecomeOne) {
  records::ProjectRecord record;
  record.code = "ARM";
  upkeep::Project other = valueIn(
      upkeep::Project::create(folder_.path() / "other", record, [this] { return now_ms += 1; }));
  EXPECT_TRUE(merged(other, *project_).entered);
  EXPECT_TRUE(other.catalogue().checkIntegrity());
  for (const store::SherdRow row : rows)
    for (const char* field : {"number", "site", "context", "part", "note", "weight_g", "batch"})
      EXPECT_EQ(saidOf(other, idOf(row), field), valueOf(row, field)) << field;
  const std::string after = contentIn(other);
  merged(other, *project_);
  EXPECT_EQ(contentIn(other), after);
}

TEST_F(MergingProjects, RefusesItselfAndWhatIsNoProject) {
  const auto refused = [&](const fs::path& b) {
    const std::string before = contentIn(*project_);
    const Result<MergeReport> report =
        mergeInto(*project_, b, MergeMode::Enter, {}, anna, quiet, {});
    EXPECT_FALSE(report) << b;
    EXPECT_EQ(contentIn(*project_), before);
    return report ? Error{} : report.error();
  };
  EXPECT_THAT(refused(project_->folder()).what, testing::HasSubstr("with itself"));
  fs::create_directory_symlink(project_->folder(), folder_.path() / "link");
  EXPECT_THAT(refused(folder_.path() / "link").what, testing::HasSubstr("with itself"));
  fs::create_directories(folder_.path() / "empty");
  EXPECT_THAT(refused(folder_.path() / "empty").what, testing::HasSubstr("no catalogue.sqlite"));
  const fs::path damaged = folder_.path() / "damaged";
  fs::create_directories(damaged);
  ASSERT_TRUE(catalogue().backup(damaged / "catalogue.sqlite"));
  std::string bytes = bytesOf(damaged / "catalogue.sqlite");
  for (std::size_t i = 0; i < 64; ++i) bytes[bytes.size() / 2 + i] ^= 0x55;
  writeBytes(damaged / "catalogue.sqlite", bytes);
  EXPECT_EQ(refused(damaged).code, ErrorCode::Damaged);
}

TEST_F(MergingProjects, RefusesAnotherVersionsSchema) {
  for (const char* version : {"PRAGMA user_version = 99", "PRAGMA user_version = 0"}) {
    ASSERT_TRUE(
        b_.catalogue().database().asResult([&] { b_.catalogue().database().script(version); }));
    const std::string before = contentIn(*project_);
    EXPECT_FALSE(tried(*project_, b_, {})) << version;
    EXPECT_EQ(contentIn(*project_), before);
  }
}

TEST_F(MergingProjects, TakesBackWhatWouldNotBeWhole) {
  newSherd(b_, context12, false);
  const std::string before = contentIn(*project_);
  catalogue().database().script(
      "CREATE TEMP TRIGGER loses AFTER INSERT ON main.sherd_measure BEGIN DELETE FROM "
      "sherd_measure "
      "WHERE sherd = NEW.sherd; END");
  const Result<MergeReport> refused = tried(*project_, b_, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Failed);
  EXPECT_EQ(contentIn(*project_), before);
  catalogue().database().script("DROP TRIGGER loses");
  EXPECT_TRUE(merged(*project_, b_).entered);
}

TEST_F(MergingProjects, TakesBackWhatNoArchiveCouldRestore) {
  context("0077");
  catalogue().database().script(
      "UPDATE context SET note = CAST(x'410042' AS TEXT) WHERE number = '0077'");
  say(b_, rows[0], "note", "a handle");
  const std::string before = contentIn(*project_);
  const Result<MergeReport> refused = tried(*project_, b_, {});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().where, testing::HasSubstr("context.note"));
  EXPECT_EQ(contentIn(*project_), before);
}

TEST_F(MergingProjects, WhatWasCancelledChangedNothing) {
  say(b_, rows[0], "note", "a handle");
  records::BatchRecord fresh;
  ASSERT_TRUE(Batches(b_.catalogue()).add(fresh, anna));
  put(b_.folder() / "batches/B0002/front/cam0_pos00.jpg", "another");
  const std::string before = contentIn(*project_);
  std::stop_source stop;
  stop.request_stop();
  const Result<MergeReport> report =
      mergeInto(*project_, b_.folder(), MergeMode::Enter, {}, anna, quiet, stop.get_token());
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::Cancelled);
  EXPECT_EQ(contentIn(*project_), before);
  EXPECT_FALSE(fs::exists(project_->folder() / "merge.partial"));
  EXPECT_TRUE(merged(*project_, b_).entered);
}

}  // namespace
}  // namespace ostraka::merge
