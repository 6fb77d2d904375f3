#include "ground/sheet_picture.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "base/median.h"
#include "ground/bare_rows.h"
#include "ground/plate_picture.h"
#include "ground/sheet_rest.h"
#include "rig/marker_dictionary.h"

namespace ostraka::ground {
namespace {

constexpr int kDrawnFiner = 3;   // drawn so much finer than the grid, then averaged
constexpr int kSheetStride = 3;  // the light bends slowly
constexpr int kSheetRounds = 2;  // tones and correction in turns; the second changes < 1 %
constexpr float kWhitePaper = 0.98F, kBlackInk = 0.02F;

constexpr int kFewestWitnesses = 4;
constexpr double kSomeAgree = 0.2;  // of the photographs that see a place; others look past a sherd
constexpr double kMostAgree = 0.5;  // where noise and the grain of dark clay are hard to tell apart
constexpr float kDark = -0.9F;
constexpr int kByChance = 2;  // photographs that agree, each on another white part of a thing
constexpr int kShadeWindow = 5;  // of half the cells: 3 mm
// The least share of a shadow's border along which the photographs agree on bright sheet: 0.3 to 1
// by all lamps tried, less than 0.1 around even clay.
constexpr double kOpenBorder = 0.15;

using Basis = Eigen::Matrix<double, 6, 1>;

Basis basisAt(double u, double v) {
  Basis b;
  b << 1, u, v, u * u, u * v, v * v;
  return b;
}

// -1 .. 1 over the grid.
float unit(float cell, int size) {
  const float middle = 0.5F * static_cast<float>(size - 1);
  return (cell - middle) / middle;
}

struct Logs {
  std::array<float, 256> of{};
  Logs() {
    for (int i = 0; i < 256; ++i) of[static_cast<std::size_t>(i)] = std::log(i + kDarkLevel);
  }
  cv::Vec3f operator()(const cv::Vec3b& v) const { return {of[v[0]], of[v[1]], of[v[2]]}; }
};

bool isSeen(const cv::Vec3b& sample) {
  return sample != cv::Vec3b(0, 0, 0);
}

cv::Vec3f mixture(float paper, const cv::Vec3f& ink) {
  cv::Vec3f log;
  for (int c = 0; c < 3; ++c) log[c] = std::log(paper + (1 - paper) * std::exp(ink[c]));
  return log;
}

// Cells whose surroundings of 5 x 5 are all paper, or all ink.
cv::Mat1b allOf(const cv::Mat1b& kind) {
  cv::Mat1b whole;
  cv::erode(kind, whole, cv::getStructuringElement(cv::MORPH_RECT, {5, 5}));
  return whole;
}

/// What a fit of the paper's tone takes from one photograph.
struct PaperSample {
  Basis at;
  cv::Vec3f colour;
};

// Sherds and shadows are darker than the paper around them more often than brighter, so what lies
// below the fit loses its weight three times as soon. The scales shrink from all there is to the
// grain of paper.
SheetPicture::Tone fitPaper(const std::vector<PaperSample>& samples) {
  SheetPicture::Tone tone;
  Eigen::Matrix<double, 6, 3> fit = Eigen::Matrix<double, 6, 3>::Zero();
  std::vector<float> level;
  for (const PaperSample& s : samples) level.push_back(brightnessOfRest(s.colour));
  const auto upper = level.begin() + static_cast<std::ptrdiff_t>(level.size() * 3 / 4);
  std::nth_element(level.begin(), upper, level.end());
  // The start: the colour of what is brighter than three quarters, all over the sheet.
  cv::Vec3d sum(0, 0, 0);
  int count = 0;
  for (const PaperSample& s : samples)
    if (brightnessOfRest(s.colour) >= *upper) sum += cv::Vec3d(s.colour), ++count;
  for (int c = 0; c < 3; ++c) fit(0, c) = sum[c] / std::max(1, count);
  for (const double scale : {0.5, 0.35, 0.25, 0.18, 0.12, 0.08, 0.06, 0.06}) {
    Eigen::Matrix<double, 6, 6> normal = 1e-3 * Eigen::Matrix<double, 6, 6>::Identity();
    Eigen::Matrix<double, 6, 3> right = normal * fit;
    for (const PaperSample& s : samples) {
      const Eigen::Vector3d colour(s.colour[0], s.colour[1], s.colour[2]);
      const Eigen::Vector3d rest = colour - fit.transpose() * s.at;
      const double g = rest.mean();
      const double along = g < 0 ? 3 * g / scale : g / scale;
      const double across = 2 * (rest.array() - g).matrix().norm() / scale;
      const double weight = 1 / (1 + along * along + across * across);
      normal += weight * s.at * s.at.transpose();
      right += weight * s.at * colour.transpose();
    }
    fit = normal.ldlt().solve(right);
  }
  for (int k = 0; k < 6; ++k)
    for (int c = 0; c < 3; ++c)
      tone.paper[static_cast<std::size_t>(k)][c] = static_cast<float>(fit(k, c));
  return tone;
}

class SheetPainter {
 public:
  SheetPainter(std::span<const cv::Mat3b> samples, std::span<const cv::Mat1b> covered,
               const cv::Mat1f& printed)
      : samples_(samples),
        covered_(covered),
        printed_(printed),
        paper_(allOf(printed > kWhitePaper)),
        ink_(allOf((printed >= 0) & (printed < kBlackInk))) {}

