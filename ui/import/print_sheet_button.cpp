#include "ui/import/print_sheet_button.h"

#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QStandardPaths>
#include <system_error>

#include "rig/printed_sheet.h"
#include "ui/look/look.h"
#include "ui/widgets/open_outside.h"

namespace ostraka::ui {
namespace {

// One of each size: the same sheet is written into the same place.
QDir sheetsFolder() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::HomeLocation) +
              QStringLiteral("/Ostraka/sheets"));
}

}  // namespace

PrintSheetButton::PrintSheetButton(const QString& name, QWidget* parent)
    : QPushButton(ostraka::ui::icon(QStringLiteral("print")), tr("Print a sheet…"), parent) {
  setObjectName(name);
  setToolTip(tr("Markers around the sherds give photographs taken by hand their scale"));
  auto* sizes = new QMenu(this);
  const auto add = [this, sizes](const QString& words, rig::SheetSize size) {
    QAction* action = sizes->addAction(words);
    action->setObjectName(words);
    connect(action, &QAction::triggered, this, [this, words, size] {
      const QString pdf = sheetsFolder().filePath(words + QStringLiteral("/sheet.pdf"));
      const Result<rig::SheetPrint> print = rig::writeSheetPrint(pdf.toStdString(), {size});
      if (!print) return emit failed(print.error());
      // The same sheet is not written again, and yet it is the last one.
      std::error_code ignored;
      std::filesystem::last_write_time(std::filesystem::path(pdf.toStdString()).parent_path(),
                                       std::filesystem::file_time_type::clock::now(), ignored);
      emit printed(
          openOutside(pdf),
          tr("Print it at 100 %, not fitted to the page, and measure the bar of the second "
             "page: it must be %1 mm long. The next import proposes this sheet. If the bar is not "
             "%1 mm long, choose Clear sheet there and type the measured side of a black square.")
              .arg(print->bar_mm));
    });
  };
  add(QStringLiteral("A4"), rig::SheetSize::A4);
  add(QStringLiteral("A3"), rig::SheetSize::A3);
  add(QStringLiteral("Letter"), rig::SheetSize::Letter);
  setMenu(sizes);
}

std::filesystem::path printedSheet() {
  const QFileInfoList folders =
      sheetsFolder().entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Time);
  for (const QFileInfo& folder : folders)
    if (const QString file = folder.filePath() + QStringLiteral("/plate.json");
        QFileInfo::exists(file))
      return file.toStdString();
  return {};
}

}  // namespace ostraka::ui
