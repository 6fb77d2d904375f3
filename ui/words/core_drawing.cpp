#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences CoreSentences::ofDrawing() {
  static constexpr const char* kAll[] = {
      QT_TR_NOOP("No part of the edge can be a rim; draw this sherd without a rim."),
      QT_TR_NOOP("The edge taken as the lip barely resembles one (%1 %), so no diameter is given; "
                 "check the sherd's orientation."),
      QT_TR_NOOP(
          "The edge taken as the lip barely resembles one (%1 %); check the sherd's orientation."),
      QT_TR_NOOP("The edge taken as the lip may be a fracture (%1 % that it is the lip), and the "
                 "diameter may be wrong; check the sherd's orientation."),
      QT_TR_NOOP("A sheet of an earlier drawing already exists and is not overwritten; choose "
                 "another name, or delete that sheet."),
      // What drawings say beside numbers.
      QT_TR_NOOP("sherd %1 of %2"),
      QT_TR_NOOP("Ø %1 cm"),
      QT_TR_NOOP("Ø %1 cm (95 %: %2 to %3)"),
      QT_TR_NOOP("%1 % of the rim preserved"),
      QT_TR_NOOP("%1 % of the rim preserved (%2 to %3)"),
      QT_TR_NOOP("wall %1 mm"),
      QT_TR_NOOP("wall %1 mm (%2 to %3)"),
      QT_TR_NOOP("The preserved rim is too short or too straight for a diameter; check the sherd's "
                 "orientation."),
      QT_TR_NOOP("Drawn as a rim sherd, which is likely (%1 %); check it."),
      QT_TR_NOOP("This may be a rim sherd (%1 %); if it is, mark it as one and redraw it."),
      QT_TR_NOOP("The drawing's scale must lie between 1:20 and 5:1."),
      QT_TR_NOOP("A drawing needs a closed model (%1); create one with 'ostraka process'."),
      QT_TR_NOOP("A drawing needs a closed model; create one with 'ostraka process'."),
  };
  return kAll;
}

}  // namespace ostraka::ui
