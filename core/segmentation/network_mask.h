#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace ostraka::segmentation {

/// Width and height, pixels, at which the network takes a photograph of this size: what its file
/// (ONNX, the bytes of `model`) fixes, else at most longer_px on the longer side, both multiples of
/// 32.
/// Errors: UnusableInput names `where` when the network has no image input of three channels within
/// 8192 x 8192 pixels, and those of checkOnnx.
Result<cv::Size> networkInputSize(std::string_view model, cv::Size photograph, int longer_px,
                                  const std::string& where);

/// A laboratory's own network (ONNX), ready for one photograph after another: one image input
/// 1 x 3 x H x W (RGB, 0..1) of fixed or free size, output 1 x 1 x h x w (sherd) or 1 x 2 x h x w
/// (background, sherd), probabilities where all its values lie within [0, 1], else logits. Works on
/// all processors, for one caller at a time.
class Network {
 public:
  /// model: the file's bytes. longer_px: as networkInputSize. where: what errors name.
  Network(std::string model, std::string where, int longer_px);
  Network(Network&&) noexcept;
  Network& operator=(Network&&) noexcept;
  ~Network();

  static Result<Network> read(const std::filesystem::path& onnx);

  /// Of sherd in a photograph (CV_8UC3, BGR), in the size that the network gives.
  /// Errors: UnusableInput names the model and what was expected of it.
  Result<cv::Mat1f> probability(const cv::Mat& photograph);
  /// The same scaled to the photograph, 0..255. Errors: as probability.
  Result<cv::Mat1b> mask(const cv::Mat& photograph);

 private:
  struct Laid;
  Result<void> layOut(cv::Size input);

  std::string model_, where_;
  int longer_px_;
  std::unique_ptr<Laid> laid_;
};

/// Probability of sherd, 0..255, by Ostraka's own network (shippedNetwork) in each photograph
/// (CV_8UC3, BGR), in the size that the network gives: at most 800 on the longer side. looked:
/// called as soon as one is known. Errors: Cancelled, UnusableInput.
Result<std::vector<cv::Mat1b>> sherdProbabilities(std::span<const cv::Mat> photographs,
                                                  const std::function<void()>& looked,
                                                  const std::stop_token& stop);
/// Whether it also looks at a finer picture, for sharper outlines: not where a photograph of this
/// size, as one of a draft, gives no finer one.
bool looksTwice(cv::Size photograph);

}  // namespace ostraka::segmentation