  SheetPicture run() {
    picture_.tones.resize(samples_.size());
    picture_.correction = cv::Mat3f(printed_.size(), cv::Vec3f::all(0));
    for (int round = 0; round < kSheetRounds; ++round) {
      for (std::size_t i = 0; i < samples_.size(); ++i) fitTone(i);
      correct();
    }
    const std::vector<SheetRest> rests = restsOfAll();
    picture_.still_light = samples_.size() < 3 || lightStandsStill(rests, paper_);
    if (picture_.still_light) shade(rests);
    return std::move(picture_);
  }

 private:
  void fitTone(std::size_t i) {
    std::vector<PaperSample> samples;
    overCells(i, paper_, kSheetStride, [&](int row, int column, const cv::Vec3f& colour) {
      samples.push_back({basisAt(unit(static_cast<float>(column), printed_.cols),
                                 unit(static_cast<float>(row), printed_.rows)),
                         colour - picture_.correction(row, column)});
    });
    if (samples.size() < 100) return;
    SheetPicture::Tone tone = fitPaper(samples);
    std::vector<float> ink[3];
    overCells(i, ink_, 1, [&](int row, int column, const cv::Vec3f& colour) {
      const cv::Vec3f rest = colour - paperAt(tone, row, column);
      for (int c = 0; c < 3; ++c) ink[c].push_back(rest[c]);
    });
    if (ink[0].size() >= 50)
      for (int c = 0; c < 3; ++c) tone.ink[c] = std::min(-0.1F, medianOf(ink[c]));
    picture_.tones[i] = tone;
  }

  cv::Vec3f paperAt(const SheetPicture::Tone& tone, int row, int column) const {
    return tone.paperAt(unit(static_cast<float>(column), printed_.cols),
                        unit(static_cast<float>(row), printed_.rows));
  }

  template <class Body>
  void overCells(std::size_t i, const cv::Mat1b& which, int stride, const Body& body) const {
    for (int row = 0; row < which.rows; row += stride)
      for (int column = 0; column < which.cols; column += stride) {
        const cv::Vec3b& sample = samples_[i](row, column);
        if (which(row, column) != 0 && isSeen(sample)) body(row, column, logs_(sample));
      }
  }

  // The mean of what looks like the printed picture, drawn towards it by one look of its own.
  void correct() {
    for (int row = 0; row < printed_.rows; ++row)
      for (int column = 0; column < printed_.cols; ++column) {
        if (printed_(row, column) < 0) continue;
        cv::Vec3f sum(0, 0, 0);
        float total = 1;
        for (std::size_t i = 0; i < samples_.size(); ++i) {
          const cv::Vec3b& sample = samples_[i](row, column);
          if (!isSeen(sample)) continue;
          const SheetPicture::Tone& tone = picture_.tones[i];
          const cv::Vec3f rest =
              logs_(sample) - paperAt(tone, row, column) - mixture(printed_(row, column), tone.ink);
          const float w = bareWeight(rest, kStain);
          sum += w * rest;
          total += w;
        }
        picture_.correction(row, column) = sum * (1 / total);
      }
  }

