#include <gmock/gmock.h>

#include "catalogue/settings.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/numbers.h"
#include "sherds/sherds.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::sherds {
namespace {

using testing::ElementsAre;
using NumbersTest = catalogue::SmallProject;

TEST_F(NumbersTest, AreProposedPerContextAndGivenInTheSameOrder) {
  const std::vector<store::SherdRow> rows = {draft(context12), draft(context13), draft(context12)};
  const auto expected = ElementsAre("ARM1-T3-0012-0001", "ARM1-T3-0013-0001", "ARM1-T3-0012-0002");
  EXPECT_THAT(*Numbers(catalogue()).propose(rows), expected);
  EXPECT_THAT(*Numbers(catalogue()).propose(rows), expected) << "a proposal reserves nothing";
  EXPECT_THAT(*Numbers(catalogue()).assign(rows, anna), expected);
  EXPECT_EQ(Sherds(catalogue()).get(rows[2])->state, records::SherdState::Numbered);
}

TEST_F(NumbersTest, AreNeverUsedAgain) {
  const store::SherdRow a = numbered(context12), b = draft(context12);
  ASSERT_TRUE(set(a, "number", "OLD-7"));
  const Result<std::vector<records::FieldChange>> taken = set(b, "number", "ARM1-T3-0012-0001");
  ASSERT_FALSE(taken);
  EXPECT_NE(taken.error().what.english().find("assigned before"), std::string::npos);
  EXPECT_THAT(*Numbers(catalogue()).assign(std::span(&b, 1), anna),
              ElementsAre("ARM1-T3-0012-0002"));
  ASSERT_TRUE(Sherds(catalogue()).voidSherd(b, "a stone", anna));
  EXPECT_THAT(*Numbers(catalogue()).propose(std::vector{draft(context12)}),
              ElementsAre("ARM1-T3-0012-0003"));
}

TEST_F(NumbersTest, DifferOnlyIfTheyDifferForPeopleAndForFiles) {
  const store::SherdRow a = draft(context12), b = draft(context12);
  ASSERT_TRUE(set(a, "number", "É-1"));
  EXPECT_FALSE(set(b, "number", "é-1"));
  EXPECT_FALSE(set(b, "number", "E\xCC\x81-1"));
  ASSERT_TRUE(set(a, "number", "A/1"));
  const Result<std::vector<records::FieldChange>> same_file = set(b, "number", "A_1");
  ASSERT_FALSE(same_file);
  EXPECT_NE(same_file.error().what.english().find("same names as those of A/1"), std::string::npos);
}

TEST_F(NumbersTest, ThatPeopleReadAsOneAreDoubted) {
  const store::SherdRow a = draft(context12), b = draft(context12);
  ASSERT_TRUE(set(a, "number", "K-0007"));
  EXPECT_THAT(*Numbers(catalogue()).similar(b, "k/7"), ElementsAre("K-0007"));
  EXPECT_EQ(*Numbers(catalogue()).doubt({}, "K 007"),
            "The number K 007 differs from the existing number K-0007 only in zeros, "
            "letter case or punctuation; check which one is meant.");
  EXPECT_THAT(*Numbers(catalogue()).similar(a, "k/7"), ElementsAre()) << "its own";
  for (const char* other : {"K-0007", "k-0007", "K-70", "K-7a", "K-7.0", ""})
    EXPECT_TRUE(Numbers(catalogue()).doubt(b, other)->empty()) << other;
  // A spreadsheet that takes a number for one of a measure writes it so.
  ASSERT_TRUE(set(a, "number", "12"));
  for (const char* other : {"12.0", "12,0", "0012.0"})
    EXPECT_THAT(*Numbers(catalogue()).similar(b, other), ElementsAre("12")) << other;
  EXPECT_THAT(*Numbers(catalogue()).similar(b, "12/0"), ElementsAre());
  ASSERT_TRUE(set(a, "number", "13.0"));
  EXPECT_THAT(*Numbers(catalogue()).similar(b, "13"), ElementsAre("13.0"));
}

TEST_F(NumbersTest, HaveNoLettersThatNobodySees) {
  const store::SherdRow sherd = draft(context12);
  EXPECT_FALSE(set(sherd, "number", "A\u202E1"));
  EXPECT_FALSE(set(sherd, "number", "A1\uFEFF"));
  EXPECT_TRUE(set(sherd, "number", "A1"));
}

TEST_F(NumbersTest, TypedByHandInTheSchemesFormAreCounted) {
  const store::SherdRow a = draft(context12);
  ASSERT_TRUE(set(a, "number", "ARM1-T3-0012-0041"));
  EXPECT_THAT(*Numbers(catalogue()).propose(std::vector{draft(context12)}),
              ElementsAre("ARM1-T3-0012-0042"));
  std::vector<int> gaps = *Numbers(catalogue()).gaps(context12);
  ASSERT_EQ(gaps.size(), 40u);
  EXPECT_EQ(gaps.front(), 1);
  EXPECT_EQ(gaps.back(), 40);
}

// T3 and t3 are one trench, K 12 and K12 one context: what is written on the sherds of a place
// counts there, in whichever spelling, and the next one has the place's own.
TEST_F(NumbersTest, CountByThePlaceWhateverItsSpelling) {
  ASSERT_TRUE(set(draft(context12), "number", "arm1-t3-0012-0020"));
  ASSERT_TRUE(set(draft(context12), "number", "ARM1-T3-0012-0018"));
  EXPECT_THAT(*Numbers(catalogue()).propose(std::vector{draft(context12)}),
              ElementsAre("ARM1-T3-0012-0021"));
  const auto scheme = *records::Numbering::parse("{site}-{trench}-{context}-{n:04}");
  EXPECT_EQ(*Numbers(catalogue())
                 .next(scheme, {{"site", "Arm1"}, {"trench", "t3"}, {"context", "0012"}}, context12,
                       1, 999),
            21);
  std::vector<int> gaps = *Numbers(catalogue()).gaps(context12);
  ASSERT_EQ(gaps.size(), 18u) << "1 to 17 and 19";
  EXPECT_EQ(gaps[16], 17);
  EXPECT_EQ(gaps[17], 19);
  for (const auto& [place, typed, next] :
       {std::tuple("K 12", "ARM1-T3-k12-7", "ARM1-T3-K 12-0008"),
        std::tuple("K\u00A014", "ARM1-T3-K\u00A014-7", "ARM1-T3-K\u00A014-0008"),
        std::tuple("Ü13", "arm1-t3-ü 13-0041", "ARM1-T3-Ü13-0042")}) {
    const store::ContextRow other = context(place);
    ASSERT_TRUE(set(draft(other), "number", typed));
    EXPECT_THAT(*Numbers(catalogue()).propose(std::vector{draft(other)}), ElementsAre(next));
  }
}

TEST_F(NumbersTest, CountWhereTheyNameThePlaceAlthoughTheSherdWasElsewhere) {
  const store::SherdRow misplaced = draft(context13);
  ASSERT_TRUE(set(misplaced, "number", "ARM1-T3-0012-0005"));
  ASSERT_TRUE(set(misplaced, "context", "0012"));
  EXPECT_THAT(*Numbers(catalogue()).propose(std::vector{draft(context12), draft(context13)}),
              ElementsAre("ARM1-T3-0012-0006", "ARM1-T3-0013-0001"));
}

TEST_F(NumbersTest, UndoneComeBackToTheSameSherd) {
  const store::SherdRow a = draft(context12), b = draft(context12);
  ASSERT_TRUE(Numbers(catalogue()).assign(std::span(&a, 1), anna));
  ASSERT_TRUE(set(a, "number", ""));
  EXPECT_EQ(Sherds(catalogue()).get(a)->state, records::SherdState::Draft);
  EXPECT_THAT(*Numbers(catalogue()).assign(std::span(&b, 1), anna),
              ElementsAre("ARM1-T3-0012-0002"));
  EXPECT_THAT(*Numbers(catalogue()).assign(std::span(&a, 1), anna),
              ElementsAre("ARM1-T3-0012-0001"));
}

TEST_F(NumbersTest, OfTwoComputersComeFromTwoBlocks) {
  ASSERT_TRUE(catalogue::Settings(catalogue()).setValue("numbering.first", "5001"));
  ASSERT_TRUE(catalogue::Settings(catalogue()).setValue("numbering.last", "5002"));
  const std::vector<store::SherdRow> two = {draft(context12), draft(context12)};
  EXPECT_THAT(*Numbers(catalogue()).assign(two, anna),
              ElementsAre("ARM1-T3-0012-5001", "ARM1-T3-0012-5002"));
  ASSERT_TRUE(set(draft(context12), "number", "ARM1-T3-0012-0007"));
  ASSERT_TRUE(set(draft(context12), "number", "ARM1-T3-0012-9000"));
  EXPECT_THAT(*Numbers(catalogue()).gaps(context12), ElementsAre()) << "of other computers";
  const Result<std::vector<std::string>> none =
      Numbers(catalogue()).propose(std::vector{draft(context12)});
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().what.english().find("block of numbers up to 5002 is used up"),
            std::string::npos);
}

