#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences CoreSentences::ofScan() {
  static constexpr const char* kAll[] = {
      QT_TR_NOOP(
          "A crumb of %1 mm at x %2, y %3 mm was left out; if it is a sherd, photograph it alone."),
      QT_TR_NOOP(
          "A flat object at x %1, y %2 mm was left out; it may be a marker or dirt on the plate."),
      QT_TR_NOOP("Two sherds touch at x %1, y %2 mm and were split there; leave a finger's width "
                 "between sherds."),
      QT_TR_NOOP("The plate's point cloud has no normals."),
      QT_TR_NOOP("No sherd was found on the front side; check its masks and photographs."),
      QT_TR_NOOP("No sherd was found on the back side; check its masks and photographs."),
      QT_TR_NOOP("An object of %1 % of the typical sherd's length was left out of the front side; "
                 "without a scale, it may be a sherd."),
      QT_TR_NOOP("An object of %1 % of the typical sherd's length was left out of the back side; "
                 "without a scale, it may be a sherd."),
      QT_TR_NOOP("If it is one, photograph it alone."),
  };
  return kAll;
}

}  // namespace ostraka::ui