  // What is left of a photograph's colours, thousandths, at every second cell of every second row:
  // shadows are smooth.
  std::vector<SheetRest> restsOfAll() const {
    std::vector<SheetRest> rests;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      SheetRest rest((printed_.rows + 1) / 2, (printed_.cols + 1) / 2, kNoRest);
      for (int row = 0; row < rest.rows; ++row)
        for (int column = 0; column < rest.cols; ++column)
          if (printed_(2 * row, 2 * column) >= 0 && isSeen(samples_[i](2 * row, 2 * column)))
            rest(row, column) = restAt(i, 2 * row, 2 * column) * 1000;
      rests.push_back(std::move(rest));
    }
    return rests;
  }

  // A photograph's colour at a cell against the printed picture.
  cv::Vec3f restAt(std::size_t i, int row, int column) const {
    const SheetPicture::Tone& tone = picture_.tones[i];
    return logs_(samples_[i](row, column)) - paperAt(tone, row, column) -
           mixture(printed_(row, column), tone.ink) - picture_.correction(row, column);
  }

  // SD of the brightness of lit paper from photograph to photograph.
  float grain() const {
    std::vector<float> off;
    for (std::size_t i = 0; i < samples_.size(); ++i)
      for (int row = 0; row < printed_.rows; row += 4 * kSheetStride)
        for (int column = 0; column < printed_.cols; column += 4 * kSheetStride)
          if (paper_(row, column) != 0 && isSeen(samples_[i](row, column)))
            off.push_back(std::abs(brightnessOfRest(restAt(i, row, column))));
    return off.empty() ? 0.02F : std::max(0.005F, 1.4826F * medianOf(off));
  }

  // Where light stands still so do shadows: they lie on the sheet and darken it alike in every
  // photograph that sees the place. What stands above the sheet shows another of its places to
  // each, and its grain tells.
  void shade(const std::vector<SheetRest>& rests) {
    const float grain_sd = grain();
    const int rows = rests[0].rows, columns = rests[0].cols;
    const std::vector<cv::Mat1b> counts = agreeingPhotographs(rests, grain_sd);
    cv::Mat3f shades(rows, columns, cv::Vec3f::all(0));
    cv::Mat1f agreed(rows, columns, 0.F);
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        if (const auto shade = shadeAt(rests, counts, coveredAt(row, column), row, column)) {
          shades(row, column) = *shade;
          agreed(row, column) = 1;
        }
    forgetEvenClay(shades, agreed);
    // A photograph's own noise goes; the edge of what agreed stays.
    cv::boxFilter(shades, shades, CV_32F, {3, 3}, {-1, -1}, false);
    cv::Mat1f weight;
    cv::boxFilter(agreed, weight, CV_32F, {3, 3}, {-1, -1}, false);
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        shades(row, column) *= agreed(row, column) / std::max(1.F, weight(row, column));
    picture_.witnessed = cv::Mat1b(printed_.size(), uchar{0});
    picture_.shade = cv::Mat1b(printed_.size(), uchar{0});
    for (int row = 0; row < printed_.rows; ++row)
      for (int column = 0; column < printed_.cols; ++column) {
        picture_.correction(row, column) += shades(row / 2, column / 2);
        picture_.witnessed(row, column) = agreed(row / 2, column / 2) > 0 ? 255 : 0;
        if (brightnessOfRest(shades(row / 2, column / 2)) < -kStain.brightness)
          picture_.shade(row, column) = picture_.witnessed(row, column);
      }
    picture_.standing = standing(rests, counts, agreed);
  }

