#include <QtGlobal>

#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences sentencesOfDrawing() {
  static constexpr const char* kAll[] = {
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "No stretch of the edge can be a piece of a rim; draw this sherd as one without a rim."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "What was taken for the lip hardly looks like one (%1 %), so no diameter "
                        "is stated; check how the sherd stands."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "What was taken for the lip hardly looks like one (%1 %); check how the "
                        "sherd stands."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "What was taken for the lip may be a break (%1 % that it is the lip), and "
                        "the diameter wrong; check how the sherd stands."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "A sheet of an earlier drawing is there and is not overwritten; choose "
                        "another name, or remove it."),
      // What drawings say beside numbers.
      QT_TRANSLATE_NOOP("ostraka::Error", "sherd %1 of %2"),
      QT_TRANSLATE_NOOP("ostraka::Error", "Ø %1 cm"),
      QT_TRANSLATE_NOOP("ostraka::Error", "Ø %1 cm (95 %: %2 to %3)"),
      QT_TRANSLATE_NOOP("ostraka::Error", "%1 % of the rim kept"),
      QT_TRANSLATE_NOOP("ostraka::Error", "%1 % of the rim kept (%2 to %3)"),
      QT_TRANSLATE_NOOP("ostraka::Error", "wall %1 mm"),
      QT_TRANSLATE_NOOP("ostraka::Error", "wall %1 mm (%2 to %3)"),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The piece of the rim is too short or too straight for a diameter; check "
                        "how the sherd stands."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Drawn as a rim, which is likely (%1 %); check it."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "May be a rim (%1 %); if it is one, say so and draw it again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The drawing's scale must lie between 1:20 and 5:1."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "A drawing needs a closed model (%1); make it with 'ostraka process'."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "A drawing needs a closed model; make it with 'ostraka process'."),
  };
  return kAll;
}

}  // namespace ostraka::ui
