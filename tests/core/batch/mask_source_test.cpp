#include "batch/mask_source.h"

#include <gmock/gmock.h>

namespace ostraka::batch {
namespace {

Batch withMasks(int count) {
  Batch batch;
  batch.folder = "/somewhere/batch";
  for (int k = 0; k < 3; ++k)
    batch.shots.push_back({Side::Front, 0, k, "a.jpg", k < count ? "a.png" : "", 10, 10});
  return batch;
}

TEST(MaskSource, TakesTheMasksThatCameAlongOnlyWithoutAPlate) {
  Batch batch = withMasks(3);
  EXPECT_EQ(*maskSource("auto", batch), MaskSource::Given);
  batch.plate.emplace();
  EXPECT_EQ(*maskSource("auto", batch), MaskSource::Plate);
  EXPECT_EQ(*maskSource("given", batch), MaskSource::Given);
  EXPECT_EQ(*maskSource("unet.onnx", batch), MaskSource::Network);
}

TEST(MaskSource, AsksForMasksWhereThereIsNeitherPlateNorMask) {
  const auto source = maskSource("auto", withMasks(0));
  ASSERT_FALSE(source.has_value());
  EXPECT_EQ(source.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(source.error().sentence(), testing::HasSubstr("/somewhere/batch"));
  EXPECT_EQ(*maskSource("unet.onnx", withMasks(0)), MaskSource::Network);
}

TEST(MaskSource, FindsMasksFromThePhotographsByHandThemselves) {
  Batch by_hand = withMasks(0);
  by_hand.way = Way::FreeCamera;
  EXPECT_EQ(*maskSource("auto", by_hand), MaskSource::Views);
  by_hand.shots[0].mask_file = "a.png";
  EXPECT_EQ(*maskSource("auto", by_hand), MaskSource::Given);
}

}  // namespace
}  // namespace ostraka::batch
