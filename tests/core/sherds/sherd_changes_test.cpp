#include <gmock/gmock.h>

#include "catalogue/history.h"
#include "records/sherd.h"
#include "sherds/many_changes.h"
#include "sherds/measurements.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::sherds {
namespace {

using Changes = catalogue::SmallProject;

TEST_F(Changes, AreAllOrNothing) {
  const store::SherdRow a = numbered(context12), b = numbered(context12);
  const std::vector<records::FieldChange> changes = {{a, "ware", "grey"}, {b, "part", "wing"}};
  const Result<std::vector<records::FieldChange>> done =
      SherdChanges(catalogue()).apply(changes, anna);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().where, "ARM1-T3-0012-0002") << "the sherd that it is about";
  EXPECT_NE(done.error().what.english().find("'wing' is not a term; choose one of rim, "),
            std::string::npos);
  EXPECT_EQ(done.error().what.values().at(1).translations.at("de"),
            "Rand, Hals, Schulter, Wandung, Boden, Henkel, Ausguss, Deckel, \u2026");
  EXPECT_EQ(valueOf(a, "ware"), "");
}

TEST_F(Changes, ThePreviewShowsWhatWouldBeAndWhatIsRefused) {
  const store::SherdRow a = numbered(context12), b = numbered(context12);
  const std::vector<records::FieldChange> changes = {
      {a, "part", " RIM ; neck"},         {b, "munsell_out", "brown"}, {b, "length_mm", "61,42"},
      {b, "number", "ARM1-T3-0012-0001"}, {b, "area_mm2", "5"},        {b, "colour", "red"}};
  const std::vector<records::ChangePreview> shown = *SherdChanges(catalogue()).preview(changes);
  ASSERT_EQ(shown.size(), 6u);
  EXPECT_EQ(shown[0].new_value, "rim; neck");
  EXPECT_EQ(shown[0].refusal, "");
  EXPECT_NE(shown[1].refusal.english().find("10YR 3/1"), std::string::npos);
  EXPECT_EQ(shown[2].new_value, "61.42");
  EXPECT_NE(shown[3].refusal.english().find("belongs to another sherd"), std::string::npos);
  EXPECT_EQ(shown[3].in_the_way, a);
  EXPECT_NE(shown[4].refusal.english().find("the program sets it"), std::string::npos);
  EXPECT_NE(shown[5].refusal.english().find("no field 'colour'"), std::string::npos);
  EXPECT_EQ(valueOf(a, "part"), "") << "a preview changes nothing";
}

TEST_F(Changes, CanBeUndoneAndDoneAgainWithTheirHistory) {
  const store::SherdRow a = numbered(context12), b = draft(context12, bag4);
  const std::vector<records::FieldChange> changes = {{a, "ware", "grey"},
                                                     {a, "part", "rim"},
                                                     {b, "context", "0013"},
                                                     {b, "bag", "1"},
                                                     {b, "joins", "ARM1-T3-0012-0001"},
                                                     {a, "weight_g", "23.4"},
                                                     {b, "extra.drawer", "7"},
                                                     {b, "number", "X-1"}};
  const auto before_a = *Sherds(catalogue()).get(a), before_b = *Sherds(catalogue()).get(b);
  const Result<std::vector<records::FieldChange>> undo =
      SherdChanges(catalogue()).apply(changes, anna);
  ASSERT_TRUE(undo) << undo.error().sentence();
  EXPECT_EQ(valueOf(b, "context"), "0013");
  EXPECT_EQ(Sherds(catalogue()).get(b)->bag, bag1);
  EXPECT_EQ(valueOf(b, "number"), "X-1");
  const std::size_t history = catalogue::History(catalogue()).of(a)->size();
  const Result<std::vector<records::FieldChange>> redo =
      SherdChanges(catalogue()).apply(*undo, anna);
  ASSERT_TRUE(redo) << redo.error().sentence();
  for (const records::SherdField& field : sherds::sherdFields()) {
    EXPECT_EQ(valueOf(a, field.name), sherds::textOf(before_a, field.name)) << field.name;
    EXPECT_EQ(valueOf(b, field.name), sherds::textOf(before_b, field.name)) << field.name;
  }
  EXPECT_EQ(valueOf(b, "extra.drawer"), "");
  EXPECT_GT(catalogue::History(catalogue()).of(a)->size(), history)
      << "undoing is an provenance of its own";
  ASSERT_TRUE(SherdChanges(catalogue()).apply(*redo, anna));
  EXPECT_EQ(valueOf(a, "ware"), "grey");
  EXPECT_EQ(valueOf(b, "bag"), "1");
  EXPECT_EQ(valueOf(b, "number"), "X-1") << "its own number comes back to it";
}

