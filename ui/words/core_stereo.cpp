#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences CoreSentences::ofStereo() {
  static constexpr const char* kAll[] = {
      QT_TR_NOOP("This COLMAP was built without CUDA, which its dense stereo needs; install one "
                 "with CUDA, or use --dense builtin, which needs neither."),
      QT_TR_NOOP("The masks of the views show no common object; check masks, cameras and bounds."),
      QT_TR_NOOP("InterfaceCOLMAP wrote no scene; its output is in this file."),
      QT_TR_NOOP("Stereo needs at least 3 photographs with known cameras."),
      QT_TR_NOOP("The photograph or its mask differs in size from its camera's images; use "
                 "photographs of the size that the camera was calibrated with."),
      QT_TR_NOOP("The photograph differs in size from the images that its camera was calibrated "
                 "with; use the original photograph."),
      QT_TR_NOOP("The mask and its photograph differ in size."),
      QT_TR_NOOP("%1 found no points of the object; its output is in this file, and --dense "
                 "builtin needs no other program."),
      QT_TR_NOOP(
          "%1 wrote points without normals; install a newer version, or use --dense builtin."),
      QT_TR_NOOP("The program %1 is not on the PATH, but --dense %2 needs it; install it, or use "
                 "--dense builtin, which needs no other program."),
      QT_TR_NOOP("No two views agree on any surface point; check cameras and masks."),
  };
  return kAll;
}

}  // namespace ostraka::ui
