#include "images/tiff_image.h"

#include <gmock/gmock.h>
#include <tiffio.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <string>
#include <vector>

#include "tests/core/files/temporary_folder.h"

namespace ostraka::images {
namespace {

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Form {
  int bits = 8, samples = 3;
  int photometric = PHOTOMETRIC_RGB;
  int compression = COMPRESSION_NONE;
  bool tiled = false;
  int orientation = ORIENTATION_TOPLEFT;
  int format = SAMPLEFORMAT_UINT;
};
constexpr int kWidth = 61, kHeight = 37;

class Tiffs : public testing::Test {
 protected:
  // Rows of noise, by libtiff.
  std::string tiffOf(const Form& form) const {
    const std::string name = (folder_.path() / "a.tif").string();
    TIFF* file = TIFFOpen(name.c_str(), "w");
    TIFFSetField(file, TIFFTAG_IMAGEWIDTH, kWidth);
    TIFFSetField(file, TIFFTAG_IMAGELENGTH, kHeight);
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, form.bits);
    TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, form.samples);
    TIFFSetField(file, TIFFTAG_PHOTOMETRIC, form.photometric);
    TIFFSetField(file, TIFFTAG_COMPRESSION, form.compression);
    TIFFSetField(file, TIFFTAG_SAMPLEFORMAT, form.format);
    TIFFSetField(file, TIFFTAG_ORIENTATION, form.orientation);
    TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    std::mt19937 random(3);
    if (form.photometric == PHOTOMETRIC_PALETTE) {
      std::vector<std::uint16_t> red(256), green(256), blue(256);
      for (int i = 0; i < 256; ++i)
        red[i] = 257 * (i % 7), green[i] = 257 * i, blue[i] = 257 * (255 - i);
      TIFFSetField(file, TIFFTAG_COLORMAP, red.data(), green.data(), blue.data());
    }
    const auto noise = [&](tmsize_t bytes) {
      std::vector<unsigned char> values(static_cast<std::size_t>(bytes));
      for (unsigned char& value : values) value = static_cast<unsigned char>(random());
      if (form.format == SAMPLEFORMAT_IEEEFP)
        for (std::size_t i = 0; i + 4 <= values.size(); i += 4) {
          const float value = static_cast<float>(random() % 1000) / 7;
          std::memcpy(values.data() + i, &value, 4);
        }
      return values;
    };
    if (form.tiled) {
      TIFFSetField(file, TIFFTAG_TILEWIDTH, 16);
      TIFFSetField(file, TIFFTAG_TILELENGTH, 32);
      for (std::uint32_t i = 0; i < TIFFNumberOfTiles(file); ++i) {
        auto tile = noise(TIFFTileSize(file));
        TIFFWriteEncodedTile(file, i, tile.data(), TIFFTileSize(file));
      }
    } else {
      TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, 8);
      for (std::uint32_t i = 0; i < TIFFNumberOfStrips(file); ++i) {
        const tmsize_t size = TIFFVStripSize(file, i == 4 ? 5 : 8);
        auto strip = noise(size);
        TIFFWriteEncodedStrip(file, i, strip.data(), size);
      }
    }
    TIFFClose(file);
    return bytesOf(name);
  }

  static void expectOpenCvsValues(const std::string& bytes, Values values, int flags) {
    const Result<cv::Mat> image = decodeTiff(bytes, values, "a.tif");
    ASSERT_TRUE(image.has_value()) << image.error().sentence();
    const std::vector<unsigned char> raw(bytes.begin(), bytes.end());
    const cv::Mat by_opencv = cv::imdecode(raw, flags);
    ASSERT_EQ(image->type(), by_opencv.type()) << flags;
    ASSERT_EQ(image->size(), by_opencv.size());
    EXPECT_LE(cv::norm(*image, by_opencv, cv::NORM_INF), flags == cv::IMREAD_GRAYSCALE ? 1 : 0);
  }

  TemporaryFolder folder_;
};

TEST_F(Tiffs, GiveTheValuesThatOpenCvGives) {
  for (const int compression :
       {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS})
    for (const bool tiled : {false, true})
      for (const int bits : {8, 16})
        for (const int samples : {1, 3}) {
          if (tiled && bits == 8 && compression == COMPRESSION_NONE) continue;  // it reads none
          const std::string bytes =
              tiffOf({.bits = bits,
                      .samples = samples,
                      .photometric = samples == 1 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB,
                      .compression = compression,
                      .tiled = tiled});
          SCOPED_TRACE(testing::PrintToString(std::vector{compression, int{tiled}, bits, samples}));
          expectOpenCvsValues(bytes, Values::Bgr, cv::IMREAD_COLOR);
          expectOpenCvsValues(bytes, Values::Grey, cv::IMREAD_GRAYSCALE);
          expectOpenCvsValues(bytes, Values::AsStored, cv::IMREAD_UNCHANGED);
        }
}

TEST_F(Tiffs, OfUncompressedTilesHaveTheValuesOfCompressedOnes) {
  const std::string plain = tiffOf({.tiled = true});
  const std::string packed = tiffOf({.compression = COMPRESSION_LZW, .tiled = true});
  for (const Values values : {Values::Bgr, Values::Grey, Values::AsStored}) {
    const Result<cv::Mat> image = decodeTiff(plain, values, "a.tif");
    ASSERT_TRUE(image.has_value()) << image.error().sentence();
    EXPECT_EQ(cv::norm(*image, *decodeTiff(packed, values, "a.tif"), cv::NORM_INF), 0);
  }
}

