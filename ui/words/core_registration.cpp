#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences CoreSentences::ofRegistration() {
  static constexpr const char* kAll[] = {
      QT_TR_NOOP("Fewer than 10 fracture points match; start from a better pose."),
      QT_TR_NOOP("No start pose was given for the registration."),
      QT_TR_NOOP("The scan has no normals; export it with normals."),
      QT_TR_NOOP(
          "Fewer than 50 points lie on the fracture; rescan the sherd including its fracture."),
      QT_TR_NOOP("The chosen registration method did not converge; use the default method, or "
                 "align the back by hand."),
      QT_TR_NOOP(
          "Too few fracture points for the chosen registration method; use the default method."),
  };
  return kAll;
}

}  // namespace ostraka::ui
