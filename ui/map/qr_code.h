#pragma once
#include <QImage>
#include <QString>

namespace ostraka::ui {

/// A QR code of level M, one pixel a module, black on white, without its margin of four modules.
/// Null when the text does not fit.
QImage qrCode(const QString& text);

}  // namespace ostraka::ui
