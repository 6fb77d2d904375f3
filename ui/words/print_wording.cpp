#include "ui/words/print_wording.h"

#include <QLocale>

#include "ui/words/sentence.h"

namespace ostraka::ui {

drawing::Wording printWording() {
  return {[](const std::string& english) { return wordsOf(english).toStdString(); },
          QLocale().decimalPoint().toStdString()};
}

}  // namespace ostraka::ui
