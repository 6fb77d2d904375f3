#include "capture/label_code.h"

#define ZX_USE_UTF8 1  // texts as std::string
#include <ZXing/ReadBarcode.h>

#include <algorithm>

#include "batch/photograph.h"
#include "images/decode.h"

namespace ostraka::capture {
namespace {

std::vector<std::string> codesInGrey(const cv::Mat& grey) {
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

}  // namespace

Result<std::vector<std::string>> codesIn(std::string_view picture) {
  const Result<cv::Mat> grey = images::decodeImage(picture, images::Values::Grey, {});
  if (!grey) return grey.error();
  return codesInGrey(*grey);
}

Result<std::vector<PhotographCodes>> codesInSome(const std::vector<std::filesystem::path>& series,
                                                 std::size_t looked, const std::stop_token& stop) {
  std::vector<PhotographCodes> seen;
  const std::size_t count = std::min(looked, series.size());
  for (std::size_t k = 0; k < count; ++k) {
    if (stop.stop_requested()) return Error::cancelled();
    const std::filesystem::path& file =
        series[count == 1 ? 0 : k * (series.size() - 1) / (count - 1)];
    seen.push_back({file, {}});
    if (const Result<cv::Mat> photograph = batch::readPhotograph(file))
      seen.back().texts = codesInGrey(batch::greyOf(*photograph));
  }
  return seen;
}

}  // namespace ostraka::capture
