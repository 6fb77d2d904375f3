#include "base/json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/files.h"

namespace ostraka {
namespace {

using Json = nlohmann::json;

TEST(ParseJson, RefusesWhatIsNoJsonWithTheFilesName) {
  for (const char* text : {"", "{", "[1,]", "nan", "{\"a\":1}x", "\"\xff\"", "1e999"}) {
    const auto value = parseJson(text, "plate.json");
    ASSERT_FALSE(value.has_value()) << text;
    EXPECT_EQ(value.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(value.error().where, "plate.json");
  }
  EXPECT_TRUE(parseJson("{\"a\":[1,2.5,null]}", "x").has_value());
}

TEST(ParseJson, NamesTheLineThatIsWrong) {
  const auto value = parseJson("{\n \"a\": 1,\n \"b\": ]\n}\n", "plate.json");
  ASSERT_FALSE(value.has_value());
  EXPECT_NE(value.error().what.find("line 3"), std::string::npos) << value.error().what;
}

TEST(ParseJson, LimitsTheDepth) {
  const auto nested = [](int depth) {
    return std::string(static_cast<std::size_t>(depth), '[') +
           std::string(static_cast<std::size_t>(depth), ']');
  };
  EXPECT_TRUE(parseJson(nested(60), "x").has_value());
  const auto deep = parseJson(nested(100'000), "x");
  ASSERT_FALSE(deep.has_value());
  EXPECT_NE(deep.error().what.find("64"), std::string::npos);
}

TEST(WriteJson, KeepsTheOrderOfKeysAndEndsWithALine) {
  const std::string path = testing::TempDir() + "ostraka_json_test.json";
  ASSERT_TRUE(writeJson(path, {{"z", 1}, {"a", "\xff"}}).has_value()) << "bad UTF-8 is replaced";
  const std::string text = *readFile(path);
  EXPECT_LT(text.find("\"z\""), text.find("\"a\""));
  EXPECT_EQ(text.back(), '\n');
  EXPECT_TRUE(readJson(path).has_value());
}

TEST(Isometry, ComesBackFromJsonNestedOrFlat) {
  Eigen::Isometry3d pose = Eigen::Translation3d(1, -2, 3.5) *
                           Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()) *
                           Eigen::Isometry3d::Identity();
  const Json nested = Json::parse(toJson(pose).dump());
  Json flat = Json::array();
  for (const Json& row : nested)
    for (const Json& number : row) flat.push_back(number);
  for (const Json& value : {nested, flat}) {
    const auto back = isometryFromJson(value, "x");
    ASSERT_TRUE(back.has_value());
    EXPECT_LT((back->matrix() - pose.matrix()).cwiseAbs().maxCoeff(), 1e-15);
  }
}

TEST(Isometry, RefusesWhatIsNotRigidOrNoMatrix) {
  const char* const bad[] = {
      "[]",
      "null",
      "[[1,0,0,0],[0,1,0,0],[0,0,1,0]]",
      "[[-1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]",     // a mirror image
      "[[1.01,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]",   // scaled
      "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0.1,1]]",    // a last row that is none
      "[[1,0,0,\"a\"],[0,1,0,0],[0,0,1,0],[0,0,0,1]]",  // a word
      "[[1,0,0,[5]],[0,1,0,0],[0,0,1,0],[0,0,0,1]]"};   // a list in a list
  for (const char* text : bad) EXPECT_FALSE(isometryFromJson(Json::parse(text), "x")) << text;
}

}  // namespace
}  // namespace ostraka