  // Plain paper that many photographs look at and no three show alike: they look at something in
  // front of it, each at another part. Those taken from low down do agree on what lies below an
  // overhang. Photographs were compared over a window, so the place is too large by half of one all
  // around, and where a shadow ends it is as narrow as one.
  cv::Mat1b standing(const std::vector<SheetRest>& rests, const std::vector<cv::Mat1b>& counts,
                     const cv::Mat1f& agreed) const {
    cv::Mat1b stands(agreed.size(), uchar{0});
    for (int row = 0; row < stands.rows; ++row)
      for (int column = 0; column < stands.cols; ++column) {
        if (agreed(row, column) > 0 || paper_(2 * row, 2 * column) == 0) continue;
        int seen = 0, agreeing = 0;
        for (std::size_t i = 0; i < rests.size(); ++i) {
          if (!isKnown(rests[i](row, column))) continue;
          ++seen;
          agreeing = std::max(agreeing, counts[i](row, column) + 1);
        }
        if (seen >= kFewestWitnesses && agreeing <= kByChance) stands(row, column) = 255;
      }
    cv::erode(stands, stands,
              cv::getStructuringElement(cv::MORPH_RECT, {kShadeWindow, kShadeWindow}));
    cv::Mat1b whole;
    cv::resize(stands, whole, printed_.size(), 0, 0, cv::INTER_NEAREST);
    return whole;
  }

  // Even clay is as dark in every photograph, but its outline stands above the sheet, and around it
  // the photographs disagree. A shadow's border lies in the sheet's plane, too.
  static void forgetEvenClay(cv::Mat3f& shades, cv::Mat1f& agreed) {
    cv::Mat1b dark(agreed.size(), uchar{0}), lit(agreed.size(), uchar{0});
    for (int row = 0; row < agreed.rows; ++row)
      for (int column = 0; column < agreed.cols; ++column)
        if (agreed(row, column) > 0)
          (brightnessOfRest(shades(row, column)) < -kStain.brightness ? dark : lit)(row, column) =
              255;
    cv::dilate(lit, lit, cv::getStructuringElement(cv::MORPH_RECT, {kShadeWindow, kShadeWindow}));
    cv::Mat1b within;
    cv::erode(dark, within, cv::getStructuringElement(cv::MORPH_RECT, {3, 3}));
    cv::Mat1i part;
    const int parts = cv::connectedComponents(dark, part, 4, CV_32S);
    std::vector<int> border(static_cast<std::size_t>(parts)), open(border.size());
    for (int row = 0; row < part.rows; ++row)
      for (int column = 0; column < part.cols; ++column) {
        if (dark(row, column) == 0 || within(row, column) != 0) continue;
        const auto k = static_cast<std::size_t>(part(row, column));
        ++border[k];
        if (lit(row, column) != 0) ++open[k];
      }
    for (int row = 0; row < part.rows; ++row)
      for (int column = 0; column < part.cols; ++column) {
        const auto k = static_cast<std::size_t>(part(row, column));
        if (k == 0 || open[k] >= kOpenBorder * border[k]) continue;
        agreed(row, column) = 0;
        shades(row, column) = cv::Vec3f::all(0);
      }
  }

  // By photograph: with how many others it agrees over the window around a place.
  static std::vector<cv::Mat1b> agreeingPhotographs(const std::vector<SheetRest>& rests,
                                                    float grain_sd) {
    const cv::Size size = rests[0].size();
    std::vector<cv::Mat1b> counts(rests.size());
    for (cv::Mat1b& count : counts) count = cv::Mat1b(size, uchar{0});
    cv::Mat1f off(size), mean;
    for (std::size_t i = 0; i < rests.size(); ++i)
      for (std::size_t j = i + 1; j < rests.size(); ++j) {
        for (int row = 0; row < size.height; ++row)
          for (int column = 0; column < size.width; ++column) {
            const cv::Vec3s &a = rests[i](row, column), &b = rests[j](row, column);
            const bool both = isKnown(a) && isKnown(b);
            off(row, column) = both ? 0.001F * static_cast<float>(std::max({std::abs(a[0] - b[0]),
                                                                            std::abs(a[1] - b[1]),
                                                                            std::abs(a[2] - b[2])}))
                                    : 10.F;
          }
        cv::boxFilter(off, mean, CV_32F, {kShadeWindow, kShadeWindow});
        for (int row = 0; row < size.height; ++row)
          for (int column = 0; column < size.width; ++column) {
            if (mean(row, column) > 1) continue;
            const cv::Vec3s& a = rests[i](row, column);
            const float g = static_cast<float>(a[0] + a[1] + a[2]) / 3000;
            // The largest of three channels' differences is 1.7 SD in the mean; shot noise grows
            // with the root of the darkening.
            if (mean(row, column) > 4 * grain_sd * std::exp(-0.5F * std::min(g, 0.F))) continue;
            ++counts[i](row, column);
            ++counts[j](row, column);
          }
      }
    return counts;
  }

