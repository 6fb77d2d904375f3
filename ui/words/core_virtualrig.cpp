#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences CoreSentences::ofVirtualrig() {
  static constexpr const char* kAll[] = {
      QT_TR_NOOP("The picture could not be encoded."),
      QT_TR_NOOP("The %1 sherds do not fit on the plate; use fewer, or another seed."),
      QT_TR_NOOP("sherds must lie between 1 and 40."),
      QT_TR_NOOP("width must lie between 160 and 8192 pixels and be divisible by 4."),
      QT_TR_NOOP("near_duplicates are groups of two: at most half the number of sherds."),
      QT_TR_NOOP("The rig needs a camera and at least four positions; recalibrate it."),
      QT_TR_NOOP("The virtual camera has no setting %1 of %2."),
      QT_TR_NOOP("The camera has taken no photograph."),
  };
  return kAll;
}

}  // namespace ostraka::ui
