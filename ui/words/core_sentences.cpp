#include "ui/words/core_sentences.h"

namespace ostraka::ui {

std::vector<Sentences> coreSentences() {
  return {sentencesOfBase(),         sentencesOfCapture(),   sentencesOfCatalogue(),
          sentencesOfDrawing(),      sentencesOfExchange(),  sentencesOfMask(),
          sentencesOfModel(),        sentencesOfPairing(),   sentencesOfPipeline(),
          sentencesOfRegistration(), sentencesOfRig(),       sentencesOfScan(),
          sentencesOfStereo(),       sentencesOfVirtualrig()};
}

}  // namespace ostraka::ui
