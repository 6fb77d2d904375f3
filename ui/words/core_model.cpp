#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences CoreSentences::ofModel() {
  static constexpr const char* kAll[] = {
      QT_TR_NOOP("The front scan contains no points."),
      QT_TR_NOOP("The front scan has no normals; a model needs them to tell outside from inside."),
      QT_TR_NOOP("The back scan contains no points."),
      QT_TR_NOOP("The back scan has no normals; a model needs them to tell outside from inside."),
      QT_TR_NOOP("The scans do not enclose a volume; their normals may point inward."),
      QT_TR_NOOP("Only a closed mesh can be simplified."),
      QT_TR_NOOP("The deviation of a simplified mesh must be above 0 mm."),
      QT_TR_NOOP("The scan is too large for a model at this spacing; use a larger spacing."),
      QT_TR_NOOP("The scans contain too few points that agree with each other for a model."),
      QT_TR_NOOP(
          "This model is %1 mm large, more than any vessel, so its unit seems to be another; "
          "export it in mm."),
      QT_TR_NOOP("Edge %1 is used more than once in the same direction."),
      QT_TR_NOOP("Edge %1 has a face on one side only."),
      QT_TR_NOOP("Vertex %1 belongs to no face."),
      QT_TR_NOOP("Vertex %1 joins two separate fans of faces."),
      QT_TR_NOOP("The mesh has no faces."),
      QT_TR_NOOP("A face refers to a vertex that does not exist."),
      QT_TR_NOOP("A face has the same vertex twice."),
      QT_TR_NOOP("No photograph shows the sherd."),
  };
  return kAll;
}

}  // namespace ostraka::ui
