#include "exchange/other_version.h"

#include <gmock/gmock.h>

#include "sherds/measurements.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::exchange {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

records::Measurement taken(const char* kind, const char* unit, double value) {
  records::Measurement m;
  m.kind = kind;
  m.unit = unit;
  m.value = value;
  return m;
}

records::SherdRecord ours() {
  records::SherdRecord sherd;
  sherd.row.value = 7;
  sherd.number = "1";
  sherd.ware = "red";
  sherd.note = "burnt";
  sherd.extra_json = R"({"drawer": "7", "shelf": "B"})";
  sherd.measures = {{"length", 52}, {"weight", 23.4}};
  return sherd;
}

// As it would be written of ours.
tables::ImportRow sameRow() {
  tables::ImportRow row;
  row.values = {{"number", "1"},
                {"state", "draft"},
                {"ware", "red"},
                {"note", "burnt"},
                {"extra.drawer", "7"}};
  row.measured = {{taken("length", "mm", 52), "AP"}, {taken("weight", "g", 23.4), "AP"}};
  return row;
}

std::vector<std::string> keptOf(const tables::ImportRow& row) {
  std::vector<std::string> kept;
  for (const records::FieldChange& change : otherVersion(ours(), row, "dig_b")) {
    EXPECT_EQ(change.sherd.value, 7);
    kept.push_back(change.field + " = " + change.value);
  }
  return kept;
}

TEST(OtherVersion, OfTheSameRecordIsNone) {
  EXPECT_THAT(keptOf(sameRow()), IsEmpty()) << "the shelf is ours alone and stays";
}

TEST(OtherVersion, IsKeptBesideOursFieldByField) {
  tables::ImportRow row = sameRow();
  row.values["ware"] = "buff";
  row.values.erase("note");
  row.values["extra.drawer"] = "8";
  row.values["extra.box"] = "3";
  row.measured = {{taken("length", "mm", 52.5), "AP"}, {taken("width", "mm", 40), ""}};
  EXPECT_THAT(keptOf(row), testing::UnorderedElementsAre(
                               "extra.ware_in_dig_b = buff", "extra.note_in_dig_b = -",
                               "extra.length_in_dig_b = 52.5", "extra.width_in_dig_b = 40",
                               "extra.drawer_in_dig_b = 8", "extra.box_in_dig_b = 3"));
}

// Two laptops that read each other by turns would else add fields for ever.
TEST(OtherVersion, WhatTheOtherKeptOfOursIsNothingNew) {
  tables::ImportRow row = sameRow();
  row.values["extra.ware_in_dig_a"] = "red";
  row.values["extra.length_in_dig_a"] = "52";
  row.values["extra.shelf_in_dig_a"] = "B";
  row.values["extra.period_in_dig_a"] = "-";
  row.values["extra.note_in_dig_b"] = "what it kept under its own name";
  EXPECT_THAT(keptOf(row), IsEmpty());
  row.values["extra.ware_in_dig_a"] = "grey";  // ours was another then
  EXPECT_THAT(keptOf(row), ElementsAre("extra.ware_in_dig_a_in_dig_b = grey"));
}

class SameRecord : public catalogue::SmallProject {};

TEST_F(SameRecord, SaysTheSameOfEachFieldAndMeasurement) {
  const store::SherdRow row = numbered(context12);
  ASSERT_TRUE(set(row, "ware", "red"));
  ASSERT_TRUE(set(row, "extra.drawer", "7"));
  records::Measurement length = taken("length", "mm", 52);
  length.sherd = row;
  length.method = "calliper";
  ASSERT_TRUE(sherds::Measurements(catalogue()).add(length, anna));
  const records::SherdRecord sherd = *sherds::Sherds(catalogue()).get(row);
  tables::ImportRow same;
  for (const records::SherdField& field : sherds::sherdFields())
    same.values[field.name] = sherds::textOf(sherd, field.name);
  same.measured = {{length, "AP"}};
  const auto isSame = [&](const tables::ImportRow& other) {
    return sameAs(sherd, other, "dig_b", catalogue());
  };
  EXPECT_TRUE(isSame(same));
  tables::ImportRow other = same;
  other.values["state"] = "void";
  other.values["batch"] = "B0077";
  EXPECT_TRUE(isSame(other)) << "what each project counts for itself";
  other = same;
  other.values.erase("ware");
  EXPECT_FALSE(isSame(other));
  other = same;
  other.values["extra.drawer"] = "8";
  EXPECT_FALSE(isSame(other));
  other = same;
  other.measured[0].first.value = 53;
  EXPECT_FALSE(isSame(other));
  other.measured.clear();
  EXPECT_FALSE(isSame(other)) << "one measurement less";
}

}  // namespace
}  // namespace ostraka::exchange
