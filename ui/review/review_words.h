#pragma once
#include <QString>

#include "pipeline/review.h"
#include "ui/frame/state_colours.h"

/// The review's codes and values in words.
namespace ostraka::ui {

/// Whole sentence: why this card wants a person, or what was decided.
QString doubtSentence(const pipeline::ReviewCard& card, const pipeline::CandidateTable& table);
/// One or two words for the state; goes along with the colour.
QString stateWord(pipeline::CardState state);
State stateColour(pipeline::CardState state);
QString percent(double share);  ///< "71 %", "under 1 %"
QString mm(double value, int digits = 2);
/// What the registration's own check says of a pose; empty when nothing.
QString slipSentence(registration::Slip slip, double value);

}  // namespace ostraka::ui