TEST_F(Changes, AreUndoneOnlyWhereTheirValuesStillStand) {
  const store::SherdRow a = numbered(context12), b = draft(context12);
  const std::vector<records::FieldChange> changes = {
      {a, "ware", "grey"}, {a, "part", "rim"}, {b, "ware", "grey"}};
  const auto undo = SherdChanges(catalogue()).apply(changes, anna);
  ASSERT_TRUE(undo);
  ASSERT_TRUE(set(b, "ware", "red"));  // somebody else
  const auto refused = SherdChanges(catalogue()).apply(*undo, anna);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().what,
            "The field ware was changed meanwhile; nothing was undone or redone.");
  EXPECT_EQ(refused.error().where, Sherds(catalogue()).get(b)->id) << "a draft has no number";
  EXPECT_EQ(valueOf(a, "ware"), "grey");
  EXPECT_EQ(valueOf(b, "ware"), "red");
  ASSERT_TRUE(set(b, "ware", "grey"));
  ASSERT_TRUE(SherdChanges(catalogue()).apply(*undo, anna));
  EXPECT_EQ(valueOf(a, "part"), "");
}

TEST_F(Changes, AreRedoneOnlyOverWhatTheUndoLeft) {
  const store::SherdRow a = numbered(context12);
  const std::vector<records::FieldChange> changes = {{a, "ware", "grey"}, {a, "note", ""}};
  const auto undo = SherdChanges(catalogue()).apply(changes, anna);
  ASSERT_TRUE(undo);
  const std::vector<records::FieldChange> again = changesAgain(changes, *undo);
  ASSERT_EQ(again.size(), 1u) << "an empty note stayed empty";
  ASSERT_TRUE(SherdChanges(catalogue()).apply(*undo, anna));
  ASSERT_TRUE(set(a, "ware", "red"));
  EXPECT_FALSE(SherdChanges(catalogue()).apply(again, anna));
  ASSERT_TRUE(set(a, "ware", ""));
  EXPECT_TRUE(SherdChanges(catalogue()).apply(again, anna));
  EXPECT_EQ(valueOf(a, "ware"), "grey");
}

TEST_F(Changes, ExpectAnUncertaintyAndTheSameJoinedSherd) {
  const store::SherdRow a = numbered(context12), b = draft(context12);
  const std::string id = Sherds(catalogue()).get(b)->id;
  const std::vector<records::FieldChange> changes = {{a, "length_mm", "12.5 ± 0.4"},
                                                     {a, "joins", id}};
  const auto undo = SherdChanges(catalogue()).apply(changes, anna);
  ASSERT_TRUE(undo);
  ASSERT_TRUE(set(b, "number", "X-1"));
  ASSERT_TRUE(set(a, "length_mm", "12.5 ± 0.9"));
  EXPECT_FALSE(SherdChanges(catalogue()).apply(*undo, anna)) << "the uncertainty is another";
  ASSERT_TRUE(set(a, "length_mm", "12.5 ± 0.4"));
  const auto done = SherdChanges(catalogue()).apply(*undo, anna);
  EXPECT_TRUE(done) << "a number does not make it another sherd: " << done.error().sentence();
}

TEST_F(Changes, ThatChangeNothingLeaveNoTrace) {
  const store::SherdRow a = numbered(context12);
  ASSERT_TRUE(set(a, "ware", "grey"));
  const records::SherdRecord before = *Sherds(catalogue()).get(a);
  const std::size_t history = catalogue::History(catalogue()).of(a)->size();
  const Result<std::vector<records::FieldChange>> undo = set(a, "ware", "  grey ");
  ASSERT_TRUE(undo);
  EXPECT_TRUE(undo->empty());
  EXPECT_EQ(Sherds(catalogue()).get(a)->revision, before.revision);
  EXPECT_EQ(catalogue::History(catalogue()).of(a)->size(), history);
}

TEST_F(Changes, ASherdMovesOnlyToPlacesThatAreThere) {
  const store::SherdRow a = draft(context12, bag5);
  EXPECT_FALSE(set(a, "context", "0013")) << "bag 5 is not in 0013: moving asks for the bag";
  const std::vector<records::FieldChange> both = {{a, "context", "0013"}, {a, "bag", ""}};
  ASSERT_TRUE(SherdChanges(catalogue()).apply(both, anna));
  EXPECT_EQ(Sherds(catalogue()).get(a)->context, context13);
  EXPECT_FALSE(Sherds(catalogue()).get(a)->bag);
  EXPECT_FALSE(set(a, "context", "0099"));
  EXPECT_FALSE(set(a, "site", "ARM2"));
  EXPECT_TRUE(set(a, "bag", "1"));
}

TEST_F(Changes, ASiteOrTrenchWithoutAContextIsRefused) {
  const store::SherdRow a = draft({});
  for (const auto& [field, code] : {std::pair("site", "ARM1"), std::pair("trench", "T3")}) {
    const auto refused = set(a, field, code);
    ASSERT_FALSE(refused) << field;
    EXPECT_NE(refused.error().sentence().english().find("such as KT26-A-012"), std::string::npos);
  }
  EXPECT_TRUE(set(a, "site", ""));
  EXPECT_TRUE(set(a, "context", "0012")) << "only one context is called so";
}

