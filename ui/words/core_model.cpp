#include <QtGlobal>

#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences sentencesOfModel() {
  static constexpr const char* kAll[] = {
      QT_TRANSLATE_NOOP("ostraka::Error", "The front scan holds no points."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The front scan has no normals; a model needs to know what is outside."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The back scan holds no points."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The back scan has no normals; a model needs to know what is outside."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The scans enclose no body; their normals may point inward."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Only a closed mesh can be thinned out."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The deviation of a thinner mesh must be above 0 mm."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The scan is too large for a model at this spacing; give a larger one."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The scans hold too few points that agree with each other for a model."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Edge %1 is used more than once in the same direction."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Edge %1 has a face on one side only."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Vertex %1 belongs to no face."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Vertex %1 holds two fans of faces together."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The mesh has no faces."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A face names a vertex that is not there."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A face has the same vertex twice."),
  };
  return kAll;
}

}  // namespace ostraka::ui
