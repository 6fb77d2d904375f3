#include "ui/wizard/doubt_words.h"

#include "ui/wizard/capture_wizard.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {

QStringList doubtsOf(const std::vector<Message>& sentences) {
  QStringList all;
  for (const Message& sentence : sentences) all << wordsOf(sentence);
  return all;
}

// Hidden, touching another, in the hand still, broken, or a pebble: only a person knows.
QString countDoubt(const capture::SideCheck& check, int counted) {
  if (counted == 0 || !check.counted || check.sherds == counted) return {};
  const QString words =
      check.sherds < counted
          ? CaptureWizard::tr(
                "You counted %1 sherds, the photographs show %2: look for one that is hidden, "
                "touches another or was never laid down.")
          : CaptureWizard::tr(
                "You counted %1 sherds, the photographs show %2: check whether one is in "
                "fragments or an object is not a sherd, or correct the count.");
  return words.arg(counted).arg(check.sherds);
}

}  // namespace ostraka::ui
