#include "metadata/vocabularies.h"

#include <gmock/gmock.h>

#include "catalogue/history.h"
#include "catalogue/settings.h"
#include "exported_project.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;
using namespace catalogue;

class Vocabularies : public ExportedProject {
 protected:
  Vocabularies() {
    auto terms = valueIn(Settings(catalogue()).vocabulary("decoration"));
    terms.push_back({"perforated", {{"de", "durchlocht"}, {"fr", "perforé"}}, "http://x.org/1"});
    terms.push_back({"never used", {}, {}});
    EXPECT_TRUE(Settings(catalogue()).setVocabulary("decoration", terms, anna));
    EXPECT_TRUE(set(rows[0], "decoration", "perforated"));
    EXPECT_TRUE(exportTo("out", {Form::Json}));
    records::ProjectRecord record;
    record.code = "ARM";
    other.emplace(valueIn(upkeep::Project::create(folder_.path() / "other", record)));
  }
  tables::ImportReport read(tables::ImportMode mode = tables::ImportMode::Enter) {
    return valueIn(readBack(*other, folder_.path() / "out", mode, {}, quiet, {}));
  }
  const records::Term* term(const std::string& name) {
    words = valueIn(Settings(other->catalogue()).vocabulary("decoration"));
    for (const records::Term& one : words)
      if (one.term == name) return &one;
    return nullptr;
  }
  std::string decoration() {
    const store::SherdRow row =
        *sherds::Sherds(other->catalogue()).byId(sherds::Sherds(catalogue()).get(rows[0])->id);
    return row ? sherds::textOf(*sherds::Sherds(other->catalogue()).get(row), "decoration")
               : "not there";
  }
  std::optional<upkeep::Project> other;
  std::vector<records::Term> words;
};

TEST_F(Vocabularies, BringTheirUsedTermsAlongWithLabelsAndUri) {
  EXPECT_EQ(read(tables::ImportMode::Preview).fresh, 3);
  EXPECT_EQ(term("perforated"), nullptr) << "a preview changes nothing";
  EXPECT_EQ(read().fresh, 3);
  EXPECT_EQ(decoration(), "perforated");
  ASSERT_NE(term("perforated"), nullptr);
  EXPECT_THAT(term("perforated")->labels, testing::ElementsAre(testing::Pair("de", "durchlocht"),
                                                               testing::Pair("fr", "perforé")));
  EXPECT_EQ(term("perforated")->uri, "http://x.org/1");
  EXPECT_EQ(term("never used"), nullptr);
  const std::int64_t history = History(other->catalogue()).length();
  EXPECT_EQ(read().same, 3);
  EXPECT_EQ(History(other->catalogue()).length(), history);
}

TEST_F(Vocabularies, LeaveTheProjectsTermsAsTheyAre) {
  auto own = valueIn(Settings(other->catalogue()).vocabulary("decoration"));
  own.push_back({"pierced", {{"en", "Perforated"}}, {}});
  ASSERT_TRUE(Settings(other->catalogue()).setVocabulary("decoration", own, {}));
  EXPECT_EQ(read().fresh, 3);
  EXPECT_EQ(decoration(), "pierced") << "that is what the word means here";
  EXPECT_EQ(valueIn(Settings(other->catalogue()).vocabulary("decoration")).size(), own.size());
}

TEST_F(Vocabularies, AreInTheManifest) {
  const fs::path file = folder_.path() / "out/data/metadata/vocabularies.json";
  put(file, *readFile(file) + " ");
  EXPECT_FALSE(readBack(*other, folder_.path() / "out", tables::ImportMode::Enter, {}, quiet, {}));
}

}  // namespace
}  // namespace ostraka::exchange
