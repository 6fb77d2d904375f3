#include "ui/map/qr_code.h"

#include <qrencode.h>

#include <memory>

namespace ostraka::ui {

QImage qrCode(const QString& text) {
  // Capitals, digits and - . / : only need 5.5 bits each: the code stays small.
  const std::unique_ptr<QRcode, decltype(&QRcode_free)> code(
      QRcode_encodeString(text.toUtf8().constData(), 0, QR_ECLEVEL_M, QR_MODE_8, 1), &QRcode_free);
  if (!code) return {};
  QImage image(code->width, code->width, QImage::Format_Grayscale8);
  for (int y = 0; y < code->width; ++y)
    for (int x = 0; x < code->width; ++x)
      image.scanLine(y)[x] = (code->data[y * code->width + x] & 1) != 0 ? 0 : 255;
  return image;
}

}  // namespace ostraka::ui
