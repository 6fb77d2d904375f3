#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences CoreSentences::ofMask() {
  static constexpr const char* kAll[] = {
      QT_TR_NOOP("The photographs show no common object; check the cameras, or provide masks."),
      QT_TR_NOOP("Each photograph needs one pose."),
      QT_TR_NOOP("A visual hull needs at least 3 photographs; photograph the object from more "
                 "directions."),
      QT_TR_NOOP("The cameras do not view a common area; check their poses."),
      QT_TR_NOOP("The network needs an 8-bit colour photograph."),
      QT_TR_NOOP("The mask is missing; expected a mask of %1 x %2 pixels under this name."),
      QT_TR_NOOP("The mask cannot be read as a picture; expected a mask of %1 x %2 pixels."),
      QT_TR_NOOP("The mask has %1 x %2 pixels; expected a mask of %3 x %4 pixels, the size of its "
                 "photograph."),
      QT_TR_NOOP(
          "Masks from the plate need at least 3 photographs of a side; photograph more positions."),
      QT_TR_NOOP("The photograph differs in size from its camera's images; use the original file."),
      QT_TR_NOOP("No sherd was found on the plate; check that the photographs show sherds that "
                 "stand out from the plate, or provide masks."),
      QT_TR_NOOP("masks: the empty-plate photograph of camera %1 differs in size from the camera's "
                 "other photographs; masks are made without it"),
      QT_TR_NOOP("masks: the empty-plate photograph of camera %1 shows the plate at none of the "
                 "positions; retake it at the first; masks are made without it"),
      QT_TR_NOOP("masks: the empty-plate photograph of camera %1 shows covered markers in %2; "
                 "uncover them; masks are made without it"),
      QT_TR_NOOP(
          "masks: a shadow that the other photographs do not show falls on the plate in %1; keep "
          "people and hands out of the light, and retake these if their masks look wrong"),
      QT_TR_NOOP("%1 (%2 % of the bare plate)"),
      QT_TR_NOOP("masks: flat things that look like labels or scale bars are left out (%1); if "
                 "there are sherds among them, add them to the masks"),
  };
  return kAll;
}

}  // namespace ostraka::ui
