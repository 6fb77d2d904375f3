#include "capture/label_code.h"

#define ZX_USE_UTF8 1  // texts as std::string
#include <ZXing/ReadBarcode.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "base/message.h"

namespace ostraka::capture {

Result<std::vector<std::string>> codesIn(std::string_view picture) {
  cv::Mat1b grey;
  try {
    const cv::Mat raw(1, static_cast<int>(picture.size()), CV_8U,
                      const_cast<char*>(picture.data()));
    grey = cv::imdecode(raw, cv::IMREAD_GRAYSCALE | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    grey.release();
  }
  if (grey.empty()) return Error::unusable(message("The picture cannot be decoded."));
  ZXing::DecodeHints hints;
  hints.setFormats(ZXing::BarcodeFormat::QRCode);
  hints.setTryHarder(true);
  std::vector<std::string> codes;
  for (const ZXing::Result& found : ZXing::ReadBarcodes(
           {grey.data, grey.cols, grey.rows, ZXing::ImageFormat::Lum, static_cast<int>(grey.step)},
           hints))
    if (found.isValid() && std::find(codes.begin(), codes.end(), found.text()) == codes.end())
      codes.push_back(found.text());
  return codes;
}

}  // namespace ostraka::capture
