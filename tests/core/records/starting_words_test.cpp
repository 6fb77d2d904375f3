#include "records/starting_words.h"

#include <gtest/gtest.h>

#include <set>

namespace ostraka::records {
namespace {

TEST(StartingVocabularies, HaveEachTermOnceWithAWordInEveryLanguage) {
  std::set<std::string> names;
  for (const StartingVocabulary& vocabulary : startingVocabularies()) {
    EXPECT_TRUE(names.insert(vocabulary.name).second) << vocabulary.name;
    std::set<std::string> terms;
    for (const Term& term : vocabulary.terms) {
      EXPECT_TRUE(terms.insert(term.term).second) << vocabulary.name << ": " << term.term;
      for (const char* language : {"de", "el", "es", "fr", "hy", "tr"}) {
        const auto word = term.labels.find(language);
        EXPECT_TRUE(word != term.labels.end() && !word->second.empty())
            << vocabulary.name << ": " << term.term << " in " << language;
      }
    }
    EXPECT_GE(terms.size(), 2u) << vocabulary.name << ": nothing to choose from";
  }
  for (const char* name : {"part", "surface", "decoration", "firing", "condition"})
    EXPECT_TRUE(names.contains(name)) << name;
}

}  // namespace
}  // namespace ostraka::records
