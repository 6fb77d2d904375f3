#include "metadata/json_fields.h"

#include <gtest/gtest.h>

#include <limits>

namespace ostraka::metadata {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

TEST(JsonFields, WhatIsEmptyFalseOrNoneIsLeftOutUnlessItAlwaysStandsThere) {
  ordered_json written;
  Ids ids;
  ids[store::SiteRow{3}] = "a-site";
  PutFields fields{written, ids};
  fields("note", std::string());
  fields("ambiguous", false);
  fields("score", std::optional<double>());
  fields("site", store::SiteRow());
  fields.inner("extra", "{}");
  fields.inner("broken", "{not json");
  EXPECT_EQ(written.dump(), "null") << "an object without any";
  fields.always("name", std::string());
  fields.always("side", 'f');
  fields("ambiguous", true);
  fields("score", std::optional(0.0));
  fields("site", store::SiteRow{3});
  fields.inner("extra", R"({"z":1,"a":[]})");
  EXPECT_EQ(written.dump(), R"({"name":"","side":"f","ambiguous":true,"score":0.0,"site":"a-site",)"
                            R"("extra":{"z":1,"a":[]}})");
}

TEST(JsonFields, AreReadAsTheyAreWritten) {
  const json object = json::parse(
      R"({"name":"rim","side":"back","used":true,"angle_deg":12,"count":3,"site":"a-site",)"
      R"("trench":"elsewhere","extra":{"z":1}})");
  const RowsById rows = {{"a-site", 3}};
  TakenFields fields{object, rows};
  std::string name, missing = "before", extra;
  char side = '?', no_side = '?';
  bool used = false, unsaid = true;
  std::optional<double> angle, none;
  int count = 0;
  store::SiteRow site;
  store::TrenchRow trench{7};
  fields.always("name", name);
  fields("missing", missing);
  fields.always("side", side);
  fields.always("missing", no_side);
  fields("used", used);
  fields("missing", unsaid);
  fields("angle_deg", angle);
  fields("missing", none);
  fields.always("count", count);
  fields("site", site);
  fields("trench", trench);
  fields.inner("extra", extra);
  EXPECT_EQ(name, "rim");
  EXPECT_EQ(missing, "");
  EXPECT_EQ(side, 'b');
  EXPECT_EQ(no_side, '?');
  EXPECT_TRUE(used);
  EXPECT_TRUE(unsaid);
  EXPECT_EQ(angle, 12);
  EXPECT_FALSE(none);
  EXPECT_EQ(count, 3);
  EXPECT_EQ(site, store::SiteRow{3});
  EXPECT_FALSE(trench) << "an id that did not enter names no row of this catalogue";
  EXPECT_EQ(extra, R"({"z":1})");
}

TEST(JsonFields, OfAnotherTypeAreRefused) {
  const json object = json::parse(R"({"count":1.5,"bytes":-1,"name":7})");
  const RowsById none;
  TakenFields fields{object, none};
  int count = 0;
  std::int64_t bytes = 0;
  std::string name;
  EXPECT_THROW(fields.always("count", count), json::exception);
  EXPECT_THROW(fields.always("bytes", bytes), json::exception);
  EXPECT_THROW(fields.always("missing", bytes), json::exception);
  EXPECT_THROW(fields.always("name", name), json::exception);
}

TEST(JsonFields, ATextThatNoFileCanHoldIsNamedByItsPlace) {
  const auto whereOf = [](const ordered_json& value) {
    const Result<std::string> text = jsonText(value, "metadata/places.json");
    return text ? *text : text.error().where;
  };
  EXPECT_EQ(whereOf({{"sites", {{{"name", "ok"}}, {{"name", "\xFF"}}}}}),
            "metadata/places.json/sites/1/name");
  EXPECT_EQ(whereOf({{"weight", std::numeric_limits<double>::infinity()}}),
            "metadata/places.json/weight");
  EXPECT_EQ(whereOf({{"a", 1}}), "{\n \"a\": 1\n}");
}

TEST(JsonFields, OfAStrangerHoldOnlyTextsThatTheCatalogueCouldHaveWritten) {
  EXPECT_EQ(parseFields(R"({"a":[{"b":"x\u001b[2J"}]})", "x.json").error().where, "x.json/a/0/b");
  EXPECT_EQ(parseFields(R"({"a\u0000":1})", "x.json").error().code, ErrorCode::UnusableInput);
  EXPECT_FALSE(parseFields("{", "x.json"));
  ASSERT_TRUE(parseFields(R"({"a":"two\nlines"})", "x.json"));
}

}  // namespace
}  // namespace ostraka::metadata
