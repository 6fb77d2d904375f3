#include "ui/map/asked_print.h"

#include <QPrintDialog>
#include <QPrinter>
#include <memory>
#include <utility>

#include "files/output_place.h"
#include "ui/map/map_screen.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {

void askToPrint(QWidget* parent, const QString& name, const QString& sent,
                std::function<bool(QPrinter& printer, QString* why)> paint,
                std::function<void(const QString& sentence)> say) {
  auto own = std::make_shared<QPrinter>();
  own->setDocName(name);
  auto* dialog = new QPrintDialog(own.get(), parent);  // knows printing into a PDF file, too
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  QObject::connect(dialog, qOverload<QPrinter*>(&QPrintDialog::accepted), parent,
                   [sent, paint = std::move(paint), say = std::move(say), own](QPrinter* printer) {
                     const QString file = printer->outputFileName();
                     if (const Result<void> good = checkOutputPlace(file.toStdString()); !good)
                       return say(sentenceOf(good.error()));
                     QString why;
                     say(!paint(*printer, &why) ? why
                         : file.isEmpty()       ? sent
                                                : MapScreen::tr("Saved: %1").arg(file));
                   });
  dialog->open();
}

}  // namespace ostraka::ui
