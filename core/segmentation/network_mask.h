#pragma once
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>

#include "base/result.h"

namespace ostraka::segmentation {

/// Width and height, pixels, at which the network takes a photograph of this size: what its file
/// (ONNX, the bytes of `model`) fixes, else at most longer_px on the longer side, both multiples of
/// 32.
/// Errors: UnusableInput names `where` when the network has no image input of three channels within
/// 8192 x 8192 pixels, and those of checkOnnx.
Result<cv::Size> networkInputSize(std::string_view model, cv::Size photograph, int longer_px,
                                  const std::string& where);

/// Mask of one photograph (CV_8UC3, BGR) by a laboratory's own network: ONNX, one image input
/// 1 x 3 x H x W (RGB, 0..1) of fixed or free size, output 1 x 1 x h x w (sherd) or 1 x 2 x h x w
/// (background, sherd), probabilities where all its values lie within [0, 1], else logits. The soft
/// result is scaled to the photograph.
/// Errors: UnusableInput names the model and what was expected of it.
Result<cv::Mat1b> maskByNetwork(const cv::Mat& photograph, const std::filesystem::path& onnx);

/// Probability of sherd, 0..255, by Ostraka's own network (shippedNetwork) in a photograph
/// (CV_8UC3, BGR), in the size that the network gives: at most 800 on the longer side. Works on all
/// processors. Errors: UnusableInput.
Result<cv::Mat1b> sherdProbability(const cv::Mat& photograph);

}  // namespace ostraka::segmentation
