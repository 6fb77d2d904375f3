#pragma once
#include <string_view>

namespace ostraka::tables {

/// Whether a number or code reads as what a spreadsheet makes of another one: 1.23E+05, whose
/// digits are lost, or a date: 12/03/2021, 01-Mar, 2. Jan, Mar-01, with the months as they are
/// shortened in the languages of the program. MAR-01 is a code: spreadsheets use no capitals.
bool isDamagedNumber(std::string_view number);

}  // namespace ostraka::tables
