#include "segmentation/network_mask.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <new>
#include <numeric>
#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/limits.h"
#include "base/message.h"
#include "files/files.h"
#include "segmentation/onnx_file.h"
#include "segmentation/shipped_network.h"

namespace ostraka::segmentation {
namespace {

constexpr std::int64_t kMaxInputPx = 8192;  // 800 MB as three channels of float
// Of a network that takes any size: the longer side, and what both are multiples of (five
// halvings).
constexpr int kFreeInput_px = 1024, kFreeMultiple_px = 32;
// Ostraka's own also looks at a finer picture: at 1024 pixels it sees large things whole, at 1600
// its outlines are sharper. So the mean of both counts along the coarse outlines, this many pixels
// of the coarse result to either side (docs/experiments.md).
constexpr int kFineInput_px = 1600, kAlongOutline_px = 2;

Error unusable(const std::string& onnx, const Message& why) {
  return Error::unusable(
      message(
          "This network cannot be used: %1. Choose an ONNX network that takes 1 x 3 x H x W and "
          "gives 1 x 1 x h x w or 1 x 2 x h x w.",
          why),
      onnx);
}

cv::Mat pictureBlob(const cv::Mat& photograph, cv::Size size) {
  cv::Mat small, rgb;
  cv::resize(photograph, small, size, 0, 0,
             size.width < photograph.cols ? cv::INTER_AREA : cv::INTER_LINEAR);
  cv::cvtColor(small, rgb, cv::COLOR_BGR2RGB);
  rgb.convertTo(rgb, CV_32FC3, 1 / 255.0);
  return cv::dnn::blobFromImage(rgb);
}

// Probability of sherd from one or two channels of the network's output.
cv::Mat1f probabilityOf(const cv::Mat& output) {
  const int channels = output.size[1], rows = output.size[2], columns = output.size[3];
  cv::Mat first(rows, columns, CV_32F, const_cast<float*>(output.ptr<float>(0, 0)));
  cv::Mat1f sherd = first.clone();
  double least = 0, most = 0;
  cv::minMaxLoc(output.reshape(1, 1), &least, &most);
  const bool logits = least < -1e-4 || most > 1 + 1e-4;
  if (channels == 2) {
    const cv::Mat second(rows, columns, CV_32F, const_cast<float*>(output.ptr<float>(0, 1)));
    if (!logits) return second.clone();
    sherd = second - first;  // a softmax of two is the logistic function of the difference
  }
  if (logits)
    for (float& v : sherd) v = 1 / (1 + std::exp(-v));
  return sherd;
}

// Of what the layers give to one another: the most that is held at one time, as each layer's is
// until the last that reads it has run. They run in the order of their numbers. The net has its
// input already.
double heldBytes(cv::dnn::Net& net, const cv::dnn::MatShape& input) {
  net.dump();  // lays the layers out without a run: before, OpenCV 4.6 has wrong sizes for some
  std::vector<int> ids;
  std::vector<std::vector<cv::dnn::MatShape>> in, out;
  net.getLayersShapes(input, ids, in, out);
  std::map<int, std::size_t> place;
  for (std::size_t i = 0; i < ids.size(); ++i) place[ids[i]] = i;
  std::vector<double> bytes(ids.size(), 0.0);
  std::vector<std::size_t> last_reader(ids.size(), ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    for (const cv::dnn::MatShape& shape : out[i])
      bytes[i] += std::accumulate(shape.begin(), shape.end(), double{sizeof(float)},
                                  [](double product, int side) { return product * side; });
    for (const cv::Ptr<cv::dnn::Layer>& read : net.getLayerInputs(ids[i]))
      if (const auto found = place.find(net.getLayerId(read->name)); found != place.end())
        last_reader[found->second] = i;
  }
  double held = 0, most = 0;
  std::vector<double> read_last(ids.size() + 1, 0.0);
  for (std::size_t i = 0; i < ids.size(); ++i) read_last[last_reader[i]] += bytes[i];
  for (std::size_t i = 0; i < ids.size(); ++i) {
    held += bytes[i];
    most = std::max(most, held);
    held -= read_last[i];
  }
  return most;
}

// What OpenCV throws while it reads, lays out or runs a network, as a refusal.
template <typename Act>
auto orUnusable(const std::string& where, Act&& act) -> decltype(act()) {
  try {
    return act();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const cv::Exception& problem) {
    return unusable(where, message("it cannot be run (%1)", problem.err));
  } catch (const std::exception& problem) {  // of protobuf
    return unusable(where, message("it cannot be run (%1)", problem.what()));
  }
}

cv::Mat1b inBytes(const cv::Mat1f& probability) {
  cv::Mat1b mask;
  probability.convertTo(mask, CV_8U, 255);
  return mask;
}

// The mean of both looks along the coarse one's outlines, the coarse look elsewhere.
cv::Mat1f sharperAlongOutlines(const cv::Mat1f& coarse, const cv::Mat1f& fine) {
  const cv::Mat1b inside = coarse > 0.5;
  cv::Mat1b along;
  const int side = 2 * kAlongOutline_px + 1;
  cv::morphologyEx(inside, along, cv::MORPH_GRADIENT, cv::Mat1b::ones(side, side));
  cv::resize(along, along, fine.size(), 0, 0, cv::INTER_NEAREST);
  cv::Mat1f sharp;
  cv::resize(coarse, sharp, fine.size(), 0, 0, cv::INTER_LINEAR);
  cv::Mat1f((sharp + fine) / 2).copyTo(sharp, along);
  return sharp;
}

// Of a network that takes any size.
cv::Size freeInput(cv::Size photograph, int longer_px) {
  const double scale =
      std::min(1.0, static_cast<double>(longer_px) / std::max(photograph.width, photograph.height));
  const auto side = [&](int length) {
    return std::max(
        kFreeMultiple_px,
        kFreeMultiple_px * static_cast<int>(std::lround(length * scale / kFreeMultiple_px)));
  };
  return {side(photograph.width), side(photograph.height)};
}

}  // namespace

Result<cv::Size> networkInputSize(std::string_view model, cv::Size photograph, int longer_px,
                                  const std::string& where) {
  if (const Result<void> right = checkOnnx(model, where); !right) return right.error();
  const std::optional<InputShape> shape = inputShapeOf(model);
  if (!shape || shape->size() != 4) return unusable(where, message("its input is not an image"));
  const std::int64_t channels = (*shape)[1], rows = (*shape)[2], columns = (*shape)[3];
  if (channels > 0 && channels != 3)
    return unusable(where, message("its input has %1 channels", channels));
  if (rows > kMaxInputPx || columns > kMaxInputPx)
    return unusable(where, message("its input is larger than %1 pixels", kMaxInputPx));
  const cv::Size free = freeInput(photograph, longer_px);
  return cv::Size(columns > 0 ? static_cast<int>(columns) : free.width,
                  rows > 0 ? static_cast<int>(rows) : free.height);
}

bool looksTwice(cv::Size photograph) {
  return freeInput(photograph, kFineInput_px) != freeInput(photograph, kFreeInput_px);
}

// A network whose layers stay laid out while photographs have one size: laying them out anew, and
// memory that nobody has touched yet, cost as much as a run.
struct Network::Laid {
  cv::Size input{};
  cv::dnn::Net net;
};

Network::Network(std::string model, std::string where, int longer_px)
    : model_(std::move(model)), where_(std::move(where)), longer_px_(longer_px) {}
Network::Network(Network&&) noexcept = default;
Network& Network::operator=(Network&&) noexcept = default;
Network::~Network() = default;

Result<Network> Network::read(const std::filesystem::path& onnx) {
  Result<std::string> model = readFile(onnx, limits::kNetworkBytes.most);
  if (!model) return model.error();
  return Network(std::move(*model), onnx.string(), kFreeInput_px);
}

Result<void> Network::layOut(cv::Size input) {
  laid_.reset();  // two would take their memory at one time
  auto laid = std::make_unique<Laid>();
  laid->input = input;
  const Result<void> fits = orUnusable(where_, [&]() -> Result<void> {
    laid->net = cv::dnn::readNetFromONNX(model_.data(), model_.size());
    laid->net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    constexpr double kMost = limits::kNetworkRunBytes.most, kBytesPerGb = 1e9;
    laid->net.setInput(cv::dnn::blobFromImage(cv::Mat3f::zeros(input)));
    const double held = heldBytes(laid->net, {1, 3, input.height, input.width});
    if (held <= kMost) return {};
    return Error::unusable(
        message("The network takes %1 GB of memory for one photograph, but at most %2 GB can be "
                "used; use a smaller network, or one with a smaller input.",
                decimal(held / kBytesPerGb, 1), decimal(kMost / kBytesPerGb, 1)),
        where_);
  });
  if (!fits) return fits.error();
  laid_ = std::move(laid);
  return {};
}

Result<cv::Mat1f> Network::probability(const cv::Mat& photograph) {
  if (photograph.type() != CV_8UC3 || photograph.empty())
    return Error::unusable(message("The network needs an 8-bit colour photograph."));
  const Result<cv::Size> size = networkInputSize(model_, photograph.size(), longer_px_, where_);
  if (!size) return size.error();
  if (!laid_ || laid_->input != *size)
    if (const Result<void> laid = layOut(*size); !laid) return laid.error();
  const Result<cv::Mat> output = orUnusable(where_, [&]() -> Result<cv::Mat> {
    laid_->net.setInput(pictureBlob(photograph, *size));
    return laid_->net.forward();
  });
  if (!output) return output.error();
  if (output->dims != 4 || output->type() != CV_32F || output->size[0] != 1 ||
      output->size[1] < 1 || output->size[1] > 2 || output->size[2] < 1 || output->size[3] < 1)
    return unusable(where_, message("its output has another shape"));
  if (!cv::checkRange(output->reshape(1, 1)))
    return unusable(where_, message("its output contains numbers that are not finite"));
  return probabilityOf(*output);
}

Result<cv::Mat1b> Network::mask(const cv::Mat& photograph) {
  const Result<cv::Mat1f> sherd = probability(photograph);
  if (!sherd) return sherd.error();
  cv::Mat1f scaled;
  cv::resize(*sherd, scaled, photograph.size(), 0, 0, cv::INTER_LINEAR);
  return inBytes(scaled);
}

Result<std::vector<cv::Mat1b>> sherdProbabilities(std::span<const cv::Mat> photographs,
                                                  const std::function<void()>& looked,
                                                  const std::stop_token& stop) {
  const auto shipped = [](int longer_px) {
    return Network(std::string(shippedNetwork()), "sherds.onnx", longer_px);
  };
  std::vector<cv::Mat1b> found(photographs.size());
  std::vector<cv::Mat1f> coarse(photographs.size());
  Network network = shipped(kFreeInput_px);
  for (std::size_t i = 0; i < photographs.size(); ++i) {
    if (stop.stop_requested()) return Error::cancelled();
    Result<cv::Mat1f> seen = network.probability(photographs[i]);
    if (!seen) return seen.error();
    coarse[i] = std::move(*seen);
    if (looksTwice(photographs[i].size())) continue;
    found[i] = inBytes(coarse[i]);
    looked();
  }
  network = shipped(kFineInput_px);
  for (std::size_t i = 0; i < photographs.size(); ++i) {
    if (stop.stop_requested()) return Error::cancelled();
    if (!looksTwice(photographs[i].size())) continue;
    const Result<cv::Mat1f> fine = network.probability(photographs[i]);
    if (!fine) return fine.error();
    found[i] = inBytes(sharperAlongOutlines(coarse[i], *fine));
    looked();
  }
  return found;
}

}  // namespace ostraka::segmentation