// 0012 and 12 are two contexts, whose sherds nobody could tell apart by 0001.
TEST_F(NumbersTest, AreSimilarToNoneOfAnotherSherd) {
  numbered(context12);
  numbered(context12);
  const store::ContextRow twelve = context("12");
  const std::vector<store::SherdRow> rows = {draft(twelve), draft(twelve)};
  EXPECT_THAT(*Numbers(catalogue()).propose(rows),
              ElementsAre("ARM1-T3-12-0003", "ARM1-T3-12-0004"));
  const std::vector<store::SherdRow> both = {draft(twelve), draft(context12)};
  EXPECT_THAT(*Numbers(catalogue()).propose(both),
              ElementsAre("ARM1-T3-12-0003", "ARM1-T3-0012-0004"));
}

TEST_F(NumbersTest, ComeFromNoBlockThatIsNone) {
  const store::SherdRow a = draft(context12);
  for (const char* key : {"numbering.first", "numbering.last"}) {
    for (const char* text : {"5000000000", "-5", "0", "1e300", "1.5", "x"}) {
      ASSERT_TRUE(catalogue::Settings(catalogue()).setValue(key, text));
      const auto refused = Numbers(catalogue()).propose(std::span(&a, 1));
      ASSERT_FALSE(refused) << key << text;
      EXPECT_NE(refused.error().what.english().find("'" + std::string(text) + "'"),
                std::string::npos);
      EXPECT_FALSE(numberBlock(catalogue()));
    }
    ASSERT_TRUE(catalogue::Settings(catalogue()).setValue(key, "7"));
  }
  EXPECT_THAT(*Numbers(catalogue()).propose(std::span(&a, 1)), ElementsAre("ARM1-T3-0012-0007"));
}

