#include <QtGlobal>

#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences sentencesOfStereo() {
  static constexpr const char* kAll[] = {
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This colmap was built without CUDA, which its dense stereo needs; install "
                        "one with CUDA, or use --dense builtin, which needs nothing."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The masks of the views have no common object; check masks, cameras and bounds."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "InterfaceCOLMAP left no scene; its words are in this file."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Depth needs at least 3 photographs with known cameras."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The photograph or its mask has another size than its camera says; give "
                        "the photograph that the camera was calibrated with."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The photograph has another size than its camera says; give the photograph "
                        "that the camera was calibrated with."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The mask has another size than its photograph."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 found no points of the object; its words are in this file, and --dense "
                        "builtin needs no other program."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "%1 wrote points without normals; install a newer version, or use --dense builtin."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The program %1 is not on the PATH, but --dense %2 needs it; install it, "
                        "or use --dense builtin, which needs nothing."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "No surface point was found that two views agree on; check cameras and masks."),
  };
  return kAll;
}

}  // namespace ostraka::ui
