#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences CoreSentences::ofPairing() {
  static constexpr const char* kAll[] = {
      QT_TR_NOOP("The scan's outline is not closed."),
      QT_TR_NOOP("A scan of fewer than 20 points has no outline."),
      QT_TR_NOOP("A contour needs at least three points."),
      QT_TR_NOOP("The evidence for a pair has no valid scans or value."),
      QT_TR_NOOP("pairing: %1 stays unpaired: %2"),
      QT_TR_NOOP("No two outlines match, so the sizes of the two sides cannot be compared; provide "
                 "a known length."),
  };
  return kAll;
}

}  // namespace ostraka::ui
