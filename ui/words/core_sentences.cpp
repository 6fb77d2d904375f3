#include "ui/words/core_sentences.h"

namespace ostraka::ui {

std::vector<Sentences> CoreSentences::all() {
  return {ofBase(), ofCapture(), ofCatalogue(), ofDrawing(),   ofExchange(),
          ofMask(), ofModel(),   ofPairing(),   ofPipeline(),  ofRegistration(),
          ofRig(),  ofScan(),    ofStereo(),    ofVirtualrig()};
}

}  // namespace ostraka::ui
