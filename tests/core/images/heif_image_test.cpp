// HEIC images made here by libheif's encoder, as telephones write them.
#include "images/heif_image.h"

#include <gmock/gmock.h>
#include <libheif/heif.h>

#include <algorithm>
#include <random>
#include <vector>

#include "batch/exif.h"
#include "images/decode.h"
#include "tests/core/batch/batch_folder.h"

namespace ostraka::images {
namespace {

using testing::HasSubstr;

heif_error append(heif_context*, const void* bytes, std::size_t size, void* to) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), size);
  return {heif_error_Ok, heif_suberror_Unspecified, ""};
}

// Left half red, right half blue; with an EXIF block of a make and an orientation.
std::string heic(int width, int height, heif_orientation turned = heif_orientation_normal,
                 bool with_exif = true) {
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
  if (with_exif)
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
  const auto image = decodeImage(bytes, Values::Bgr, "a.heic");
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
  const auto image = decodeImage(bytes, Values::Bgr, "a.heic");
  ASSERT_TRUE(image.has_value()) << image.error().sentence();
  EXPECT_EQ(image->size(), cv::Size(320, 240));
  EXPECT_NEAR(image->at<cv::Vec3b>(100, 50)[2], 200, 6);
}

TEST(HeifImage, GivesWhatTheCameraWrote) {
  const std::string bytes = heic(64, 64);
  EXPECT_EQ(batch::exifIn(bytes).make, "Apple");
  const batch::BatchFolder folder;
  folder.write("a.HEIC", bytes);
  EXPECT_EQ(batch::readExif(folder.path() / "a.HEIC").make, "Apple");
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
    const auto image = decodeImage(damaged, Values::Bgr, "a.heic");
    if (!image) {
      EXPECT_EQ(image.error().code, ErrorCode::UnusableInput);
    }
    batch::exifIn(damaged);
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

std::string big(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> 8 * i & 0xFF);
  return text;
}
enum class SizeField { Four, Eight };
std::string box(const std::string& type, const std::string& content,
                SizeField size = SizeField::Four) {
  return size == SizeField::Four ? big(8 + content.size(), 4) + type + content
                                 : big(1, 4) + type + big(16 + content.size(), 8) + content;
}
std::string fullBox(const std::string& type, int version, const std::string& content) {
  return box(type, big(static_cast<std::uint64_t>(version), 1) + big(0, 3) + content);
}

struct HeifItem {
  std::string type, data;  // the data stand in the box idat
  std::string properties = "\1";
};
struct HeifReference {
  std::string type;
  int from;
  std::vector<int> to;
};

// Items 1, 2 and so on, the first of them the main one. `properties` are boxes, counted from 1.
std::string heif(const std::vector<HeifItem>& items, const std::vector<HeifReference>& references,
                 const std::string& properties, int iref_version = 0,
                 SizeField size = SizeField::Four) {
  const int id = iref_version == 0 ? 2 : 4;
  std::string places, types, of, links, data;
  for (std::size_t k = 0; k < items.size(); ++k) {
    const HeifItem& item = items[k];
    places += big(k + 1, 2) + big(1, 2) + big(0, 2) + big(1, 2) + big(data.size(), 4) +
              big(item.data.size(), 4);
    types += fullBox("infe", 2, big(k + 1, 2) + big(0, 2) + item.type + big(0, 1));
    of += big(k + 1, 2) + big(item.properties.size(), 1) + item.properties;
    data += item.data;
  }
  for (const HeifReference& reference : references) {
    std::string ids =
        big(static_cast<std::uint64_t>(reference.from), id) + big(reference.to.size(), 2);
    for (const int to : reference.to) ids += big(static_cast<std::uint64_t>(to), id);
    links += box(reference.type, ids, size);
  }
  const std::string count = big(items.size(), 2);
  std::string meta = big(0, 4);
  meta += fullBox("hdlr", 0, big(0, 4) + "pict" + big(0, 8) + big(0, 5));
  meta += fullBox("pitm", 0, big(1, 2));
  meta += fullBox("iloc", 1, big(0x4400, 2) + count + places);
  meta += fullBox("iinf", 0, count + types);
  meta += box("iprp", box("ipco", properties) + fullBox("ipma", 0, big(items.size(), 4) + of));
  meta += fullBox("iref", iref_version, links);
  meta += box("idat", data, size);
  return box("ftyp", "heic" + big(0, 4) + "mif1heic") + box("meta", meta, size) + big(0, 4) +
         "mdat" + std::string(16, 'x');  // to the end of the file
}
std::string ispe(std::uint64_t width, std::uint64_t height) {
  return fullBox("ispe", 0, big(width, 4) + big(height, 4));
}
std::string grid(int rows, int columns, std::uint64_t width, std::uint64_t height) {
  return big(1, 2) + big(static_cast<std::uint64_t>(rows - 1), 1) +
         big(static_cast<std::uint64_t>(columns - 1), 1) + big(width, 4) + big(height, 4);
}
std::string overlay(std::uint64_t width, std::uint64_t height) {
  return big(1, 2) + big(0, 8) + big(width, 4) + big(height, 4) + big(0, 8);
}

