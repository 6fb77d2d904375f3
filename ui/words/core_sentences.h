#pragma once
#include <span>
#include <vector>

namespace ostraka::ui {

/// What core says to a person, as patterns in English, for Qt Linguist (context "ostraka::Error");
/// one list a folder of core. A place (%1 to %9) stands for a value, which may be a sentence or a
/// phrase of these lists itself. Tests see to it that they stand in core word for word.
using Sentences = std::span<const char* const>;

Sentences sentencesOfBase();
Sentences sentencesOfCapture();
Sentences sentencesOfCatalogue();
Sentences sentencesOfDrawing();
Sentences sentencesOfExchange();
Sentences sentencesOfMask();
Sentences sentencesOfModel();
Sentences sentencesOfPairing();
Sentences sentencesOfPipeline();
Sentences sentencesOfRegistration();
Sentences sentencesOfRig();
Sentences sentencesOfScan();
Sentences sentencesOfStereo();
Sentences sentencesOfVirtualrig();

/// All of them.
std::vector<Sentences> coreSentences();

}  // namespace ostraka::ui
