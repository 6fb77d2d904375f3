#include <QtGlobal>

#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences sentencesOfPairing() {
  static constexpr const char* kAll[] = {
      QT_TRANSLATE_NOOP("ostraka::Error", "The scan's outline does not close."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A scan of fewer than 20 points has no outline."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A contour needs at least three points."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The evidence of a pair has no valid scans or figure."),
      QT_TRANSLATE_NOOP("ostraka::Error", "pairing: %1 stays unpaired: %2"),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "No two outlines are alike, so the sides' sizes cannot be compared; give a "
                        "known length."),
  };
  return kAll;
}

}  // namespace ostraka::ui
