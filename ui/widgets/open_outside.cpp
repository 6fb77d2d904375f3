#include "ui/widgets/open_outside.h"

#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QUrl>

namespace ostraka::ui {

QString openOutside(const QString& path) {
  const QString words =
      QDesktopServices::openUrl(QUrl::fromLocalFile(path))
          ? QCoreApplication::translate("Outside",
                                        "Opening %1. If it does not appear, open it by hand.")
          : QCoreApplication::translate(
                "Outside", "No program was found that opens %1. It is there: open it by hand.");
  return words.arg(QDir::toNativeSeparators(path));
}

}  // namespace ostraka::ui
