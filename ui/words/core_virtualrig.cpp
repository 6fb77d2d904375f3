#include <QtGlobal>

#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences sentencesOfVirtualrig() {
  static constexpr const char* kAll[] = {
      QT_TRANSLATE_NOOP("ostraka::Error", "The picture could not be encoded."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The %1 sherds do not fit on the plate; use fewer, or another seed."),
      QT_TRANSLATE_NOOP("ostraka::Error", "sherds must lie between 1 and 40."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "width must lie between 160 and 8192 pixels and be divisible by 4."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "near_duplicates are groups of two: at most half the number of sherds."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The rig needs a camera and at least four positions; recalibrate it."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The virtual camera has no setting %1 of %2."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The camera has taken no photograph."),
  };
  return kAll;
}

}  // namespace ostraka::ui
