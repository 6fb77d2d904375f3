#include <QtGlobal>

#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences sentencesOfPairing() {
  static constexpr const char* kAll[] = {
      QT_TRANSLATE_NOOP("ostraka::Error", "The scan's outline is not closed."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A scan of fewer than 20 points has no outline."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A contour needs at least three points."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The evidence for a pair has no valid scans or value."),
      QT_TRANSLATE_NOOP("ostraka::Error", "pairing: %1 stays unpaired: %2"),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "No two outlines match, so the sizes of the two sides cannot be compared; "
                        "provide a known length."),
  };
  return kAll;
}

}  // namespace ostraka::ui
