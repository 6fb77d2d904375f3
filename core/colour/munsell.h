#pragma once
#include <string>
#include <vector>

#include "colour/ciede2000.h"

namespace ostraka::colour {

/// A chip of a Munsell book.
struct MunsellChip {
  std::string notation;  ///< 7.5YR 5/4, N 5/
  Lab lab;
};

/// All real colours of the renotation (Newhall, Nickerson, Judd, JOSA 33, 1943) of values 2 to 9
/// and chromas up to 16, the greys N 2/ to N 9/, and what soil colour books add for 10R to 5Y:
/// chromas 1 and 3, value 2.5. Adapted from illuminant C by Bradford's matrix.
const std::vector<MunsellChip>& munsellChips();

/// The chip that looks most like a colour, the next one, and their CIEDE2000 from it.
struct MunsellMatch {
  std::string notation, second;
  double difference = 0, second_difference = 0;
};
MunsellMatch nearestMunsell(const Lab& lab);

}  // namespace ostraka::colour
