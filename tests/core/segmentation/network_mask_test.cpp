#include "segmentation/network_mask.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <opencv2/core.hpp>
#include <stop_token>
#include <string>
#include <vector>

#include "files/files.h"
#include "onnx_bytes.h"

namespace ostraka::segmentation {
namespace {

std::filesystem::path written(const std::string& name, const std::string& graph) {
  const auto path = std::filesystem::path(testing::TempDir()) / (name + ".onnx");
  EXPECT_TRUE(writeFileAtomically(path, modelOf(graph)).has_value());
  return path;
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
  return written(name, graph);
}

// Left half red (255, 0, 0), right half blue.
cv::Mat halves(int width, int height) {
  cv::Mat picture(height, width, CV_8UC3, cv::Scalar(255, 0, 0));
  picture.colRange(0, width / 2) = cv::Scalar(0, 0, 255);
  return picture;
}

Result<cv::Mat1b> maskBy(const std::filesystem::path& onnx, const cv::Mat& photograph) {
  Result<Network> network = Network::read(onnx);
  if (!network) return network.error();
  return network->mask(photograph);
}

std::string refusalOf(const std::filesystem::path& onnx) {
  const auto mask = maskBy(onnx, halves(1024, 768));
  if (mask) return "";
  EXPECT_EQ(mask.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(mask.error().sentence().english(), testing::HasSubstr(onnx.filename().string()));
  return mask.error().what.english();
}

TEST(NetworkMask, OneChannelOfLogitsBecomesTheLogisticFunction) {
  // 4 R - 4 B: +4 on red, -4 on blue; logistic(4) = 0.98201, times 255 = 250.4.
  const auto onnx = network("logit", {4, 0, -4}, {0}, 32, 64);
  const auto mask = maskBy(onnx, halves(64, 32));
  ASSERT_TRUE(mask.has_value()) << mask.error().sentence();
  EXPECT_EQ(mask->size(), cv::Size(64, 32));
  EXPECT_EQ((*mask)(16, 5), 250);
  EXPECT_EQ((*mask)(16, 60), 5);
}

TEST(NetworkMask, TwoChannelsOfLogitsAreBackgroundAndSherd) {
  // background = B, sherd = 3 R: differences 3 and -1; logistic 0.95257 and 0.26894.
  const auto onnx = network("softmax", {0, 0, 1, 3, 0, 0}, {0, 0}, 32, 64);
  const auto mask = maskBy(onnx, halves(64, 32));
  ASSERT_TRUE(mask.has_value()) << mask.error().sentence();
  EXPECT_EQ((*mask)(16, 5), 243);
  EXPECT_EQ((*mask)(16, 60), 69);
}

TEST(NetworkMask, ProbabilitiesAreTakenAsTheyAre) {
  const auto onnx = network("probability", {0.75F, 0, 0.25F}, {0}, 32, 64);
  const auto mask = maskBy(onnx, halves(64, 32));
  ASSERT_TRUE(mask.has_value()) << mask.error().sentence();
  EXPECT_EQ((*mask)(16, 5), 191);
  EXPECT_EQ((*mask)(16, 60), 64);
}

TEST(NetworkMask, TheInputSizeComesFromTheModelAndTheMaskHasThePhotographsSize) {
  const auto onnx = network("small", {4, 0, -4}, {0}, 16, 16);
  const auto mask = maskBy(onnx, halves(200, 120));
  ASSERT_TRUE(mask.has_value()) << mask.error().sentence();
  EXPECT_EQ(mask->size(), cv::Size(200, 120));
  EXPECT_EQ((*mask)(60, 20), 250);
  EXPECT_EQ((*mask)(60, 180), 5);
}

// Laid out for one size, then another, then the first again: as a network fresh from its file.
TEST(NetworkMask, PhotographsOfOtherSizesInBetweenChangeNothing) {
  const auto onnx = network("sizes", {4, 0, -4}, {0}, 0, 0);
  Result<Network> ready = Network::read(onnx);
  ASSERT_TRUE(ready.has_value()) << ready.error().sentence();
  for (const cv::Size size : {cv::Size(64, 32), cv::Size(96, 64), cv::Size(64, 32)}) {
    const auto mask = ready->mask(halves(size.width, size.height));
    ASSERT_TRUE(mask.has_value()) << mask.error().sentence();
    EXPECT_EQ(mask->size(), size);
    EXPECT_EQ((*mask)(16, 5), 250);
    EXPECT_EQ((*mask)(16, size.width - 5), 5);
  }
}

TEST(NetworkMask, AFileThatIsNoNetworkIsAnErrorThatNamesIt) {
  const auto path = std::filesystem::path(testing::TempDir()) / "text.onnx";
  ASSERT_TRUE(writeFileAtomically(path, "this is no network").has_value());
  const auto mask = maskBy(path, halves(64, 32));
  ASSERT_FALSE(mask.has_value());
  EXPECT_EQ(mask.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(mask.error().sentence(), testing::HasSubstr("text.onnx"));
}

TEST(NetworkMask, ThreeOutputChannelsAreRefused) {
  const auto onnx = network("three", {1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}, 32, 64);
  const auto mask = maskBy(onnx, halves(64, 32));
  ASSERT_FALSE(mask.has_value());
  EXPECT_THAT(mask.error().sentence(), testing::HasSubstr("three.onnx"));
}

// Two convolutions of 1 x 1: 3 to 2048 to 1 channels. 1024 x 768 x 2048 floats are 6.4 GB.
TEST(NetworkMask, ANetworkThatTakesMoreMemoryThanTheLimitIsRefusedBeforeItRuns) {
  const auto wide = [](int channels) {
    const std::vector<float> weights(static_cast<std::size_t>(channels) * 3, 0.01F);
    return bytes(5, tensor("a", {channels, 3, 1, 1}, weights)) +
           bytes(5, tensor("b", {1, channels, 1, 1}, std::vector<float>(channels, 0.01F)));
  };
  const std::string nodes = convolution("x", "a", "h") + convolution("h", "b", "y");
  EXPECT_THAT(refusalOf(written("wide", nodes + wide(2048) + freeInputAndOutput())),
              testing::HasSubstr("takes 6.5 GB of memory"));
  EXPECT_EQ(refusalOf(written("narrow", nodes + wide(8) + freeInputAndOutput())), "");
}

// OpenCV reads as many weights as the shape says.
TEST(NetworkMask, WeightsThatAreNotAllThereAreRefused) {
  for (const std::vector<int>& dims : std::vector<std::vector<int>>{
           {33'000'000, 3, 1, 1}, {512, 3, 1, 1}, {1, 1, 1, 1, 2}, {1, 0, 1, 1}})
    EXPECT_THAT(
        refusalOf(written("short", convolution("x", "w", "y") +
                                       bytes(5, tensor("w", dims, {0.5F})) + freeInputAndOutput())),
        testing::HasSubstr("damaged"));
  // Nothing is what the shape says, but no convolution's weights.
  EXPECT_THAT(refusalOf(written("none", convolution("x", "w", "y") +
                                            bytes(5, tensor("w", {1, 0, 1, 1}, {})) +
                                            freeInputAndOutput())),
              testing::HasSubstr("damaged"));
  EXPECT_THAT(refusalOf(written("elsewhere", convolution("x", "w", "y") +
                                                 bytes(5, number(1, 3) + number(2, 1) +
                                                              bytes(8, "w") + number(14, 1)) +
                                                 freeInputAndOutput())),
              testing::HasSubstr("in another file"));
}

TEST(NetworkMask, SettingsThatOpenCvDividesByAreRefused) {
  const std::string weights = bytes(5, tensor("w", {1, 3, 1, 1}, {1, 0, 0}));
  const auto with = [&](const std::string& setting) {
    return written("setting", convolution("x", "w", "y", setting) + weights + freeInputAndOutput());
  };
  EXPECT_THAT(refusalOf(with(bytes(1, "group") + number(3, 0) + number(20, 2))),
              testing::HasSubstr("'group' 0"));
  EXPECT_THAT(refusalOf(with(bytes(1, "strides") + number(8, 1) + number(8, 0) + number(20, 7))),
              testing::HasSubstr("'strides' 0"));
  EXPECT_THAT(
      refusalOf(with(bytes(1, "dilations") + bytes(8, varint(1) + varint(5000)) + number(20, 7))),
      testing::HasSubstr("'dilations' 5000"));
  EXPECT_EQ(refusalOf(with(bytes(1, "strides") + number(8, 1) + number(8, 1) + number(20, 7))), "");
}

// protobuf throws an exception of its own.
TEST(NetworkMask, ALayerWithoutAnInputIsRefused) {
  const std::string node = bytes(1, bytes(2, "y") + bytes(3, "n") + bytes(4, "Transpose"));
  EXPECT_THAT(refusalOf(written("transpose", node + freeInputAndOutput())),
              testing::HasSubstr("cannot be run"));
}

// Three sizes in one series: large, upright, small enough for one look.
TEST(ShippedNetwork, FindsNothingOnBarePaper) {
  std::vector<cv::Mat> bare;
  for (const cv::Size size : {cv::Size(1600, 1200), cv::Size(900, 1600), cv::Size(200, 60)})
    bare.emplace_back(size, CV_8UC3, cv::Scalar(225, 230, 235));
  const auto found = sherdProbabilities(bare, [] {}, {});
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  ASSERT_EQ(found->size(), 3u);
  for (const cv::Mat1b& of : *found) {
    EXPECT_LE(std::max(of.cols, of.rows), 800);
    EXPECT_LT(cv::mean(of)[0], 10);
  }
}

TEST(ShippedNetwork, LooksOnceAtPhotographsThatGiveNoFinerPicture) {
  EXPECT_TRUE(looksTwice({1600, 1200}));  // at 1024 x 768, and at 1600 x 1216
  EXPECT_FALSE(looksTwice({1033, 775}));  // a draft's: 1024 x 768 both times
  EXPECT_FALSE(looksTwice({1024, 768}));
  EXPECT_TRUE(looksTwice({775, 1100}));  // 1024 and 1088 high
}

TEST(ShippedNetwork, TakesColourPhotographsOnly) {
  const std::vector<cv::Mat> grey{cv::Mat(60, 80, CV_8UC1, cv::Scalar(0))}, none{cv::Mat()};
  EXPECT_FALSE(sherdProbabilities(grey, [] {}, {}).has_value());
  EXPECT_FALSE(sherdProbabilities(none, [] {}, {}).has_value());
}

TEST(ShippedNetwork, StopsBetweenPhotographs) {
  std::stop_source stop;
  stop.request_stop();
  const std::vector<cv::Mat> one{halves(64, 32)};
  const auto found = sherdProbabilities(one, [] {}, stop.get_token());
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace ostraka::segmentation
