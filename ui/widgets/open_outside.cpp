#include "ui/widgets/open_outside.h"

#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QUrl>

namespace ostraka::ui {

QString openOutside(const QString& path) {
  if (QDesktopServices::openUrl(QUrl::fromLocalFile(path))) return {};
  return QCoreApplication::translate(
             "Outside", "No program was found that opens %1. It is there: open it by hand.")
      .arg(QDir::toNativeSeparators(path));
}

}  // namespace ostraka::ui