TEST_F(Changes, ANumberedSherdNeedsItsContext) {
  const store::SherdRow a = numbered(context12);
  EXPECT_FALSE(set(a, "context", ""));
  const store::SherdRow without = draft({});
  EXPECT_FALSE(set(without, "number", "X-2"));
}

TEST_F(Changes, MeasurementsHaveLimits) {
  const store::SherdRow a = numbered(context12);
  for (const char* bad : {"0", "-1", "1001", "abc", "1,2,3", "5 mm"})
    EXPECT_FALSE(set(a, "length_mm", bad)) << bad;
  EXPECT_TRUE(set(a, "length_mm", "1000"));
  EXPECT_FALSE(set(a, "weight_g", "20001"));
  EXPECT_TRUE(set(a, "weight_g", "20000"));
  EXPECT_FALSE(set(a, "rim_pct", "101"));
}

TEST_F(Changes, AMeasurementMayBeTypedWithItsUncertainty) {
  const store::SherdRow a = numbered(context12);
  const auto diameter = [&] {
    for (const records::Measurement& m : catalogue::valueIn(Measurements(catalogue()).of(a)))
      if (m.kind == "rim_diameter") return m;
    return records::Measurement{};
  };
  ASSERT_TRUE(set(a, "rim_diameter_mm", "234,5 ± 6"));
  EXPECT_EQ(diameter().value, 234.5);
  EXPECT_EQ(diameter().uncertainty, 6);
  const records::FieldChange other{a, "rim_diameter_mm", "230"};
  const auto undo = SherdChanges(catalogue()).apply(std::span(&other, 1), anna);
  ASSERT_TRUE(undo);
  EXPECT_EQ(diameter().uncertainty, std::nullopt);
  ASSERT_TRUE(SherdChanges(catalogue()).apply(*undo, anna));
  EXPECT_EQ(diameter().value, 234.5);
  EXPECT_EQ(diameter().uncertainty, 6);
  for (const char* bad : {"234 ±", "234 ± -1", "± 6", "234 ± 6 ± 1", "234 ± x"})
    EXPECT_FALSE(set(a, "rim_diameter_mm", bad)) << bad;
}

TEST_F(Changes, TheUncertaintyOfAValueThatStaysMayBeChangedAndTakenAway) {
  const store::SherdRow a = numbered(context12);
  const auto typed = [&](const char* value) {
    const Result<std::vector<records::FieldChange>> undo = set(a, "rim_diameter_mm", value);
    EXPECT_TRUE(undo) << (undo ? "" : undo.error().sentence());
    return *undo;
  };
  const auto uncertainty = [&] { return Measurements(catalogue()).of(a)->at(0).uncertainty; };
  ASSERT_TRUE(
      Measurements(catalogue()).add({a, "rim_diameter", {}, 234.5, {}, "calliper", {}, {}}, anna));
  const std::vector<records::FieldChange> to_none = typed("234.5 ± 6");
  EXPECT_EQ(uncertainty(), 6);
  const records::FieldChange other{a, "rim_diameter_mm", "234.5 ± 4"};
  EXPECT_EQ(SherdChanges(catalogue()).preview(std::span(&other, 1))->front().old_value,
            "234.5 ± 6");
  const std::vector<records::FieldChange> to_six = typed("234.5 ± 4");
  EXPECT_EQ(uncertainty(), 4);
  EXPECT_TRUE(typed("234.5 ± 4").empty()) << "nothing changes";
  EXPECT_TRUE(typed("234.5").empty()) << "the value is the same";
  const std::vector<records::FieldChange> to_four = typed("234.5 ± 0");
  EXPECT_EQ(uncertainty(), std::nullopt);
  ASSERT_TRUE(SherdChanges(catalogue()).apply(to_four, anna));
  EXPECT_EQ(uncertainty(), 4);
  ASSERT_TRUE(SherdChanges(catalogue()).apply(to_six, anna));
  EXPECT_EQ(uncertainty(), 6);
  ASSERT_TRUE(SherdChanges(catalogue()).apply(to_none, anna));
  EXPECT_EQ(uncertainty(), std::nullopt);
  EXPECT_EQ(Measurements(catalogue()).of(a)->at(0).method, "calliper");
}

TEST_F(Changes, TextsThatAreNoTextAreRefused) {
  const store::SherdRow a = numbered(context12);
  EXPECT_FALSE(set(a, "note", "\xFF\xFE"));
  EXPECT_FALSE(set(a, "note", std::string("a\0b", 3)));
  EXPECT_FALSE(set(a, "note", std::string((1 << 20) + 1, 'x')));
  EXPECT_TRUE(set(a, "note", "'; DROP TABLE sherd; --"));
  EXPECT_EQ(valueOf(a, "note"), "'; DROP TABLE sherd; --");
}

}  // namespace
}  // namespace ostraka::sherds
