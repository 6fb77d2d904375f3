#include "tables/column_mapping.h"

#include <gmock/gmock.h>

#include "catalogue/settings.h"
#include "files/files.h"
#include "sherds/measurements.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "tables/import_table.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::tables {
namespace {

using namespace catalogue;
using testing::ElementsAre;
using testing::HasSubstr;

class Columns : public SmallProject {
 protected:
  Result<TableMapping> map(const std::string& text, const std::vector<ColumnChoice>& chosen = {}) {
    return mapColumns(catalogue(), *parseCsv(text, "t.csv"), chosen, "t.csv");
  }
  std::vector<std::string> fieldsOf(const std::string& text) {
    std::vector<std::string> fields;
    const Result<TableMapping> mapping = map(text);
    for (const ColumnChoice& choice : mapping->columns)
      fields.push_back(choice.field + (choice.unit.empty() ? "" : ":" + choice.unit));
    return fields;
  }
  ImportReport import(const std::string& text, std::vector<ColumnChoice> chosen = {}) {
    ImportOptions options;
    options.mode = ImportMode::Enter;
    options.columns = std::move(chosen);
    const auto report = importTable(catalogue(), text, "t.csv", options, anna, quiet, {});
    EXPECT_TRUE(report) << (report ? "" : report.error().sentence());
    return report ? *report : ImportReport();
  }
  std::string valueIn(const char* number, const char* field) {
    return sherds::textOf(
        *sherds::Sherds(catalogue()).get(*sherds::Sherds(catalogue()).byNumber(number)), field);
  }
  QuietProgress quiet;
};

TEST_F(Columns, OfAGermanTableAreProposedByTheirNames) {
  EXPECT_THAT(fieldsOf("Fundnummer;Fundort;Schnitt;Befund;Gewicht (kg);Dicke [cm];Schublade\n"
                       "X-1;ARM1;T3;0012;0,0235;0,62;7\n"),
              ElementsAre("number", "site", "trench", "context", "weight_g:kg",
                          "thickness_mean_mm:cm", "extra.Schublade"));
}

TEST_F(Columns, WithoutAUnitAreTakenForTheOneThatTheirValuesFit) {
  const TableMapping mapping =
      *map("number;Gewicht;Dicke;Länge\nX-1;0,02;6,1;5,5\nX-2;0,4;7;7,2\n");
  EXPECT_EQ(mapping.columns[1].unit, "kg");
  EXPECT_EQ(mapping.columns[2].unit, "mm");
  EXPECT_EQ(mapping.columns[3].unit, "cm");
  for (const std::size_t i : {1u, 2u, 3u}) EXPECT_TRUE(mapping.columns[i].unit_guessed);
  EXPECT_THAT(mapping.columns[1].samples, ElementsAre("0,02", "0,4"));
  EXPECT_FALSE(map("number;Gewicht (g)\nX-1;0,4\n")->columns[1].unit_guessed);
}

// Else the weight of a sherd would be entered as its bag's.
TEST_F(Columns, OfSherdsWithoutTheirNumbersAreNoTableOfBags) {
  const std::string bags = "Fundort;Schnitt;Befund;Beutel;Gewicht (g)";
  EXPECT_THAT(map(bags + ";Teil\nARM1;T3;0012;4;23,4;Rand\n")->missing.english(),
              HasSubstr("but 'Teil' is a column of sherds"));
  EXPECT_FALSE(map(bags + ";Wandstärke (mm)\nARM1;T3;0012;4;23,4;5\n")->missing.empty());
  const ImportReport nothing = import(bags + ";Teil\nARM1;T3;0012;4;23,4;Rand\n");
  EXPECT_TRUE(nothing.rows.empty());
  EXPECT_TRUE(
      map(bags + ";Teil\nARM1;T3;0012;4;23,4;Rand\n", {{"Teil", "extra.Teil"}})->missing.empty())
      << "a person said what it is";
  import(bags + ";Teil\nARM1;T3;0012;4;23,4;Rand\n", {{ "Teil", "extra.Teil" }});
  EXPECT_TRUE(map(bags + ";Teil\nARM1;T3;0012;5;17;Rand\n")->missing.empty())
      << "and said it of such tables";
  const auto taken = map(bags + ";Länge;Farbe\nARM1;T3;0012;4;230;2;braun\n");
  EXPECT_TRUE(taken->missing.empty()) << "pits have lengths, and layers colours";
  EXPECT_EQ(taken->kind,
            "Read as a table of contexts and bags: no column has the sherds' numbers.");
  EXPECT_EQ(map("Fundnummer;Teil\nX-1;Rand\n")->kind,
            "Read as a table of sherds: the column 'Fundnummer' identifies them.");
}

TEST_F(Columns, OfNoTwoMeanOneField) {
  EXPECT_THAT(fieldsOf("number;weight;Gewicht\nX-1;7;8\n"),
              ElementsAre("number", "weight_g:g", "extra.Gewicht"));
  const auto twice = map("number;a;b\nX;1;2\n", {{"a", "weight_g"}, {"b", "weight_g"}});
  ASSERT_FALSE(twice);
  EXPECT_THAT(twice.error().what, testing::HasSubstr("'a' and 'b' are both"));
  EXPECT_EQ(twice.error().what.values().at(2).text, "weight_g");
  EXPECT_FALSE(map("number\nX\n", {{"b", "weight_g"}})) << "no such column";
  EXPECT_FALSE(map("number;a\nX;1\n", {{"a", "weight_g", "mm"}})) << "no such unit";
  EXPECT_FALSE(map("number;a\nX;1\n", {{"a", "beauty"}})) << "no such field";
}

TEST_F(Columns, AreEnteredInTheFieldsOwnUnitsExactly) {
  const ImportReport report = import(
      "Nummer;Fundort;Schnitt;Befund;Gewicht (kg);Dicke (cm);Schublade;egal\n"
      "X-1;ARM1;T3;0012;1,5;1,2;7;x\n",
      {{"egal", ""}});
  EXPECT_EQ(report.fresh, 1);
  EXPECT_EQ(valueIn("X-1", "weight_g"), "1500");
  EXPECT_EQ(valueIn("X-1", "thickness_mean_mm"), "12");
  EXPECT_EQ(valueIn("X-1", "extra.Schublade"), "7");
  EXPECT_EQ(
      sherds::Sherds(catalogue()).get(*sherds::Sherds(catalogue()).byNumber("X-1"))->extra_json,
      "{\"Schublade\":\"7\"}")
      << "what is left out is nowhere";
}

TEST_F(Columns, ThatOnlyTheProgramWritesAreShownAndNeverRead) {
  std::string shown;
  for (const ColumnChoice& choice :
       map("number,uuid,state,batch,scale,area_mm2,volume_mm3,filled_pct,weight_g,note\n")->columns)
    if (choice.isOnlyShown()) shown += choice.column + ' ';
  EXPECT_EQ(shown, "batch scale area_mm2 volume_mm3 filled_pct ");
}

TEST_F(Columns, ThatWereProposedStayProposalsWhereTheyAreGivenBackUnchanged) {
  const std::string table = "Nummer;Gewicht;Schublade;Zahl\nX-1;50;7;3\n";
  TableMapping seen = *map(table);
  ASSERT_EQ(seen.columns.size(), 4u);
  seen.columns[3].field = "rim_pct";
  seen.columns[3].by = ChosenBy::Person;
  const TableMapping given = *map(table, seen.columns);
  EXPECT_EQ(given.columns[0].by, ChosenBy::Name);
  EXPECT_EQ(given.columns[1].by, ChosenBy::Name);
  EXPECT_EQ(given.columns[1].field, "weight_g");
  EXPECT_EQ(given.columns[2].by, ChosenBy::Nobody);
  EXPECT_EQ(given.columns[2].field, "extra.Schublade");
  EXPECT_EQ(given.columns[3].by, ChosenBy::Person);
}

TEST_F(Columns, AreChosenForTheNextTableWithTheSameOnes) {
  import("Nummer;Fundort;Schnitt;Befund;Zahl\nX-1;ARM1;T3;0012;0,5\n",
         {{ "Zahl",
            "weight_g",
            "kg" }});
  import("Zahl;Nummer;Fundort;Schnitt;Befund\n0,25;X-2;ARM1;T3;0012\n");
  EXPECT_EQ(valueIn("X-2", "weight_g"), "250");
  const TableMapping again = *map("Zahl;Nummer;Fundort;Schnitt;Befund\n1;X-3;ARM1;T3;0012\n");
  EXPECT_EQ(again.columns[0].by, ChosenBy::Earlier);
  EXPECT_EQ(map("Zahl;Nummer\n1;X-3\n")->columns[0].field, "extra.Zahl") << "another table";
}

constexpr const char* kKilograms =
    "Nummer;Fundort;Schnitt;Befund;Gewicht\nX-1;ARM1;T3;0012;0,02\nX-2;ARM1;T3;0012;0,4\n";
constexpr const char* kGrams =
    "Nummer;Fundort;Schnitt;Befund;Gewicht\nX-3;ARM1;T3;0012;12,5\nX-4;ARM1;T3;0012;19\n";

TEST_F(Columns, OfAGuessedUnitHoldTheirTableUntilAPersonStatesIt) {
  const ImportReport held = import(kKilograms);
  EXPECT_TRUE(held.held);
  EXPECT_EQ(held.fresh, 2) << "what would happen";
  EXPECT_FALSE(*sherds::Sherds(catalogue()).byNumber("X-1"));
  const ImportReport by_field = import(kKilograms, {{"Gewicht", "weight_g"}});
  EXPECT_TRUE(by_field.held) << "a field alone states no unit";
  const ImportReport stated = import(kKilograms, {{"Gewicht", "weight_g", "kg"}});
  EXPECT_FALSE(stated.held);
  EXPECT_EQ(valueIn("X-2", "weight_g"), "400");
}

TEST_F(Columns, OfAGuessedUnitAreGuessedAgainForTheNextTable) {
  ImportOptions seen;  // as the window enters what it showed
  seen.mode = ImportMode::Enter;
  seen.guessed_units = GuessedUnits::Enter;
  seen.columns = map(kKilograms)->columns;
  ASSERT_EQ(importTable(catalogue(), kKilograms, "t.csv", seen, anna, quiet, {})->fresh, 2);
  const TableMapping next = *map(kGrams);
  EXPECT_EQ(next.columns[4].by, ChosenBy::Earlier);
  EXPECT_EQ(next.columns[4].unit, "g") << "twelve and a half kilograms are no sherd";
  EXPECT_TRUE(next.columns[4].unit_guessed);
  seen.columns[4].unit_guessed = false;  // as when a person chooses it
  ASSERT_TRUE(importTable(catalogue(), kKilograms, "t.csv", seen, anna, quiet, {}));
  EXPECT_EQ(map(kKilograms)->columns[4].unit, "kg");
  EXPECT_FALSE(map(kKilograms)->columns[4].unit_guessed) << "what was chosen is certain";
}

TEST_F(Columns, WithoutAnyValueAreNotRememberedWithAUnit) {
  import("Nummer;Fundort;Schnitt;Befund;Dicke\nX-1;ARM1;T3;0012;\n");
  const TableMapping next = *map("Nummer;Fundort;Schnitt;Befund;Dicke\nX-2;ARM1;T3;0012;0,6\n");
  EXPECT_EQ(next.columns[4].unit, "cm");
  EXPECT_TRUE(next.columns[4].unit_guessed);
}

// They were remembered with whatever unit there was.
TEST_F(Columns, OfEarlierProgramsAreRememberedWithoutTheirUnits) {
  const std::string columns = R"(["Gewicht","Nummer"])";
  ASSERT_TRUE(Settings(catalogue())
                  .setValue("import_columns." + ostraka::sha256(columns).substr(0, 32),
                            R"({"Nummer":["number",""],"Gewicht":["weight_g","kg"]})"));
  const TableMapping next = *map("Nummer;Gewicht\nX-1;12,5\n");
  EXPECT_EQ(next.columns[1].by, ChosenBy::Earlier);
  EXPECT_EQ(next.columns[1].unit, "g");
  EXPECT_TRUE(next.columns[1].unit_guessed);
}

TEST_F(Columns, TakeTheUnitOfTheirHeadingWhateverFieldIsChosen) {
  const TableMapping mapping = *map("number;Gew. (kg)\nX-1;12\n", {{"Gew. (kg)", "weight_g"}});
  EXPECT_EQ(mapping.columns[1].unit, "kg");
  EXPECT_FALSE(mapping.columns[1].unit_guessed);
}

TEST_F(Columns, OfVesselEquivalentsAreSharesOfOneByTheirName) {
  for (const char* name : {"eve", "EVE", "rim eve", "Rim EVE"}) {
    const ColumnChoice rim =
        map(std::string("number;") + name + "\nX-1;0,15\nX-2;0,9\n")->columns[1];
    EXPECT_EQ(rim.field, "rim_pct") << name;
    EXPECT_EQ(rim.unit, "share") << name;
    EXPECT_FALSE(rim.unit_guessed) << name;
  }
  EXPECT_EQ(map("number;EVE (%)\nX-1;15\n")->columns[1].unit, "%");
  import("Nummer;Fundort;Schnitt;Befund;EVE\nX-1;ARM1;T3;0012;0,15\n");
  EXPECT_EQ(valueIn("X-1", "rim_pct"), "15");
}

TEST_F(Columns, OfRimsWithoutAUnitAreGuessedToBeSharesWhereAllValuesCanBe) {
  const ColumnChoice shares = map("number;rim preserved\nX-1;0,15\nX-2;1,05\n")->columns[1];
  EXPECT_EQ(shares.unit, "share");
  EXPECT_TRUE(shares.unit_guessed);
  constexpr const char* kPercent =
      "Nummer;Fundort;Schnitt;Befund;Rand erhalten\nX-1;ARM1;T3;0012;15\nX-2;ARM1;T3;0012;1\n";
  EXPECT_EQ(map(kPercent)->columns[4].unit, "%");
  EXPECT_FALSE(import(kPercent).held) << "fifteen rims are no part of one";
  const ColumnChoice next =
      map("Nummer;Fundort;Schnitt;Befund;Rand erhalten\nX-3;ARM1;T3;0012;0,4\n")->columns[4];
  EXPECT_EQ(next.by, ChosenBy::Earlier);
  EXPECT_TRUE(next.unit_guessed) << "the last table's values say nothing about this one's";
}

TEST_F(Columns, WithUncertaintiesHaveAGuessedUnitToo) {
  EXPECT_TRUE(map("number;Dicke\nX-1;0,6 ± 0,1\n")->columns[1].unit_guessed);
  EXPECT_EQ(map("number;Dicke\nX-1;0,6 ± 0,1\n")->columns[1].unit, "cm");
  EXPECT_FALSE(map("number;Dicke\nX-1;0,6 ± 0,1 cm\n")->columns[1].unit_guessed);
}

TEST_F(Columns, ARefusalNamesThemAsTheTableDoes) {
  const ImportReport report =
      import("Nummer;Fundort;Schnitt;Befund;Dicke (cm)\nX-1;ARM1;T3;0012;dick\n");
  ASSERT_EQ(report.refusals.size(), 1u);
  EXPECT_EQ(report.refusals[0].column, "Dicke (cm)");
  EXPECT_EQ(report.refusals[0].value, "dick");
}

TEST(Units, AreConvertedWithoutRounding) {
  EXPECT_EQ(inOwnUnit("1.5", "kg", "weight_g"), "1500");
  EXPECT_EQ(inOwnUnit("1,2", "cm", "length_mm"), "12");
  EXPECT_EQ(inOwnUnit("1.1", "kg", "weight_g"), "1100");
  EXPECT_EQ(inOwnUnit("0.0057", "kg", "weight_g"), "5.7");
  EXPECT_EQ(inOwnUnit("5.7 cm", "mm", "length_mm"), "57") << "what the value says comes first";
  EXPECT_EQ(inOwnUnit("23 g", "g", "weight_g"), "23");
  EXPECT_EQ(inOwnUnit("1,2 ± 0,1", "cm", "length_mm"), "12 ± 1");
  EXPECT_EQ(inOwnUnit("12,5", "mm", "length_mm"), "12,5");
  EXPECT_EQ(inOwnUnit("thin", "cm", "length_mm"), "thin");
  EXPECT_EQ(inOwnUnit("23 kg", "mm", "length_mm"), "23 kg") << "refused as it is";
}

TEST(ColumnChoices, AreReadAsTheyAreTyped) {
  const ColumnChoice kg = *parseColumnChoice("Gewicht=weight:kg");
  EXPECT_EQ(kg.column + " " + kg.field + " " + kg.unit, "Gewicht weight_g kg");
  EXPECT_EQ(parseColumnChoice("a=b=note")->column, "a=b");
  EXPECT_EQ(parseColumnChoice("Kiste=extra.box")->field, "extra.box");
  EXPECT_EQ(parseColumnChoice("Kiste=-")->field, "");
  for (const char* wrong : {"Gewicht", "=weight", "Gewicht=beauty", "Gewicht=weight:stone"})
    EXPECT_FALSE(parseColumnChoice(wrong)) << wrong;
}

TEST_F(Columns, OfMeasuresThatTheCatalogueAsksAboutHoldTheirRowUntilItIsConfirmed) {
  const store::SherdRow sherd = numbered(context12);
  ASSERT_TRUE(sherds::Measurements(catalogue())
                  .add({sherd, "length", {}, 72.39, {}, "program", {}, "m"}, {}));
  const std::string table = "number,length_mm,note\n" + valueOf(sherd, "number") + ",7,slip\n";
  ImportReport report = import(table);
  EXPECT_EQ(report.asked, 1);
  EXPECT_EQ(report.refused + report.changed, 0);
  ASSERT_EQ(report.questions.size(), 1u);
  EXPECT_EQ(report.questions[0].line, 2);
  EXPECT_THAT(report.questions[0].reason, HasSubstr("about a tenth of the computed value"));
  const std::string cm = "number;L\u00e4nge [cm]\n" + valueOf(sherd, "number") + ";7,1\n";
  const ImportReport typed = import(cm);
  ASSERT_EQ(typed.questions.size(), 1u);
  EXPECT_EQ(typed.questions[0].value, "7,1") << "as the column with its unit has it";
  EXPECT_EQ(valueOf(sherd, "note"), "") << "the whole row waits";
  ImportOptions options;
  options.mode = ImportMode::Enter;
  options.confirmed_lines = {2};
  report = *importTable(catalogue(), table, "t.csv", options, anna, quiet, {});
  EXPECT_EQ(report.changed, 1);
  EXPECT_EQ(valueOf(sherd, "length_mm"), "7");
  EXPECT_EQ(sherds::Sherds(catalogue()).get(sherd)->replaced.at("length"), 72.39);
}

}  // namespace
}  // namespace ostraka::tables
