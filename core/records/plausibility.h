#pragma once
#include <map>
#include <string>
#include <vector>

#include "base/message.h"

namespace ostraka::records {

/// Why a person is asked before a measured value counts.
enum class MeasureDoubt {
  TenTimesComputed,  ///< centimetres typed as millimetres, or the other way round
  FarFromComputed,   ///< three times the computed value or more, or a third of it or less
  OrderReversed,     ///< length below width, width below thickness, least above greatest
  ReplacesComputed,  ///< a person's value would count instead of the computed one
  DeletesComputed
};

struct MeasureFinding {
  MeasureDoubt doubt = MeasureDoubt::ReplacesComputed;
  std::string kind;  ///< of the value asked about; of OrderReversed: the one that is too small
  double value = 0;
  std::string than;      ///< OrderReversed: the kind it should not be below
  double reference = 0;  ///< of `than`, or what was computed
};

/// kind -> value, in the kinds' own units.
using MeasureValues = std::map<std::string, double>;

/// What speaks against the values of these kinds, measured by a person. measured: all values of the
/// sherd as they would be; computed: those that the program took from its model.
std::vector<MeasureFinding> implausible(const std::vector<std::string>& kinds,
                                        const MeasureValues& measured,
                                        const MeasureValues& computed);

/// One sentence of a finding.
Message sentenceOf(const MeasureFinding& finding);

}  // namespace ostraka::records
