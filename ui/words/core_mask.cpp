#include <QtGlobal>

#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences sentencesOfMask() {
  static constexpr const char* kAll[] = {
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "No body was found that the photographs agree on; check the cameras, or give masks."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Each photograph needs one pose."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "A hull needs at least 3 photographs; photograph the thing from more sides."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The cameras do not look at a common place; check their poses."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The network needs a colour photograph of 8 bits."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The mask is missing; expected a mask of %1 x %2 pixels under this name."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The mask cannot be read as a picture; expected a mask of %1 x %2 pixels."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The mask has %1 x %2 pixels; expected a mask of %3 x %4 pixels, the size "
                        "of its photograph."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Masks from the plate need at least 3 photographs of a side; photograph more stops."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The photograph is not of the size that its camera has; use the original file."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "No sherd was found on the plate; check that the photographs show sherds "
                        "that differ from the plate, or give masks."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "masks: the empty plate of camera %1 has another size than the camera's "
                        "photographs; masked without it"),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "masks: the empty plate of camera %1 shows the plate at none of the stops; "
                        "take it again at the first; masked without it"),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "masks: the empty plate of camera %1 shows markers that something covers "
                        "in %2; take off what lies on them; masked without it"),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "masks: a shadow that the other photographs do not have lies on the plate in %1; keep "
          "people and hands out of the light, and take these again if their masks look wrong"),
      QT_TRANSLATE_NOOP("ostraka::Error", "%1 (%2 % of the bare plate)"),
  };
  return kAll;
}

}  // namespace ostraka::ui