TEST_F(Tiffs, KeepRealNumbersAndLabelsOf32Bits) {
  const std::string real = tiffOf({.bits = 32,
                                   .samples = 1,
                                   .photometric = PHOTOMETRIC_MINISBLACK,
                                   .format = SAMPLEFORMAT_IEEEFP});
  expectOpenCvsValues(real, Values::AsStored, cv::IMREAD_UNCHANGED);
  const std::string labels =
      tiffOf({.bits = 32, .samples = 1, .photometric = PHOTOMETRIC_MINISBLACK});
  const Result<cv::Mat> image = decodeTiff(labels, Values::AsStored, "a.tif");
  ASSERT_TRUE(image.has_value()) << image.error().sentence();
  EXPECT_EQ(image->type(), CV_32SC1);
}

TEST_F(Tiffs, ShowAPaletteInColours) {
  const std::string bytes = tiffOf({.samples = 1, .photometric = PHOTOMETRIC_PALETTE});
  expectOpenCvsValues(bytes, Values::Bgr, cv::IMREAD_COLOR);
}

// As scanners write pages: white is zero, a bit a pixel.
TEST_F(Tiffs, ShowPagesOfOneBit) {
  const std::string bytes = tiffOf({.bits = 1,
                                    .samples = 1,
                                    .photometric = PHOTOMETRIC_MINISWHITE,
                                    .compression = COMPRESSION_CCITTFAX4});
  expectOpenCvsValues(bytes, Values::Grey, cv::IMREAD_GRAYSCALE);
  const Result<cv::Mat> stored = decodeTiff(bytes, Values::AsStored, "a.tif");
  ASSERT_TRUE(stored.has_value());
  EXPECT_EQ(stored->type(), CV_8UC1);
  EXPECT_EQ(cv::countNonZero((*stored != 0) & (*stored != 255)), 0);
}

// Intrinsics belong to the sensor.
TEST_F(Tiffs, AreNotTurnedAsTheyAskTo) {
  const Result<cv::Mat> plain = decodeTiff(tiffOf({}), Values::Bgr, "a.tif");
  ASSERT_TRUE(plain.has_value());
  for (const int orientation : {ORIENTATION_BOTRIGHT, ORIENTATION_RIGHTTOP, ORIENTATION_LEFTBOT}) {
    const Result<cv::Mat> image =
        decodeTiff(tiffOf({.orientation = orientation}), Values::Bgr, "a.tif");
    ASSERT_TRUE(image.has_value()) << orientation;
    ASSERT_EQ(image->size(), cv::Size(kWidth, kHeight));
    EXPECT_EQ(cv::norm(*image, *plain, cv::NORM_INF), 0) << orientation;
  }
}

TEST_F(Tiffs, AreRefusedWhereTheyAreDamagedWithoutReadingBeyondThem) {
  for (const Form& form : {Form{}, Form{.compression = COMPRESSION_LZW, .tiled = true}}) {
    const std::string whole = tiffOf(form);
    std::mt19937 random(5);
    for (int round = 0; round < 300; ++round) {
      std::string damaged = whole;
      const std::size_t from = round % 2 == 0 ? 0 : damaged.size() - 250;  // the directory is last
      for (int k = 0; k < 3; ++k) damaged[from + random() % 250] = static_cast<char>(random());
      for (const Values values : {Values::Bgr, Values::AsStored}) {
        const Result<cv::Mat> image = decodeTiff(damaged, values, "a.tif");
        if (!image) {
          EXPECT_EQ(image.error().code, ErrorCode::UnusableInput);
        }
      }
    }
    EXPECT_FALSE(
        decodeTiff(std::string_view(whole).substr(0, whole.size() / 2), Values::Bgr, "a.tif"));
  }
}

TEST(EncodedTiff, ComesBackWithItsResolution) {
  for (const int type : {CV_8UC1, CV_8UC3}) {
    cv::Mat picture(37, 61, type);
    cv::randu(picture, 0, 255);
    const TemporaryFolder folder;
    const std::string name = (folder.path() / "a.tif").string();
    const cv::Mat before = picture.clone();
    const std::string bytes = encodedTiff(picture, 300);
    EXPECT_EQ(cv::norm(picture, before, cv::NORM_INF), 0);
    std::ofstream(name, std::ios::binary) << bytes;
    EXPECT_EQ(cv::norm(cv::imread(name, cv::IMREAD_UNCHANGED), picture, cv::NORM_INF), 0);
    EXPECT_EQ(cv::norm(*decodeTiff(bytes, Values::AsStored, name), picture, cv::NORM_INF), 0);
    TIFF* file = TIFFOpen(name.c_str(), "r");
    float dpi = 0;
    std::uint16_t unit = 0;
    TIFFGetField(file, TIFFTAG_XRESOLUTION, &dpi);
    TIFFGetField(file, TIFFTAG_RESOLUTIONUNIT, &unit);
    TIFFClose(file);
    EXPECT_EQ(dpi, 300);
    EXPECT_EQ(unit, RESUNIT_INCH);
  }
}

}  // namespace
}  // namespace ostraka::images
