#include "metadata/metadata.h"

#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>

#include "tests/core/catalogue/small_project.h"

namespace ostraka::metadata {
namespace {

using testing::HasSubstr;
using testing::Not;

class Metadata : public catalogue::SmallProject {
 protected:
  // Texts by the paths of their files.
  std::map<std::string, std::string> of(const std::vector<store::SherdRow>& rows,
                                        const std::vector<archive::BagFile>& files = {},
                                        const std::vector<std::string>& without_model = {}) {
    const auto sherds = catalogue::valueIn(sherds::Sherds(catalogue()).of(rows));
    std::map<std::string, std::string> texts;
    for (const MetadataFile& file : catalogue::valueIn(
             metadataOf(catalogue(), sherds, {}, "ostraka 1.0.0", {files, without_model})))
      texts[file.path] = file.text;
    return texts;
  }
};

TEST_F(Metadata, ASitesPlaceTravelsOnlyWhereItIsPublic) {
  records::SiteRecord hill = catalogue::Places(catalogue()).sites()->front();
  hill.latitude_deg = 40.25;
  hill.longitude_deg = 44.5;
  ASSERT_TRUE(catalogue::Places(catalogue()).save(hill, anna));
  const store::SherdRow sherd = numbered(context12);
  const auto hidden = of({sherd})["metadata/places.json"];
  EXPECT_THAT(hidden, HasSubstr("ARM1"));
  EXPECT_THAT(hidden, Not(HasSubstr("40.25")));
  EXPECT_THAT(hidden, Not(HasSubstr("44.5")));
  hill.location_public = true;
  ASSERT_TRUE(catalogue::Places(catalogue()).save(hill, anna));
  const auto shown = of({sherd})["metadata/places.json"];
  EXPECT_THAT(shown, HasSubstr("40.25"));
  EXPECT_THAT(shown, HasSubstr("44.5"));
}

TEST_F(Metadata, TellsOfTheContextsOfTheSherdsAloneUnlessTheyAreAll) {
  const store::SherdRow in12 = numbered(context12), also12 = numbered(context12);
  const auto contextsIn = [](const std::string& text) {
    std::vector<std::string> numbers;
    const nlohmann::json places = nlohmann::json::parse(text);
    for (const nlohmann::json& one : places.at("contexts")) numbers.push_back(one.at("number"));
    return numbers;
  };
  EXPECT_THAT(contextsIn(of({in12})["metadata/places.json"]), testing::ElementsAre("0012"));
  EXPECT_THAT(contextsIn(of({in12, also12})["metadata/places.json"]),
              testing::ElementsAre("0012", "0013"))
      << "a whole project tells where nothing was found";
}

TEST_F(Metadata, TheReadMeListsWhatLiesThereAndWhatIsMissing) {
  const store::SherdRow sherd = numbered(context12);
  const std::string models = of({sherd}, {{"data/models/a.ply", "", 1}}, {"K-7"})["README.txt"];
  EXPECT_THAT(models, HasSubstr("models/*.ply"));
  EXPECT_THAT(models, HasSubstr("metadata/ "));
  EXPECT_THAT(models, Not(HasSubstr("models/*.glb")));
  EXPECT_THAT(models, Not(HasSubstr("sherds.csv")));
  EXPECT_THAT(models, HasSubstr("Sherds without a model\n----------------------\nK-7\n"));
  const std::string table = of({sherd}, {{"data/sherds.csv", "", 1}})["README.txt"];
  EXPECT_THAT(table, HasSubstr("sherds.csv       one row per sherd"));
  EXPECT_THAT(table, HasSubstr("has one ' before it"));
  EXPECT_THAT(table, Not(HasSubstr("without a model")));
}

}  // namespace
}  // namespace ostraka::metadata
