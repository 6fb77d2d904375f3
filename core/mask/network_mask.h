#pragma once
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>

#include "base/result.h"

namespace ostraka::mask {

/// What the network's last layer holds. Auto looks at the values: all within [0, 1] is a
/// probability.
enum class NetworkOutput { Auto, Probability, Logit };

struct NetworkMaskOptions {
  double mean[3] = {0, 0, 0};       ///< RGB in 0..1, subtracted; 0 for a U-Net on plain pictures
  double deviation[3] = {1, 1, 1};  ///< RGB in 0..1, divided by afterwards
  int free_input_px = 1024;         ///< longer side for a network that takes any size
  int size_multiple_px = 32;        ///< of such a network's input: five halvings
  NetworkOutput output = NetworkOutput::Auto;
};

/// Width and height, pixels, at which the network takes a photograph of this size: what its file
/// (ONNX, the bytes of `model`) fixes, else as the options say. Errors: UnusableInput names `where`
/// when the network has no image input of three channels within 8192 x 8192 pixels.
Result<cv::Size> networkInputSize(std::string_view model, cv::Size photograph,
                                  const NetworkMaskOptions& options, const std::string& where);

/// Mask of one photograph (CV_8UC3, BGR) by a laboratory's own network: ONNX, one image input
/// 1 x 3 x H x W (RGB, 0..1) of fixed or free size, output 1 x 1 x h x w (sherd) or 1 x 2 x h x w
/// (background, sherd), logits or probabilities. The soft result is scaled to the photograph.
/// Errors: UnusableInput names the model and what was expected of it.
Result<cv::Mat1b> maskByNetwork(const cv::Mat& photograph, const std::filesystem::path& onnx,
                                const NetworkMaskOptions& options);

}  // namespace ostraka::mask
