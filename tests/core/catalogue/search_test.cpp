#include "catalogue/search.h"

#include <gmock/gmock.h>

#include "small_project.h"

namespace ostraka::catalogue {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// In Turkish I is the capital of dotless i, and dotted I that of i.
TEST(Search, KnowsOneIAndNoCapitals) {
  EXPECT_EQ(searched("İznik ağızı"), "iznik ağizi");
  for (const char* word : {"İZNİK", "IZNIK", "iznik", "ıznık"})
    EXPECT_EQ(searchKey(word), searchKey("iznik")) << word;
  EXPECT_EQ(searchKey("ΧΕΊΛΟΣ"), searchKey("χείλος"));
  EXPECT_NE(searchKey("rim"), searchKey("ram"));
}

TEST(Search, CountsLettersNotBytes) {
  for (const char* word : {"", "a", "ab", "éé", "հս"}) EXPECT_TRUE(isShort(word)) << word;
  for (const char* word : {"abc", "ééé", "12."}) EXPECT_FALSE(isShort(word)) << word;
}

TEST(Search, TakesNumbersAndShortWordsAsWholeWordsOnly) {
  EXPECT_TRUE(hasWord("Cooking pot, rim", "pot"));
  EXPECT_TRUE(hasWord("pottery", "OTT"));
  EXPECT_FALSE(hasWord("pottery", "potter's"));
  EXPECT_TRUE(hasWord("bag 12, 1", "1"));
  EXPECT_FALSE(hasWord("bag 12", "1"));
  EXPECT_FALSE(hasWord("bag 4123", "123"));
  EXPECT_TRUE(hasWord("L.123.", "123"));
  EXPECT_TRUE(hasWord("T3-0012", "t3"));
  EXPECT_FALSE(hasWord("set3", "t3"));
  EXPECT_FALSE(hasWord("dé", "d")) << "é is a letter, too";
  EXPECT_FALSE(hasWord("éd", "d"));
  EXPECT_FALSE(hasWord("", "rim"));
}

class SearchedSherds : public SmallProject {};

TEST_F(SearchedSherds, AreFoundByWhatTheySayNow) {
  const store::SherdRow one = numbered(context12);
  numbered(context12);
  const std::string number = "ARM1-T3-0012-0001";
  const auto write = [&](const char* note) {
    catalogue().database().run("UPDATE sherd SET note = ? WHERE row = ?", note, one);
  };
  write("with a İznik glaze");
  EXPECT_THAT(found("glaze"), IsEmpty()) << "not before the search was told";
  searchAnew(catalogue().database(), one);
  EXPECT_THAT(found("glaze"), ElementsAre(number));
  EXPECT_THAT(found("IZNIK"), ElementsAre(number));
  write("plain");
  searchAnew(catalogue().database(), one);
  EXPECT_THAT(found("glaze"), IsEmpty());
  EXPECT_THAT(found("plain"), ElementsAre(number));
  EXPECT_TRUE(catalogue().checkIntegrity());
}

}  // namespace
}  // namespace ostraka::catalogue