// As telephones write them: two tiles side by side, a thumbnail, a gain map and EXIF.
std::string tiled(int canvas_width, int iref_version, SizeField size) {
  const std::string one = heic(64, 64, heif_orientation_normal, false);
  const std::size_t mdat = one.find("mdat"), hvcc = one.find("hvcC") - 4;
  const std::string coded = one.substr(mdat + 4);
  const std::size_t hvcc_bytes = static_cast<std::size_t>(
      static_cast<unsigned char>(one[hvcc + 2]) << 8 | static_cast<unsigned char>(one[hvcc + 3]));
  const std::string properties =
      ispe(static_cast<std::uint64_t>(canvas_width), 64) + ispe(64, 64) +
      one.substr(hvcc, hvcc_bytes) +
      fullBox("auxC", 0, std::string("urn:com:apple:photo:2020:aux:hdrgainmap") + '\0');
  const std::string tiff = big(0, 4) + std::string("II*\0\x08\0\0\0\0\0", 10);
  return heif({{"grid", grid(1, 2, static_cast<std::uint64_t>(canvas_width), 64), "\1"},
               {"hvc1", coded, "\2\3"},
               {"hvc1", coded, "\2\3"},
               {"hvc1", coded, "\2\3"},
               {"hvc1", coded, "\2\3\4"},
               {"Exif", tiff, ""}},
              {{"dimg", 1, {2, 3}}, {"thmb", 4, {1}}, {"auxl", 5, {1}}, {"cdsc", 6, {1}}},
              properties, iref_version, size);
}

TEST(HeifImage, PutTogetherFromTilesIsRead) {
  for (const int iref_version : {0, 1})
    for (const SizeField size_field : {SizeField::Four, SizeField::Eight}) {
      const std::string bytes = tiled(128, iref_version, size_field);
      const auto size = imageSize(bytes, "a.heic");
      ASSERT_TRUE(size.has_value()) << size.error().sentence();
      EXPECT_EQ(*size, (ImageSize{128, 64}));
      const auto image = decodeImage(bytes, Values::Bgr, "a.heic");
      ASSERT_TRUE(image.has_value()) << image.error().sentence();
      ASSERT_EQ(image->size(), cv::Size(128, 64));
      EXPECT_NEAR(image->at<cv::Vec3b>(32, 80)[2], 200, 12);
      EXPECT_NEAR(image->at<cv::Vec3b>(32, 112)[0], 200, 12);
    }
}

// libheif 1.15 recurses over the first ones until the stack ends, and over the overlays without
// end; each grid of the last ones decodes 256 times the one below it.
TEST(HeifImage, OfImagesWithinEachOtherWithoutEndIsDamaged) {
  const std::string ispes = ispe(1200, 900);
  const HeifItem one_tile{"grid", grid(1, 1, 1200, 900)}, copy{"iden", ""};
  const HeifItem placed{"iovl", overlay(1200, 900)};
  std::vector<HeifItem> grids(3, {"grid", grid(16, 16, 1200, 900)});
  grids.push_back(copy);
  std::vector<HeifReference> within;
  for (int k = 1; k < 4; ++k) within.push_back({"dimg", k, std::vector<int>(256, k + 1)});
  for (const std::string& bytes :
       {heif({one_tile}, {{"dimg", 1, {1}}}, ispes),
        heif({one_tile, one_tile}, {{"dimg", 1, {2}}, {"dimg", 2, {1}}}, ispes, 1),
        heif({copy, copy, copy, one_tile}, {{"dimg", 1, {2}}, {"dimg", 2, {3}}, {"dimg", 3, {2}}},
             ispes, 0, SizeField::Eight),
        heif({one_tile, copy, copy}, {{"dimg", 1, {2}}, {"auxl", 2, {3}}, {"auxl", 3, {2}}}, ispes),
        heif({placed}, {{"dimg", 1, {1}}}, ispes),
        heif({placed, copy}, {{"dimg", 1, {2}}, {"dimg", 2, {1}}}, ispes),
        heif(grids, within, ispes)}) {
    EXPECT_THAT(imageSize(bytes, "a.heic").error().what, HasSubstr("HEIC image is damaged"));
    EXPECT_FALSE(batch::exifIn(bytes).make.size() > 0);
  }
}

TEST(HeifImage, OfACanvasBeyondTheLimitsIsRefused) {
  const std::string ispes = ispe(1200, 900);
  const std::vector<HeifReference> first{{"dimg", 1, {2}}};
  EXPECT_THAT(
      imageSize(heif({{"grid", grid(1, 1, 30000, 30000)}, {"iden", ""}}, first, ispes), "a.heic")
          .error()
          .what,
      HasSubstr("30000 x 30000"));
  for (const HeifItem& item : {HeifItem{"iovl", overlay(30000, 30000)},
                               HeifItem{"grid", grid(1, 2, 1200, 900)},  // one tile is missing
                               HeifItem{"grid", "\1"}})
    EXPECT_THAT(imageSize(heif({item, {"iden", ""}}, first, ispes), "a.heic").error().what,
                HasSubstr("HEIC image is damaged"));
}

}  // namespace
}  // namespace ostraka::images
