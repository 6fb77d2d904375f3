#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace ostraka::tables {

/// Which field a column of somebody's table means, by its name in one of the program's languages,
/// whatever its capitals, accents and marks. of_contexts: of a table of contexts. Empty: none.
std::string fieldOfColumn(std::string_view column, bool of_contexts);

/// A column's name taken apart: "Gewicht (kg)", "weight_kg" and "Gewicht in kg" are Gewicht and kg.
/// What is nothing but a unit is both: "eve" is a share of 1 by its name.
struct NameAndUnit {
  std::string name, unit;  ///< unit as in unitsOf(); empty where the name says none
};
NameAndUnit nameAndUnit(const std::string& column);

/// Which field a heading means, as `name`, and its unit where the heading says one that the field
/// has: {"length_mm", "cm"} of "Länge (cm)". Both empty: none.
NameAndUnit fieldAndUnit(const std::string& heading, bool of_contexts);
/// A heading for people: `words`, what the reader calls the field, where a table with it is read as
/// this field in its own unit again; else the field's own name.
std::string headingOf(const std::string& field, const std::string& words, bool of_contexts);

/// The same of a value, which ends with its last digit: "12,5 ± 0,3 cm".
NameAndUnit valueAndUnit(const std::string& value);

/// mm, cm, m, g, kg, mg, %, share (of 1), or empty: how a unit is written in the program's
/// languages.
std::string unitNamed(std::string_view text);

/// The units that a field's values may have, its own first; empty of one without numbers.
std::vector<std::string> unitsOf(const std::string& field);
/// How many tens a value in `unit` is multiplied by for one of the field's own: cm -> mm is 1.
int tensBetween(const std::string& unit, const std::string& field);

}  // namespace ostraka::tables
