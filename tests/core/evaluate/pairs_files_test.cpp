#include <gtest/gtest.h>

#include <fstream>

#include "evaluate/pairs.h"

namespace ostraka::evaluate {
namespace {

std::string written(const std::string& text) {
  const std::string path = testing::TempDir() + "pairs_files_test.json";
  std::ofstream(path) << text;
  return path;
}

const char* const kUnit = "[[1,0,0,5],[0,1,0,0],[0,0,1,0],[0,0,0,1]]";
const char* const kMirror = "[[-1,0,0,5],[0,1,0,0],[0,0,1,0],[0,0,0,1]]";

TEST(ReadProposal, NamesScansByTheStemOfTheirFile) {
  const auto proposal = readProposal(written(
      std::string(R"({"pairs":[{"front":"front/f01.ply","back":"b01","ambiguous":true,"score":0.5,
      "alternatives":[{"front":"f01","back":"back/b07.ply"}],"T_front_from_back":)") +
      kUnit + R"(}],"unpaired_front":["front/f02.ply"],"unpaired_back":[]})"));
  ASSERT_TRUE(proposal.has_value());
  const ProposedPair& pair = proposal->pairs.at(0);
  EXPECT_EQ(pair.front, "f01");
  EXPECT_EQ(pair.back, "b01");
  EXPECT_TRUE(pair.ambiguous);
  EXPECT_EQ(pair.score, 0.5);
  EXPECT_FALSE(pair.margin.has_value());
  EXPECT_EQ(pair.alternative_backs, std::vector<std::string>{"b07"});
  EXPECT_TRUE(pair.has_transform);
  EXPECT_EQ(pair.front_from_back.translation().x(), 5);
  EXPECT_EQ(proposal->unpaired_front, std::vector<std::string>{"f02"});
}

TEST(ReadProposal, KeepsAMirrorImageAsNotRigidAndRefusesWhatIsNoMatrix) {
  const auto mirrored = readProposal(written(
      std::string(R"({"pairs":[{"front":"f","back":"b","T_front_from_back":)") + kMirror + "}]}"));
  ASSERT_TRUE(mirrored.has_value());
  EXPECT_FALSE(mirrored->pairs[0].has_transform);
  EXPECT_TRUE(mirrored->pairs[0].transform_not_rigid);
  EXPECT_FALSE(
      readProposal(written(R"({"pairs":[{"front":"f","back":"b","T_front_from_back":[1,2,3]}]})"))
          .has_value());
  EXPECT_TRUE(
      readProposal(written(R"({"pairs":[{"front":"f","back":"b","T_front_from_back":null}]})"))
          .has_value());
}

TEST(ReadProposal, RefusesPairsWithoutFrontAndTextThatIsNoJson) {
  EXPECT_FALSE(readProposal(written(R"({"pairs":[{"back":"b"}]})")).has_value());
  EXPECT_FALSE(readProposal(written(R"({"pairs":3})")).has_value());
  EXPECT_FALSE(readProposal(written("[]")).has_value());
  EXPECT_FALSE(readProposal(written("{")).has_value());
  EXPECT_FALSE(readProposal("/nowhere/pairs.json").has_value());
}

TEST(ReadPairsTruth, RefusesATransformThatIsNotRigid) {
  EXPECT_TRUE(readPairsTruth(written(
      std::string(R"({"pairs":[{"front":"f","back":"b","T_front_from_back":)") + kUnit + "}]}")));
  EXPECT_FALSE(readPairsTruth(written(
      std::string(R"({"pairs":[{"front":"f","back":"b","T_front_from_back":)") + kMirror + "}]}")));
  EXPECT_FALSE(readPairsTruth(written(R"({"sherds":[]})")).has_value());
}

TEST(ReadPairsTruth, RefusesScansOutsideOfItsFolder) {
  for (const char* front : {"../f.ply", "/tmp/f.ply", "front/../../f.ply"})
    EXPECT_FALSE(readPairsTruth(written(std::string(R"({"pairs":[{"front":")") + front +
                                        R"(","back":"b","T_front_from_back":)" + kUnit + "}]}")))
        << front;
}

}  // namespace
}  // namespace ostraka::evaluate
