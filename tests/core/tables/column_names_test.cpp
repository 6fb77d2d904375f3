#include "tables/column_names.h"

#include <gtest/gtest.h>

#include <tuple>
#include <utility>

namespace ostraka::tables {
namespace {

TEST(ColumnNames, AreKnownInSevenLanguagesWhateverTheirCapitalsAccentsAndMarks) {
  for (const auto& [column, field] : {std::pair("weight", "weight_g"),
                                      std::pair("Gewicht", "weight_g"),
                                      std::pair("POIDS", "weight_g"),
                                      std::pair("peso", "weight_g"),
                                      std::pair("Βάρος", "weight_g"),
                                      std::pair("ağırlık", "weight_g"),
                                      std::pair("AĞIRLIK", "weight_g"),
                                      std::pair("քաշ", "weight_g"),
                                      std::pair("thickness", "thickness_mean_mm"),
                                      std::pair("Dicke", "thickness_mean_mm"),
                                      std::pair("épaisseur", "thickness_mean_mm"),
                                      std::pair("Epaisseur", "thickness_mean_mm"),
                                      std::pair("grosor", "thickness_mean_mm"),
                                      std::pair("πάχος", "thickness_mean_mm"),
                                      std::pair("ΠΑΧΟΣ", "thickness_mean_mm"),
                                      std::pair("kalınlık", "thickness_mean_mm"),
                                      std::pair("հաստություն", "thickness_mean_mm"),
                                      std::pair("LAENGE", "length_mm"),
                                      std::pair("Länge", "length_mm"),
                                      std::pair("max. Länge", "length_mm"),
                                      std::pair("Fund-Nr.", "number"),
                                      std::pair("Befund", "context"),
                                      std::pair("drawer", ""),
                                      std::pair("", "")})
    EXPECT_EQ(fieldOfColumn(column, false), field) << column;
  EXPECT_EQ(fieldOfColumn("Anzahl", true), "count_written");
  EXPECT_EQ(fieldOfColumn("Anzahl", false), "");
}

TEST(ColumnNames, SayTheirUnitInBracketsAndBehindTheirName) {
  for (const auto& [column, name, unit] :
       {std::tuple("Gewicht (kg)", "Gewicht", "kg"), std::tuple("Length [cm]", "Length", "cm"),
        std::tuple("weight_g", "weight", "g"), std::tuple("Länge, mm", "Länge", "mm"),
        std::tuple("Breite in cm", "Breite", "cm"), std::tuple("βάρος (γρ.)", "βάρος", "g"),
        std::tuple("rim, %", "rim", "%"), std::tuple("Munsell", "Munsell", ""),
        std::tuple("kg", "kg", "kg"), std::tuple("EVE", "EVE", "share"),
        std::tuple("rim eve", "rim", "share"), std::tuple("EVE (%)", "EVE", "%"),
        std::tuple("munsell core", "munsell core", "")}) {
    const NameAndUnit parts = nameAndUnit(column);
    EXPECT_EQ(parts.name, name);
    EXPECT_EQ(parts.unit, unit) << column;
  }
}

// Whoever writes one colour of a sherd writes that of its outside.
TEST(ColumnNames, OfOneMunsellColourMeanTheOuterSurface) {
  EXPECT_EQ(fieldOfColumn("Munsell", false), "munsell_out");
  EXPECT_EQ(fieldOfColumn("Munsell core", false), "munsell_core");
}

TEST(ColumnNames, OfAnExportForPeopleAreTheirWordsWhereAnImportReadsThemAsTheSameField) {
  for (const auto& [field, words, heading] :
       {std::tuple("length_mm", "Länge, mm", "Länge, mm"),
        std::tuple("rim_pct", "Rand erhalten, %", "Rand erhalten, %"),
        std::tuple("area_mm2", "alan, mm²", "alan, mm²"), std::tuple("site", "alan", "alan"),
        std::tuple("model_file", "Modelldatei", "Modelldatei"),
        std::tuple("mass_centre_y_mm", "centro de masa y, mm", "centro de masa y, mm"),
        std::tuple("state", "Zustand", "state"),  // the condition to others
        std::tuple("batch", "lot", "batch"),      // a bag
        std::tuple("weight_g", "Gewicht, kg", "weight_g"),
        std::tuple("length_mm", "Länge", "length_mm")})  // in which unit?
    EXPECT_EQ(headingOf(field, words, false), heading) << words;
  EXPECT_EQ(headingOf("count_written", "Scherben laut Beutel", true), "Scherben laut Beutel");
}

}  // namespace
}  // namespace ostraka::tables