TEST_F(NumbersTest, NeedThePlaceThatTheSchemeNames) {
  const Result<std::vector<std::string>> none =
      Numbers(catalogue()).propose(std::vector{draft({})});
  ASSERT_FALSE(none);
  records::ProjectRecord record = *catalogue::Settings(catalogue()).project();
  record.numbering = "P{yyyy}.{n:05}";
  ASSERT_TRUE(catalogue::Settings(catalogue()).setProject(record, anna));
  EXPECT_THAT(*Numbers(catalogue()).propose(std::vector{draft(context12)}),
              ElementsAre("P2026.00001"));
}

// No trench can be missing where there is none; in a site with trenches it was forgotten.
TEST_F(NumbersTest, LeaveOutTheTrenchInASiteWithoutTrenches) {
  const auto contextIn = [&](store::SiteRow of, const char* number) {
    records::ContextRecord record;
    record.site = of;
    record.number = number;
    return *catalogue::Places(catalogue()).save(record, anna);
  };
  records::SiteRecord open;
  open.code = "GRB";
  const store::ContextRow k12 = contextIn(*catalogue::Places(catalogue()).save(open, anna), "K12");
  EXPECT_THAT(*Numbers(catalogue()).assign(std::vector{draft(k12)}, anna),
              ElementsAre("GRB-K12-0001"));
  EXPECT_THAT(*Numbers(catalogue()).propose(std::vector{draft(k12)}), ElementsAre("GRB-K12-0002"));
  const auto forgotten = Numbers(catalogue()).propose(std::vector{draft(contextIn(site, "0099"))});
  ASSERT_FALSE(forgotten);
  EXPECT_NE(forgotten.error().what.english().find("in the settings"), std::string::npos);
}

TEST_F(NumbersTest, FollowAChangedSchemeAndNeverDouble) {
  const store::SherdRow first = numbered(context12), second = numbered(context12);
  records::ProjectRecord record = *catalogue::Settings(catalogue()).project();
  record.numbering = "{site}-{trench}-{context}-{n:02}";
  ASSERT_TRUE(catalogue::Settings(catalogue()).setProject(record, anna));
  const store::SherdRow narrow = numbered(context12);
  EXPECT_EQ(valueOf(narrow, "number"), "ARM1-T3-0012-03") << "the same count, another width";
  record.numbering = "{context}/{n}";
  ASSERT_TRUE(catalogue::Settings(catalogue()).setProject(record, anna));
  // Typed by hand before in what is now the scheme's form, and once more by its file's name.
  const store::SherdRow typed = draft(context13), other = draft(context13);
  ASSERT_TRUE(set(typed, "number", "0012/1"));
  ASSERT_TRUE(set(other, "number", "0012_2"));
  const store::SherdRow third = numbered(context12);
  EXPECT_EQ(valueOf(third, "number"), "0012/3");
  EXPECT_EQ(valueOf(first, "number"), "ARM1-T3-0012-0001") << "what was numbered stays";
  EXPECT_EQ(valueOf(second, "number"), "ARM1-T3-0012-0002");
  record.numbering = "{site}-{trench}-{context}-{n:04}";
  ASSERT_TRUE(catalogue::Settings(catalogue()).setProject(record, anna));
  EXPECT_EQ(valueOf(numbered(context12), "number"), "ARM1-T3-0012-0004") << "back again";
  EXPECT_TRUE(catalogue().checkIntegrity());
}

TEST_F(NumbersTest, GivenByTwoConnectionsAtOnceAreStillDifferent) {
  catalogue::Catalogue other = *upkeep::Project::connect(project_->folder());
  const store::SherdRow a = draft(context12), b = draft(context12);
  EXPECT_EQ(Numbers(catalogue()).propose(std::span(&a, 1))->front(),
            Numbers(other).propose(std::span(&b, 1))->front());
  EXPECT_NE(Numbers(catalogue()).assign(std::span(&a, 1), anna)->front(),
            Numbers(other).assign(std::span(&b, 1), anna)->front());
}

}  // namespace
}  // namespace ostraka::sherds
