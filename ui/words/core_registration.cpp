#include <QtGlobal>

#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences sentencesOfRegistration() {
  static constexpr const char* kAll[] = {
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Fewer than 10 points of the broken edges meet; start from a better pose."),
      QT_TRANSLATE_NOOP("ostraka::Error", "No start pose was given for the registration."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The scan has no normals; export it with normals."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Fewer than 50 points lie on the fracture; scan the sherd again with its broken edge."),
  };
  return kAll;
}

}  // namespace ostraka::ui
