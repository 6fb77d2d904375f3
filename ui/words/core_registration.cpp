#include <QtGlobal>

#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences sentencesOfRegistration() {
  static constexpr const char* kAll[] = {
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Fewer than 10 fracture points match; start from a better pose."),
      QT_TRANSLATE_NOOP("ostraka::Error", "No start pose was given for the registration."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The scan has no normals; export it with normals."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Fewer than 50 points lie on the fracture; rescan the sherd including its fracture."),
  };
  return kAll;
}

}  // namespace ostraka::ui
