#include "ui/words/print_wording.h"

#include <QLocale>

#include "ui/words/sentence.h"

namespace ostraka::ui {

drawing::Wording printWording() {
  return {[](const Message& words) { return wordsOf(words).toStdString(); },
          QLocale().decimalPoint().toStdString()};
}

}  // namespace ostraka::ui
