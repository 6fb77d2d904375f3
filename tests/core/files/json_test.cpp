#include "files/json.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "files/files.h"
#include "files/json_numbers.h"
#include "files/json_text.h"

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
  EXPECT_NE(value.error().what.english().find("line 3"), std::string::npos) << value.error().what;
}

// With the square of the length this took hours, and nothing stopped it.
TEST(ParseJson, TakesTimeInProportionToTheLengthOfAList) {
  for (const std::string one : {"{},", "[],", "{\"a\":1},"}) {
    std::string text = "[";
    for (int i = 0; i < 1'000'000; ++i) text += one;
    text.back() = ']';
    const auto begun = std::chrono::steady_clock::now();
    const Result<nlohmann::json> value = parseJson(text, "list.json");
    ASSERT_TRUE(value) << one;
    EXPECT_EQ(value->size(), 1'000'000u);
    EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(60)) << one;
  }
}

TEST(ParseJson, LimitsTheDepth) {
  const auto nested = [](int depth) {
    return std::string(static_cast<std::size_t>(depth), '[') +
           std::string(static_cast<std::size_t>(depth), ']');
  };
  EXPECT_TRUE(parseJson(nested(60), "x").has_value());
  const auto deep = parseJson(nested(100'000), "x");
  ASSERT_FALSE(deep.has_value());
  EXPECT_NE(deep.error().what.english().find("64"), std::string::npos);
}

TEST(ParseJson, RefusesAKeyThatOneObjectHasTwice) {
  for (const char* text :
       {R"({"unit":"mm","unit":"m"})", R"({"a":[{"b":{"unit":1,"c":2,"unit":1}}]})"}) {
    const auto value = parseJson(text, "plate.json");
    ASSERT_FALSE(value.has_value()) << text;
    EXPECT_NE(value.error().what.english().find("'unit' twice"), std::string::npos)
        << value.error().what;
    EXPECT_FALSE(parseOrderedJson(text, "plate.json").has_value()) << text;
    EXPECT_TRUE(jsonOrDiscarded(text).is_discarded());
    EXPECT_TRUE(orderedJsonOrDiscarded(text).is_discarded());
  }
  EXPECT_TRUE(parseJson(R"({"a":{"unit":1},"b":{"unit":1},"unit":[{"unit":1}]})", "x").has_value());
}

TEST(ParseOrderedJson, KeepsTheOrderOfKeys) {
  EXPECT_EQ(parseOrderedJson(R"({"z":1,"a":{"y":2,"b":3}})", "x")->dump(),
            R"({"z":1,"a":{"y":2,"b":3}})");
}

std::string refusal(const std::function<void()>& read) {
  try {
    read();
  } catch (const Json::exception& refused) {
    return unusableJson(refused, "something is missing", "board.json").what.english();
  }
  return "accepted";
}

TEST(JsonNumbers, WholeOnesAreReadWithinTheirRangeOnly) {
  const Json json = Json::parse(R"({"nine":9,"point":9.0,"half":9.5,"large":4294967305,
      "huge":18446744073709551615,"below":-1,"flag":true,"word":"9","none":null})");
  EXPECT_EQ(wholeAt(json, "nine", 2, 100), 9);
  EXPECT_EQ(wholeAt(json, "point", 2, 100), 9);
  EXPECT_EQ(wholeOr(json, "absent", 7), 7);
  for (const char* name : {"half", "large", "huge", "below", "flag", "word", "none"})
    EXPECT_EQ(refusal([&] { wholeAt(json, name, 2, 100); }),
              "'" + std::string(name) + "' must be a whole number from 2 to 100; correct it.");
  EXPECT_EQ(refusal([&] { wholeAt(json, "absent"); }), "something is missing");
  EXPECT_EQ(wholeIn(Json(INT64_MAX), "bytes", 0, INT64_MAX), INT64_MAX);
}

TEST(JsonNumbers, OthersAreFiniteAndWithinTheirRange) {
  const Json json = Json::parse(R"({"good":2.5,"whole":3,"far":1e300,"word":"2.5","flag":false})");
  EXPECT_EQ(numberAt(json, "good", 0, 10), 2.5);
  EXPECT_EQ(numberAt(json, "whole", 0, 10), 3);
  EXPECT_EQ(numberOr(json, "absent", 1.5), 1.5);
  for (const char* name : {"far", "word", "flag"})
    EXPECT_EQ(refusal([&] { numberAt(json, name, 0.5, 10); }),
              "'" + std::string(name) + "' must be a number from 0.5 to 10; correct it.");
  EXPECT_EQ(refusal([&] { numberAt(json, "word"); }), "'word' must be a number; correct it.");
  EXPECT_EQ(refusal([&] { numberIn(Json(NAN), "x"); }), "'x' must be a number; correct it.");
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

TEST(Isometry, RefusesAMoveBeyondItsReach) {
  const auto along = [](const char* x) {
    return Json::parse(std::string("[[1,0,0,") + x + "],[0,1,0,0],[0,0,1,0],[0,0,0,1]]");
  };
  EXPECT_TRUE(isometryFromJson(along("-1000000"), "x").has_value()) << "scans on a site's grid";
  for (const char* x : {"1000001", "-1e30", "1e300"})
    EXPECT_FALSE(isometryFromJson(along(x), "x").has_value()) << x;
  EXPECT_TRUE(isometryFromJson(along("20000"), "x", limits::kPoseReach_mm).has_value());
  EXPECT_FALSE(isometryFromJson(along("20001"), "x", limits::kPoseReach_mm).has_value());
}

}  // namespace
}  // namespace ostraka
