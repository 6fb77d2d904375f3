// HEIC images made here by libheif's encoder, as telephones write them.
#include "batch/heif_image.h"

#include <gmock/gmock.h>
#include <libheif/heif.h>

#include <algorithm>
#include <random>

#include "batch/exif.h"
#include "batch/photograph.h"
#include "batch_folder.h"

namespace ostraka::batch {
namespace {

using testing::HasSubstr;

heif_error append(heif_context*, const void* bytes, std::size_t size, void* to) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), size);
  return {heif_error_Ok, heif_suberror_Unspecified, ""};
}

// Left half red, right half blue; with an EXIF block of a make and an orientation.
std::string heic(int width, int height, heif_orientation turned = heif_orientation_normal) {
  heif_image* image = nullptr;
  heif_image_create(width, height, heif_colorspace_RGB, heif_chroma_interleaved_RGB, &image);
  heif_image_add_plane(image, heif_channel_interleaved, width, height, 8);
  int stride = 0;
  std::uint8_t* pixels = heif_image_get_plane(image, heif_channel_interleaved, &stride);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::uint8_t* rgb = pixels + y * stride + 3 * x;
      rgb[0] = x < width / 2 ? 200 : 20;
      rgb[1] = 20;
      rgb[2] = x < width / 2 ? 20 : 200;
    }
  heif_context* context = heif_context_alloc();
  heif_encoder* encoder = nullptr;
  EXPECT_EQ(heif_context_get_encoder_for_format(context, heif_compression_HEVC, &encoder).code,
            heif_error_Ok);
  heif_encoder_set_lossy_quality(encoder, 90);
  heif_encoding_options* options = heif_encoding_options_alloc();
  options->image_orientation = turned;
  heif_image_handle* handle = nullptr;
  EXPECT_EQ(heif_context_encode_image(context, image, encoder, options, &handle).code,
            heif_error_Ok);
  const std::string exif(
      "Exif\0\0II*\0\x08\0\0\0\x01\0\x0F\x01\x02\0\x06\0\0\0\x1A\0\0\0\0\0\0\0"
      "Apple\0",
      38);
  heif_context_add_exif_metadata(context, handle, exif.data(), static_cast<int>(exif.size()));
  std::string bytes;
  heif_writer writer{1, append};
  heif_context_write(context, &writer, &bytes);
  heif_encoding_options_free(options);
  heif_image_handle_release(handle);
  heif_encoder_release(encoder);
  heif_context_free(context);
  heif_image_release(image);
  return bytes;
}

TEST(HeifImage, GivesSizeAndColoursAsStored) {
  const std::string bytes = heic(322, 242);
  ASSERT_TRUE(isHeif(bytes));
  const auto size = imageSize(bytes, "a.heic");
  ASSERT_TRUE(size.has_value()) << size.error().sentence();
  EXPECT_EQ(*size, (ImageSize{322, 242}));
  const auto image = decodePhotograph(bytes, "a.heic");
  ASSERT_TRUE(image.has_value()) << image.error().sentence();
  EXPECT_EQ(image->size(), cv::Size(322, 242));
  // Of the coding at quality 90, a few grey values in an even area.
  EXPECT_NEAR(image->at<cv::Vec3b>(100, 50)[2], 200, 6);
  EXPECT_NEAR(image->at<cv::Vec3b>(100, 250)[0], 200, 6);
}

// As the standard has it (ISO/IEC 23008-12) and telephones write it, the size is that before the
// turn; libheif 1.15 writes the one behind it.
std::string withSizeBeforeTheTurn(std::string bytes) {
  const std::size_t at = bytes.find("ispe") + 8;  // behind version and flags
  std::swap_ranges(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                   bytes.begin() + static_cast<std::ptrdiff_t>(at + 4),
                   bytes.begin() + static_cast<std::ptrdiff_t>(at + 4));
  return bytes;
}

TEST(HeifImage, IsNotTurnedUpright) {
  const std::string bytes = withSizeBeforeTheTurn(heic(320, 240, heif_orientation_rotate_90_cw));
  const auto size = imageSize(bytes, "a.heic");
  ASSERT_TRUE(size.has_value()) << size.error().sentence();
  EXPECT_EQ(*size, (ImageSize{320, 240}));
  const auto image = decodePhotograph(bytes, "a.heic");
  ASSERT_TRUE(image.has_value()) << image.error().sentence();
  EXPECT_EQ(image->size(), cv::Size(320, 240));
  EXPECT_NEAR(image->at<cv::Vec3b>(100, 50)[2], 200, 6);
}

TEST(HeifImage, GivesWhatTheCameraWrote) {
  const std::string bytes = heic(64, 64);
  EXPECT_EQ(exifIn(bytes).make, "Apple");
  const BatchFolder folder;
  folder.write("a.HEIC", bytes);
  EXPECT_EQ(readExif(folder.path() / "a.HEIC").make, "Apple");
}

TEST(HeifImage, IsRecognisedAsCutOffWhereverItIsCut) {
  const std::string whole = heic(128, 96);
  for (std::size_t length = 12; length < whole.size(); length += 37) {
    const auto size = imageSize(std::string_view(whole).substr(0, length), "a.heic");
    EXPECT_FALSE(size.has_value()) << length;
  }
  EXPECT_THAT(imageSize(whole.substr(0, whole.size() - 1), "a.heic").error().what,
              HasSubstr("truncated"));
}

TEST(HeifImage, SurvivesChangedBytes) {
  const std::string whole = heic(64, 48);
  std::mt19937 random(7);
  for (int round = 0; round < 400; ++round) {
    std::string damaged = whole;
    for (int k = 0; k < 4; ++k)
      damaged[random() % std::min<std::size_t>(damaged.size(), 700)] = static_cast<char>(random());
    const auto image = decodePhotograph(damaged, "a.heic");
    if (!image) {
      EXPECT_EQ(image.error().code, ErrorCode::UnusableInput);
    }
    exifIn(damaged);
  }
}

TEST(HeifImage, OtherFilesOfBoxesAreNone) {
  EXPECT_FALSE(
      isHeif(std::string("\0\0\0\x18"
                         "ftypqt  \0\0\0\0",
                         16)));
  EXPECT_FALSE(isHeif("short"));
  EXPECT_THAT(imageSize(std::string("\0\0\0\x10"
                                    "ftypheic\0\0\0\0",
                                    16),
                        "a.heic")
                  .error()
                  .what,
              HasSubstr("HEIC image is damaged"));
}

}  // namespace
}  // namespace ostraka::batch
