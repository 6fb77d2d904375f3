#include "capture/label_code.h"

#define ZX_USE_UTF8 1  // texts as std::string
#include <ZXing/ReadBarcode.h>

#include <algorithm>

#include "images/decode.h"

namespace ostraka::capture {

Result<std::vector<std::string>> codesIn(std::string_view picture) {
  const Result<cv::Mat> grey = images::decodeImage(picture, images::Values::Grey, {});
  if (!grey) return grey.error();
  ZXing::DecodeHints hints;
  hints.setFormats(ZXing::BarcodeFormat::QRCode);
  hints.setTryHarder(true);
  std::vector<std::string> codes;
  for (const ZXing::Result& found :
       ZXing::ReadBarcodes({grey->data, grey->cols, grey->rows, ZXing::ImageFormat::Lum,
                            static_cast<int>(grey->step)},
                           hints))
    if (found.isValid() && std::find(codes.begin(), codes.end(), found.text()) == codes.end())
      codes.push_back(found.text());
  return codes;
}

}  // namespace ostraka::capture
