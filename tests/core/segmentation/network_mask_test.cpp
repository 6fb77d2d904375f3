#include "segmentation/network_mask.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "files/files.h"

namespace ostraka::segmentation {
namespace {

// Just enough of protocol buffers to write a network of one 1 x 1 convolution by hand.
std::string varint(std::uint64_t v) {
  std::string out;
  for (; v >= 0x80; v >>= 7) out += static_cast<char>(v | 0x80);
  return out + static_cast<char>(v);
}
std::string number(int field, std::uint64_t v) {
  return varint(field << 3) + varint(v);
}
std::string bytes(int field, const std::string& s) {
  return varint(field << 3 | 2) + varint(s.size()) + s;
}
std::string floats(const std::vector<float>& values) {
  std::string raw(values.size() * 4, '\0');
  std::memcpy(raw.data(), values.data(), raw.size());
  return raw;
}
std::string tensor(const std::string& name, const std::vector<int>& dims,
                   const std::vector<float>& values) {
  std::string out;
  for (const int d : dims) out += number(1, d);
  return out + number(2, 1) + bytes(8, name) + bytes(9, floats(values));
}
std::string valueInfo(const std::string& name, const std::vector<int>& dims) {
  std::string shape;
  for (const int d : dims) shape += bytes(1, d > 0 ? number(1, d) : bytes(2, "n"));
  return bytes(1, name) + bytes(2, bytes(1, number(1, 1) + bytes(2, shape)));
}

// out = weights * rgb + bias, one row of three weights per output channel.
std::filesystem::path network(const std::string& name, std::vector<float> weights,
                              std::vector<float> bias, int height, int width) {
  const int channels = static_cast<int>(bias.size());
  const std::string node =
      bytes(1, "x") + bytes(1, "w") + bytes(1, "b") + bytes(2, "y") + bytes(3, "conv") +
      bytes(4, "Conv") +
      bytes(5, bytes(1, "kernel_shape") + number(8, 1) + number(8, 1) + number(20, 7));
  const std::string graph =
      bytes(1, node) + bytes(2, "g") + bytes(5, tensor("w", {channels, 3, 1, 1}, weights)) +
      bytes(5, tensor("b", {channels}, bias)) + bytes(11, valueInfo("w", {channels, 3, 1, 1})) +
      bytes(11, valueInfo("x", {1, 3, height, width})) +
      bytes(12, valueInfo("y", {1, channels, height, width}));
  const std::string model = number(1, 7) + bytes(7, graph) + bytes(8, bytes(1, "") + number(2, 13));
  const auto path = std::filesystem::path(testing::TempDir()) / (name + ".onnx");
  EXPECT_TRUE(writeFileAtomically(path, model).has_value());
  return path;
}

// Left half red (255, 0, 0), right half blue.
cv::Mat halves(int width, int height) {
  cv::Mat picture(height, width, CV_8UC3, cv::Scalar(255, 0, 0));
  picture.colRange(0, width / 2) = cv::Scalar(0, 0, 255);
  return picture;
}

TEST(NetworkMask, OneChannelOfLogitsBecomesTheLogisticFunction) {
  // 4 R - 4 B: +4 on red, -4 on blue; logistic(4) = 0.98201, times 255 = 250.4.
  const auto onnx = network("logit", {4, 0, -4}, {0}, 32, 64);
  const auto mask = maskByNetwork(halves(64, 32), onnx);
  ASSERT_TRUE(mask.has_value()) << mask.error().sentence();
  EXPECT_EQ(mask->size(), cv::Size(64, 32));
  EXPECT_EQ((*mask)(16, 5), 250);
  EXPECT_EQ((*mask)(16, 60), 5);
}

TEST(NetworkMask, TwoChannelsOfLogitsAreBackgroundAndSherd) {
  // background = B, sherd = 3 R: differences 3 and -1; logistic 0.95257 and 0.26894.
  const auto onnx = network("softmax", {0, 0, 1, 3, 0, 0}, {0, 0}, 32, 64);
  const auto mask = maskByNetwork(halves(64, 32), onnx);
  ASSERT_TRUE(mask.has_value()) << mask.error().sentence();
  EXPECT_EQ((*mask)(16, 5), 243);
  EXPECT_EQ((*mask)(16, 60), 69);
}

TEST(NetworkMask, ProbabilitiesAreTakenAsTheyAre) {
  const auto onnx = network("probability", {0.75F, 0, 0.25F}, {0}, 32, 64);
  const auto mask = maskByNetwork(halves(64, 32), onnx);
  ASSERT_TRUE(mask.has_value()) << mask.error().sentence();
  EXPECT_EQ((*mask)(16, 5), 191);
  EXPECT_EQ((*mask)(16, 60), 64);
}

TEST(NetworkMask, TheInputSizeComesFromTheModelAndTheMaskHasThePhotographsSize) {
  const auto onnx = network("small", {4, 0, -4}, {0}, 16, 16);
  const auto mask = maskByNetwork(halves(200, 120), onnx);
  ASSERT_TRUE(mask.has_value()) << mask.error().sentence();
  EXPECT_EQ(mask->size(), cv::Size(200, 120));
  EXPECT_EQ((*mask)(60, 20), 250);
  EXPECT_EQ((*mask)(60, 180), 5);
}

TEST(NetworkMask, AFileThatIsNoNetworkIsAnErrorThatNamesIt) {
  const auto path = std::filesystem::path(testing::TempDir()) / "text.onnx";
  ASSERT_TRUE(writeFileAtomically(path, "this is no network").has_value());
  const auto mask = maskByNetwork(halves(64, 32), path);
  ASSERT_FALSE(mask.has_value());
  EXPECT_EQ(mask.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(mask.error().sentence(), testing::HasSubstr("text.onnx"));
}

TEST(NetworkMask, ThreeOutputChannelsAreRefused) {
  const auto onnx = network("three", {1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}, 32, 64);
  const auto mask = maskByNetwork(halves(64, 32), onnx);
  ASSERT_FALSE(mask.has_value());
  EXPECT_THAT(mask.error().sentence(), testing::HasSubstr("three.onnx"));
}

TEST(ShippedNetwork, FindsNothingOnBarePaper) {
  for (const cv::Size size : {cv::Size(1600, 1200), cv::Size(900, 1600), cv::Size(200, 60)}) {
    const auto found = sherdProbability(cv::Mat(size, CV_8UC3, cv::Scalar(225, 230, 235)));
    ASSERT_TRUE(found.has_value()) << found.error().sentence();
    EXPECT_LE(std::max(found->cols, found->rows), 512);
    EXPECT_LT(cv::mean(*found)[0], 10);
  }
}

TEST(ShippedNetwork, TakesColourPhotographsOnly) {
  EXPECT_FALSE(sherdProbability(cv::Mat(60, 80, CV_8UC1, cv::Scalar(0))).has_value());
  EXPECT_FALSE(sherdProbability(cv::Mat()).has_value());
}

}  // namespace
}  // namespace ostraka::segmentation