  // By how many photographs a place, row and column of half the cells, is seen to be covered.
  int coveredAt(int row, int column) const {
    return static_cast<int>(std::ranges::count_if(
        covered_, [&](const cv::Mat1b& covered) { return covered(2 * row, 2 * column) != 0; }));
  }

  // What the photograph with most company sees at a place, where it is a shadow's; `covered` others
  // look at something before it.
  static std::optional<cv::Vec3f> shadeAt(const std::vector<SheetRest>& rests,
                                          const std::vector<cv::Mat1b>& counts, int covered,
                                          int row, int column) {
    std::size_t best = 0;
    int seen = covered;
    for (std::size_t i = 0; i < rests.size(); ++i) {
      if (counts[i](row, column) > counts[best](row, column)) best = i;
      seen += isKnown(rests[i](row, column)) ? 1 : 0;
    }
    const int agreeing = counts[best](row, column) + 1;
    const cv::Vec3f shade = logsOf(rests[best](row, column));
    const double needed = brightnessOfRest(shade) < kDark ? kMostAgree : kSomeAgree;
    if (agreeing < kFewestWitnesses || agreeing < needed * seen || !mayBeShadow(shade))
      return std::nullopt;
    return shade;
  }

  std::span<const cv::Mat3b> samples_;
  std::span<const cv::Mat1b> covered_;
  const cv::Mat1f& printed_;
  cv::Mat1b paper_, ink_;
  Logs logs_;
  SheetPicture picture_;
};

}  // namespace

cv::Vec3f SheetPicture::Tone::paperAt(float u, float v) const {
  return paper[0] + u * paper[1] + v * paper[2] + u * u * paper[3] + u * v * paper[4] +
         v * v * paper[5];
}

Result<cv::Mat1f> printedSheet(const batch::Plate& plate, const PlateGrid& grid) {
  cv::Ptr<cv::aruco::Dictionary> dictionary;
  if (!plate.markers.empty()) {
    const auto found = rig::markerDictionary(plate.dictionary);
    if (!found) return found.error();
    dictionary = *found;
  }
  const int size = grid.size * kDrawnFiner;
  cv::Mat1b fine(size, size, uchar{255});
  constexpr int kShift = 4;  // sixteenths of a fine cell
  const auto place = [&](const Eigen::Vector2d& p_mm) {
    const Eigen::Vector2d cell =
        p_mm / grid.pitch_mm + Eigen::Vector2d::Constant(grid.middle());  // of the grid
    const Eigen::Vector2d fine_cell = (cell.array() + 0.5) * kDrawnFiner - 0.5;
    return cv::Point(cvRound(fine_cell.x() * (1 << kShift)),
                     cvRound(fine_cell.y() * (1 << kShift)));
  };
  const int modules = dictionary ? dictionary->markerSize + 2 : 0;
  for (const batch::Marker& marker : plate.markers) {
    cv::Mat bits;
    dictionary->drawMarker(marker.id, modules, bits, 1);
    const auto at = [&](int column, int row) {
      const double u = static_cast<double>(column) / modules,
                   v = static_cast<double>(row) / modules;
      const Eigen::Vector3d p = (1 - v) * ((1 - u) * marker.corners[0] + u * marker.corners[1]) +
                                v * ((1 - u) * marker.corners[3] + u * marker.corners[2]);
      return place(p.head<2>());
    };
    for (int row = 0; row < modules; ++row)
      for (int column = 0; column < modules; ++column) {
        if (bits.at<std::uint8_t>(row, column) >= 128) continue;
        const std::vector<cv::Point> cell = {at(column, row), at(column + 1, row),
                                             at(column + 1, row + 1), at(column, row + 1)};
        cv::fillConvexPoly(fine, cell, cv::Scalar(0), cv::LINE_8, kShift);
      }
  }
  cv::Mat small;
  cv::resize(fine, small, {grid.size, grid.size}, 0, 0, cv::INTER_AREA);
  cv::Mat1f printed;
  small.convertTo(printed, CV_32F, 1 / 255.0);
  for (int row = 0; row < grid.size; ++row)
    for (int column = 0; column < grid.size; ++column) {
      const Eigen::Vector2d p =
          grid.pitch_mm * Eigen::Vector2d(column - grid.middle(), row - grid.middle());
      if (!plate.sheet->contains(p) || (plate.round && p.norm() > grid.radius_mm))
        printed(row, column) = -1;
    }
  return printed;
}

