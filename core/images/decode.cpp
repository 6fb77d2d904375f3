#include "images/decode.h"

#include <opencv2/imgproc.hpp>

#include "images/heif_image.h"
#include "images/image_header.h"
#include "images/jpeg_image.h"
#include "images/png_image.h"
#include "images/raw_image.h"
#include "images/tiff_image.h"

namespace ostraka::images {
namespace {

Result<cv::Mat> greyed(Result<cv::Mat> image, Values values) {
  if (image && values == Values::Grey && image->channels() == 3) {
    cv::Mat grey;
    cv::cvtColor(*image, grey, cv::COLOR_BGR2GRAY);
    *image = grey;
  }
  return image;
}

}  // namespace

Result<cv::Mat> decodeImage(std::string_view bytes, Values values, const std::string& where) {
  // What a RAW file's own size is comes out only with its values, which takes as long again.
  if (hasRawEnding(where)) return greyed(decodeRaw(bytes, where), values);
  const Result<ImageSize> size = imageSize(bytes, where);
  if (!size) return size.error();
  Result<cv::Mat> image = isHeif(bytes)   ? greyed(decodeHeif(bytes, where), values)
                          : isJpeg(bytes) ? decodeJpeg(bytes, *size, values, where)
                          : isPng(bytes)  ? decodePng(bytes, values, where)
                                          : decodeTiff(bytes, values, where);
  if (!image) return image;
  if (image->cols != size->width || image->rows != size->height) return undecodableImage(where);
  return image;
}

}  // namespace ostraka::images
