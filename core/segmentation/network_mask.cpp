#include "segmentation/network_mask.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/limits.h"
#include "base/message.h"
#include "files/files.h"
#include "segmentation/shipped_network.h"

namespace ostraka::segmentation {
namespace {

/// One field of a protocol buffer message: a number, or a run of bytes.
struct Field {
  std::uint32_t number = 0;
  std::uint64_t value = 0;
  std::string_view bytes;
};

std::optional<std::uint64_t> readVarint(std::string_view& text) {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64 && !text.empty(); shift += 7) {
    const auto byte = static_cast<unsigned char>(text.front());
    text.remove_prefix(1);
    value |= static_cast<std::uint64_t>(byte & 0x7F) << shift;
    if ((byte & 0x80) == 0) return value;
  }
  return std::nullopt;
}

// The message's fields in order; stops at the first that is broken.
std::vector<Field> fieldsOf(std::string_view text) {
  std::vector<Field> fields;
  while (!text.empty()) {
    const auto key = readVarint(text);
    if (!key) break;
    Field field{static_cast<std::uint32_t>(*key >> 3), 0, {}};
    std::size_t length = 0;
    switch (*key & 7) {
      case 0: {
        const auto value = readVarint(text);
        if (!value) return fields;
        field.value = *value;
        break;
      }
      case 1:
        length = 8;
        break;
      case 5:
        length = 4;
        break;
      case 2: {
        const auto size = readVarint(text);
        if (!size || *size > text.size()) return fields;
        length = static_cast<std::size_t>(*size);
        break;
      }
      default:
        return fields;
    }
    if (length > text.size()) return fields;
    field.bytes = text.substr(0, length);
    text.remove_prefix(length);
    fields.push_back(field);
  }
  return fields;
}

constexpr std::int64_t kMaxInputPx = 8192;  // 800 MB as three channels of float
// Of a network that takes any size: the longer side, and what both are multiples of (five
// halvings).
constexpr int kFreeInput_px = 1024, kFreeMultiple_px = 32;

/// Shape of the model's image input; -1 where it is free.
using InputShape = std::vector<std::int64_t>;

// ONNX: ModelProto.graph = 7; GraphProto.initializer = 5, input = 11; TensorProto.name = 8;
// ValueInfoProto.name = 1, type = 2; TypeProto.tensor_type = 1; Tensor.shape = 2; dim = 1; value
// = 1.
std::optional<InputShape> inputShapeOf(std::string_view model) {
  for (const Field& graph : fieldsOf(model)) {
    if (graph.number != 7) continue;
    std::set<std::string_view> weights;
    for (const Field& tensor : fieldsOf(graph.bytes))
      if (tensor.number == 5)
        for (const Field& part : fieldsOf(tensor.bytes))
          if (part.number == 8) weights.insert(part.bytes);
    for (const Field& input : fieldsOf(graph.bytes)) {
      if (input.number != 11) continue;
      std::string_view name;
      InputShape shape;
      for (const Field& part : fieldsOf(input.bytes)) {
        if (part.number == 1) name = part.bytes;
        if (part.number != 2) continue;
        for (const Field& type : fieldsOf(part.bytes))
          for (const Field& tensor : fieldsOf(type.bytes)) {
            if (type.number != 1 || tensor.number != 2) continue;
            for (const Field& dim : fieldsOf(tensor.bytes)) {
              std::int64_t size = -1;
              for (const Field& value : fieldsOf(dim.bytes))
                if (value.number == 1) size = static_cast<std::int64_t>(value.value);
              shape.push_back(size > 0 ? size : -1);
            }
          }
      }
      if (!weights.contains(name)) return shape;
    }
  }
  return std::nullopt;
}

Error unusable(const std::string& onnx, const std::string& what) {
  return Error::unusable(
      what +
          "; expected an ONNX network that takes 1 x 3 x H x W and gives 1 x 1 x h x w or "
          "1 x 2 x h x w.",
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

Result<cv::Mat1f> probability(const cv::Mat& photograph, std::string_view model,
                              const std::string& where) {
  if (photograph.type() != CV_8UC3 || photograph.empty())
    return Error::unusable(message("The network needs an 8-bit colour photograph."));
  const Result<cv::Size> size = networkInputSize(model, photograph.size(), where);
  if (!size) return size.error();
  cv::Mat output;
  try {
    cv::dnn::Net net = cv::dnn::readNetFromONNX(model.data(), model.size());
    net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    net.setInput(pictureBlob(photograph, *size));
    output = net.forward();
  } catch (const cv::Exception& problem) {
    return unusable(where, "The network cannot be run (" + problem.err + ")");
  }
  if (output.dims != 4 || output.type() != CV_32F || output.size[0] != 1 || output.size[1] < 1 ||
      output.size[1] > 2 || output.size[2] < 1 || output.size[3] < 1)
    return unusable(where, "The network's output has another shape");
  if (!cv::checkRange(output.reshape(1, 1)))
    return unusable(where, "The network's output contains numbers that are not finite");
  return probabilityOf(output);
}

cv::Mat1b inBytes(const cv::Mat1f& probability) {
  cv::Mat1b mask;
  probability.convertTo(mask, CV_8U, 255);
  return mask;
}

}  // namespace

Result<cv::Size> networkInputSize(std::string_view model, cv::Size photograph,
                                  const std::string& where) {
  const std::optional<InputShape> shape = inputShapeOf(model);
  if (!shape || shape->size() != 4)
    return unusable(where, "The network does not take an image as input");
  const std::int64_t channels = (*shape)[1], rows = (*shape)[2], columns = (*shape)[3];
  if (channels > 0 && channels != 3)
    return unusable(where, "The network takes " + std::to_string(channels) + " channels");
  if (rows > kMaxInputPx || columns > kMaxInputPx)
    return unusable(where, "The network's input is larger than 8192 pixels");
  const double scale = std::min(
      1.0, static_cast<double>(kFreeInput_px) / std::max(photograph.width, photograph.height));
  const auto free = [&](int length) {
    return std::max(
        kFreeMultiple_px,
        kFreeMultiple_px * static_cast<int>(std::lround(length * scale / kFreeMultiple_px)));
  };
  return cv::Size(columns > 0 ? static_cast<int>(columns) : free(photograph.width),
                  rows > 0 ? static_cast<int>(rows) : free(photograph.height));
}

Result<cv::Mat1b> maskByNetwork(const cv::Mat& photograph, const std::filesystem::path& onnx) {
  const Result<std::string> model = readFile(onnx, limits::kNetworkBytes.most);
  if (!model) return model.error();
  const Result<cv::Mat1f> sherd = probability(photograph, *model, onnx.string());
  if (!sherd) return sherd.error();
  cv::Mat1f scaled;
  cv::resize(*sherd, scaled, photograph.size(), 0, 0, cv::INTER_LINEAR);
  return inBytes(scaled);
}

Result<cv::Mat1b> sherdProbability(const cv::Mat& photograph) {
  const Result<cv::Mat1f> sherd = probability(photograph, shippedNetwork(), "sherds.onnx");
  if (!sherd) return sherd.error();
  return inBytes(*sherd);
}

}  // namespace ostraka::segmentation
