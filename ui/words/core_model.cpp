#include <QtGlobal>

#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences sentencesOfModel() {
  static constexpr const char* kAll[] = {
      QT_TRANSLATE_NOOP("ostraka::Error", "The front scan contains no points."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The front scan has no normals; a model needs them to tell outside from inside."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The back scan contains no points."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The back scan has no normals; a model needs them to tell outside from inside."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The scans do not enclose a volume; their normals may point inward."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Only a closed mesh can be simplified."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The deviation of a simplified mesh must be above 0 mm."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The scan is too large for a model at this spacing; use a larger spacing."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The scans contain too few points that agree with each other for a model."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Edge %1 is used more than once in the same direction."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Edge %1 has a face on one side only."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Vertex %1 belongs to no face."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Vertex %1 joins two separate fans of faces."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The mesh has no faces."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A face refers to a vertex that does not exist."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A face has the same vertex twice."),
      QT_TRANSLATE_NOOP("ostraka::Error", "No photograph shows the sherd."),
  };
  return kAll;
}

}  // namespace ostraka::ui
