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
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The chosen registration method did not converge; use the default method, "
                        "or align the back by hand."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Too few fracture points for the chosen registration method; use the "
                        "default method."),
  };
  return kAll;
}

}  // namespace ostraka::ui
