#pragma once
#include <QString>
#include <functional>

class QPrinter;
class QWidget;

namespace ostraka::ui {

/// Asks for a printer, or for a PDF file, and paints there. name: proposed for the file. sent: what
/// is said once the pages are on their way. say: gets that, where the file is, or why nothing was
/// printed; parent: what asks.
void askToPrint(QWidget* parent, const QString& name, const QString& sent,
                std::function<bool(QPrinter& printer, QString* why)> paint,
                std::function<void(const QString& sentence)> say);

}  // namespace ostraka::ui
