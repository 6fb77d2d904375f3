#include <QtGlobal>

#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences sentencesOfDrawing() {
  static constexpr const char* kAll[] = {
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "No part of the edge can be a rim; draw this sherd without a rim."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The edge taken as the lip barely resembles one (%1 %), so no diameter is "
                        "given; check the sherd's orientation."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The edge taken as the lip barely resembles one (%1 %); check the sherd's orientation."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The edge taken as the lip may be a fracture (%1 % that it is the lip), "
                        "and the diameter may be wrong; check the sherd's orientation."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "A sheet of an earlier drawing already exists and is not overwritten; "
                        "choose another name, or delete that sheet."),
      // What drawings say beside numbers.
      QT_TRANSLATE_NOOP("ostraka::Error", "sherd %1 of %2"),
      QT_TRANSLATE_NOOP("ostraka::Error", "Ø %1 cm"),
      QT_TRANSLATE_NOOP("ostraka::Error", "Ø %1 cm (95 %: %2 to %3)"),
      QT_TRANSLATE_NOOP("ostraka::Error", "%1 % of the rim preserved"),
      QT_TRANSLATE_NOOP("ostraka::Error", "%1 % of the rim preserved (%2 to %3)"),
      QT_TRANSLATE_NOOP("ostraka::Error", "wall %1 mm"),
      QT_TRANSLATE_NOOP("ostraka::Error", "wall %1 mm (%2 to %3)"),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The preserved rim is too short or too straight for a diameter; check the "
                        "sherd's orientation."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Drawn as a rim sherd, which is likely (%1 %); check it."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This may be a rim sherd (%1 %); if it is, mark it as one and redraw it."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The drawing's scale must lie between 1:20 and 5:1."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "A drawing needs a closed model (%1); create one with 'ostraka process'."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "A drawing needs a closed model; create one with 'ostraka process'."),
  };
  return kAll;
}

}  // namespace ostraka::ui
