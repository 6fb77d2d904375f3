#include "segmentation/onnx_file.h"

#include <gmock/gmock.h>

#include "onnx_bytes.h"

namespace ostraka::segmentation {
namespace {

using testing::HasSubstr;

constexpr int kDouble = 11;  // TensorProto.DataType

// Empty: it may be run.
std::string refusal(const std::string& model) {
  const Result<void> checked = checkOnnx(model, "net.onnx");
  if (checked) return "";
  EXPECT_EQ(checked.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(checked.error().where, "net.onnx");
  return checked.error().what.english();
}

std::string withWeights(const std::string& weights) {
  return modelOf(convolution("x", "w", "y") + bytes(5, weights) + freeInputAndOutput());
}

std::string dimsOf(const std::vector<std::uint64_t>& all) {
  std::string out;
  for (const std::uint64_t dim : all) out += number(1, dim);
  return out;
}

TEST(InputShape, IsOfTheFirstInputThatIsNoWeights) {
  const std::string graph =
      bytes(11, valueInfo("w", {1, 3, 1, 1})) + bytes(11, valueInfo("x", {1, 3, 480, 640})) +
      bytes(11, valueInfo("other", {7})) + bytes(5, tensor("w", {1, 3, 1, 1}, {1, 0, 0}));
  EXPECT_EQ(inputShapeOf(modelOf(graph)), (InputShape{1, 3, 480, 640}));
}

TEST(InputShape, IsFreeWhereItHasANameOrNoSizeThatCanBe) {
  EXPECT_EQ(inputShapeOf(modelOf(freeInputAndOutput())), (InputShape{1, 3, -1, -1}));
  const std::string sizes = bytes(1, number(1, 0)) + bytes(1, number(1, ~std::uint64_t{0})) +
                            bytes(1, "") + bytes(1, number(1, 9));
  const std::string input = bytes(1, "x") + bytes(2, bytes(1, bytes(2, sizes)));
  EXPECT_EQ(inputShapeOf(modelOf(bytes(11, input))), (InputShape{-1, -1, -1, 9}));
}

TEST(InputShape, IsNoneWithoutAnInput) {
  EXPECT_EQ(inputShapeOf(""), std::nullopt);
  EXPECT_EQ(inputShapeOf("this is no network"), std::nullopt);
  EXPECT_EQ(inputShapeOf(modelOf(bytes(11, valueInfo("w", {3})) + bytes(5, tensor("w", {1}, {1})))),
            std::nullopt);
}

TEST(CheckOnnx, TakesWeightsHoweverTheyAreWritten) {
  const std::string shape = dimsOf({1, 3, 1, 1});
  const std::string name = bytes(8, "w");
  EXPECT_EQ(refusal(withWeights(shape + number(2, 1) + name + bytes(9, floats({1, 2, 3})))), "");
  EXPECT_EQ(refusal(withWeights(shape + number(2, 1) + name + bytes(4, floats({1, 2, 3})))), "");
  const std::string half = varint(0x3C00);  // 1.0
  EXPECT_EQ(refusal(withWeights(shape + number(2, 10) + name + bytes(5, half + half + half))), "");
  EXPECT_EQ(
      refusal(withWeights(shape + number(2, kDouble) + name + bytes(10, std::string(24, '\0')))),
      "");
  EXPECT_EQ(refusal(withWeights(bytes(1, varint(1) + varint(3) + varint(1) + varint(1)) +
                                number(2, 1) + name + bytes(9, floats({1, 2, 3})))),
            "")
      << "a shape that is packed";
}

TEST(CheckOnnx, RefusesWeightsThatAreNotAsManyAsTheirShapeSays) {
  const std::string shape = dimsOf({1, 3, 1, 1});
  const std::string three = bytes(9, floats({1, 2, 3}));
  for (const std::string& weights :
       {shape + number(2, 1) + bytes(9, floats({1, 2})),             // one is missing
        shape + number(2, 1) + bytes(9, floats({1, 2, 3, 4})),       // one too many
        shape + number(2, kDouble) + three,                          // eight bytes each
        shape + number(2, 8) + three,                                // texts
        shape + number(2, 4711) + three,                             // no type at all
        shape + three,                                               // without one
        shape + number(2, 1) + three + bytes(4, floats({1, 2, 3})),  // twice
        shape + number(2, kDouble) + bytes(4, floats({1, 2, 3}))})   // in another type's field
    EXPECT_THAT(refusal(withWeights(weights + bytes(8, "w"))), HasSubstr("damaged"));
}

// 2^16 * 2^15 * 2^30 values of 8 bytes: 2^64 bytes, which is 0 in 64 bits, as many as there are.
TEST(CheckOnnx, RefusesAShapeWhoseBytesOverflow) {
  for (const std::vector<std::uint64_t>& shape :
       std::vector<std::vector<std::uint64_t>>{{65536, 32768, 1 << 30},
                                               {1 << 30, 65536, 32768},
                                               {65536, 65536, 65536, 65536},
                                               {0x7FFFFFFF, 0x7FFFFFFF, 0x7FFFFFFF},
                                               {0x80000000, 0},
                                               {~std::uint64_t{0}}})
    EXPECT_THAT(refusal(withWeights(dimsOf(shape) + number(2, kDouble) + bytes(8, "w"))),
                HasSubstr("damaged"))
        << testing::PrintToString(shape);
}

TEST(CheckOnnx, RefusesAConvolutionWithAConstantWithoutValuesForItsWeights) {
  const std::string nothing = number(1, 0) + number(2, 1);
  const std::string constant = bytes(
      1, bytes(2, "w") + bytes(4, "Constant") + bytes(5, bytes(1, "value") + bytes(5, nothing)));
  EXPECT_THAT(refusal(modelOf(constant + convolution("x", "w", "y"))), HasSubstr("damaged"));
  EXPECT_EQ(refusal(modelOf(constant + convolution("x", "v", "y"))), "");
}

TEST(CheckOnnx, RefusesGraphsInGraphsBeyondEight) {
  const auto nested = [](int depth) {
    std::string graph = convolution("x", "w", "y");
    for (int i = 1; i < depth; ++i)
      graph = bytes(1, bytes(4, "If") + bytes(5, bytes(1, "then_branch") + bytes(6, graph)));
    return modelOf(graph);
  };
  EXPECT_EQ(refusal(nested(1)), "");
  EXPECT_EQ(refusal(nested(8)), "");
  EXPECT_THAT(refusal(nested(9)), HasSubstr("damaged"));
  EXPECT_THAT(refusal(nested(2000)), HasSubstr("damaged"));
}

TEST(CheckOnnx, TellsTheSettingThatCannotBeUsed) {
  const auto with = [](const std::string& name, std::uint64_t value) {
    return refusal(modelOf(convolution("x", "w", "y", bytes(1, name) + number(3, value))));
  };
  EXPECT_EQ(with("group", 1), "");
  EXPECT_EQ(with("group", 4096), "");
  EXPECT_THAT(with("group", 0), HasSubstr("'group' 0, but only 1 to 4096"));
  EXPECT_THAT(with("blocksize", 4097), HasSubstr("'blocksize' 4097"));
  EXPECT_EQ(with("pads", static_cast<std::uint64_t>(-4096)), "");
  EXPECT_THAT(with("pads", static_cast<std::uint64_t>(-4097)), HasSubstr("'pads' -4097"));
  EXPECT_THAT(with("kernel_shape", static_cast<std::uint64_t>(INT64_MIN)),
              HasSubstr("'kernel_shape' -9223372036854775808"));
  EXPECT_EQ(with("axis", 0), "") << "which is no divisor";
}

// Each file that a copy left short, and each in which a disk changed one byte.
TEST(CheckOnnx, EndsOnWhateverIsLeftOfANetwork) {
  const std::string whole = withWeights(tensor("w", {1, 3, 1, 1}, {1, 0, 0}));
  ASSERT_EQ(refusal(whole), "");
  const std::size_t graph_ends = whole.size() - (bytes(8, bytes(1, "") + number(2, 13))).size();
  for (std::size_t size = 3; size < graph_ends; ++size)
    EXPECT_THAT(refusal(whole.substr(0, size)), HasSubstr("damaged")) << size;
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const char other : {'\0', '\x7F', '\x80', '\xFF'}) {
      std::string changed = whole;
      changed[at] = other;
      (void)refusal(changed);
      (void)inputShapeOf(changed);
    }
}

TEST(CheckOnnx, RefusesLengthsAndNumbersThatDoNotFit) {
  const std::string key(1, '\x3A');  // field 7, bytes
  EXPECT_THAT(refusal(key + varint(~std::uint64_t{0})), HasSubstr("damaged"));
  EXPECT_THAT(refusal(key + varint(std::uint64_t{1} << 63) + "abc"), HasSubstr("damaged"));
  EXPECT_THAT(refusal(key + std::string(11, '\x80') + '\1'), HasSubstr("damaged"));
  EXPECT_THAT(refusal(std::string(1, '\x3B')), HasSubstr("damaged")) << "a group";
  EXPECT_THAT(refusal(varint(std::uint64_t{1} << 40) + varint(0)), HasSubstr("damaged"));
}

}  // namespace
}  // namespace ostraka::segmentation