SheetPicture buildSheetPicture(std::span<const cv::Mat3b> samples, const cv::Mat1f& printed,
                               std::span<const cv::Mat1b> covered) {
  return SheetPainter(samples, covered, printed).run();
}

cv::Mat3f predictBareSheet(const SheetPicture& picture, std::size_t index, const cv::Mat1f& printed,
                           const cv::Mat2f& grid_of_pixel, cv::Mat1b& known) {
  const SheetPicture::Tone& tone = picture.tones[index];
  cv::Mat1f paper;
  cv::Mat3f bare;
  cv::remap(printed, paper, grid_of_pixel, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT,
            cv::Scalar::all(-1));
  cv::remap(picture.correction, bare, grid_of_pixel, cv::noArray(), cv::INTER_LINEAR,
            cv::BORDER_CONSTANT, cv::Scalar::all(0));
  known.create(paper.size());
  for (int y = 0; y < bare.rows; ++y)
    for (int x = 0; x < bare.cols; ++x) {
      known(y, x) = paper(y, x) >= 0 ? 255 : 0;
      const cv::Vec2f& cell = grid_of_pixel(y, x);
      if (known(y, x) == 0)
        bare(y, x) = cv::Vec3f::all(0);
      else
        bare(y, x) += tone.paperAt(unit(cell[0], printed.cols), unit(cell[1], printed.rows)) +
                      mixture(paper(y, x), tone.ink);
    }
  return bare;
}

cv::Mat1b inkBehind(const cv::Mat1f& printed, const cv::Mat2f& grid_of_pixel) {
  cv::Mat1f paper;
  cv::remap(printed, paper, grid_of_pixel, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT,
            cv::Scalar::all(-1));
  cv::Mat1b ink;
  cv::inRange(paper, 0, 0.5, ink);
  return ink;
}

cv::Mat1b somethingStands(const SheetPicture& picture, const cv::Mat2f& grid_of_pixel) {
  cv::Mat1b stands(grid_of_pixel.size(), uchar{0});
  if (!picture.standing.empty())
    cv::remap(picture.standing, stands, grid_of_pixel, cv::noArray(), cv::INTER_NEAREST,
              cv::BORDER_CONSTANT, cv::Scalar::all(0));
  return stands;
}

cv::Mat1f seenBare(const SheetPicture& picture, const cv::Mat3f& residual,
                   const cv::Mat2f& grid_of_pixel) {
  cv::Mat1f bare(residual.size(), 0.F);
  if (picture.witnessed.empty()) return bare;
  cv::Mat1b witnessed;
  cv::remap(picture.witnessed, witnessed, grid_of_pixel, cv::noArray(), cv::INTER_NEAREST,
            cv::BORDER_CONSTANT, cv::Scalar::all(0));
  for (int y = 0; y < bare.rows; ++y)
    for (int x = 0; x < bare.cols; ++x)
      if (witnessed(y, x) != 0) bare(y, x) = bareWeight(residual(y, x), kStain);
  return bare;
}

}  // namespace ostraka::ground
