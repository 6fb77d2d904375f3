#include "capture/silhouettes.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "base/median.h"
#include "cloud/point_cloud.h"
#include "scan/touching.h"

namespace ostraka::capture {
namespace {

// Thresholds on log colours. Measured on dark and grey felt in 5 batches: the felt's own spread is
// 0.005-0.011 in tint, 0.023-0.044 in brightness, 0.012-0.024 in roughness.
constexpr float kLeastTint = 0.06f, kLeastBrightness = 0.15f, kLeastRoughness = 0.12f;
constexpr float kTintSpreads = 5, kBrightnessSpreads = 6, kRoughnessSpreads = 4;
constexpr float kDarkerThanShadow = 1.2f;  // no shadow under light from all around is as deep
constexpr double kNear_mm = 15;            // gaps beyond are known by their boxes only
constexpr double kLeastSolidity = 0.86;    // 48 outlines of 8 sherds from above: 0.875 and more
constexpr double kDoubtfulNeck = 0.6;      // of the smaller part's width
// Share of a disc about a point of an outline that lies inside: half at a straight edge, 0.75 in a
// right-angled notch. Opposite notches of 0.66 were on 2 of 219 outlines of single sherds (both of
// a grey one seen in part on grey felt) and on 44 of 45 outlines of two; the other had a waist.
constexpr double kNotchReach_mm = 5, kNotch = 0.66;
constexpr double kLongestSeam = 1.2;   // of the root of the smaller part's area
constexpr double kLeastPart_mm2 = 60;  // a sherd of a centimetre
constexpr float kDarkLevel = 4;        // keeps the noise of the darkest levels bounded

using Row6 = Eigen::Matrix<double, 1, 6>;

Row6 lightTerms(double x, double y) {
  Row6 row;
  row << 1, x, y, x * x, x * y, y * y;
  return row;
}

// The most frequent brightness among the samples: that of the felt, when most of it is bare.
float modeOf(const std::vector<float>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  constexpr int kBins = 60;
  const float width = std::max((*high - *low) / kBins, 1e-4f);
  std::vector<int> bins(kBins + 1, 0);
  for (const float v : values) ++bins[static_cast<std::size_t>((v - *low) / width)];
  int best = 0, most = -1;
  for (int k = 2; k + 2 <= kBins; ++k) {
    const int sum = bins[k - 2] + 2 * bins[k - 1] + 3 * bins[k] + 2 * bins[k + 1] + bins[k + 2];
    if (sum > most) {
      most = sum;
      best = k;
    }
  }
  return *low + (static_cast<float>(best) + 0.5f) * width;
}

struct Samples {
  std::vector<Row6> terms;
  std::vector<Eigen::RowVector3d> colours;
};

// The felt's log colour as a smooth function of the place: light falls off over centimetres.
// Robust: what does not fit (sherds) drops out in turns.
Eigen::Matrix<double, 6, 3> fitFelt(const Samples& samples, float& spread) {
  std::vector<float> brightness;
  for (const auto& c : samples.colours) brightness.push_back(static_cast<float>(c.mean()));
  const float mode = modeOf(brightness);
  std::vector<char> used(brightness.size());
  for (std::size_t i = 0; i < used.size(); ++i) used[i] = std::abs(brightness[i] - mode) < 0.35f;
  Eigen::Matrix<double, 6, 3> fit;
  fit.setZero();
  for (int round = 0; round < 6; ++round) {
    Eigen::Matrix<double, 6, 6> a = Eigen::Matrix<double, 6, 6>::Identity() * 1e-6;
    Eigen::Matrix<double, 6, 3> b = Eigen::Matrix<double, 6, 3>::Zero();
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (!used[i]) continue;
      a += samples.terms[i].transpose() * samples.terms[i];
      b += samples.terms[i].transpose() * samples.colours[i];
    }
    fit = a.ldlt().solve(b);
    std::vector<float> distance(used.size()), inside;
    for (std::size_t i = 0; i < used.size(); ++i) {
      const Eigen::RowVector3d left = samples.colours[i] - samples.terms[i] * fit;
      distance[i] = static_cast<float>(left.cwiseAbs().maxCoeff());
      if (used[i]) inside.push_back(distance[i]);
    }
    spread = std::max(3 * medianOf(std::move(inside)), 0.12f);
    for (std::size_t i = 0; i < used.size(); ++i) used[i] = distance[i] < spread;
  }
  return fit;
}

cv::Mat disc(int diameter) {
  return cv::getStructuringElement(cv::MORPH_ELLIPSE, {diameter, diameter});
}

// How each pixel of the map differs from the felt that was fitted there.
struct Difference {
  cv::Mat1f tint, brightness, roughness;
};

Difference differenceFrom(const cv::Mat3f& colours, const Eigen::Matrix<double, 6, 3>& fit) {
  const double middle = (colours.cols - 1) / 2.0;
  Difference d{cv::Mat1f(colours.size()), cv::Mat1f(colours.size()), {}};
  for (int y = 0; y < colours.rows; ++y) {
    // Along a row the felt is a parabola: lightTerms put together by powers of x.
    const double v = (middle - y) / middle;
    std::array<std::array<float, 3>, 3> row{};
    for (int k = 0; k < 3; ++k)
      row[static_cast<std::size_t>(k)] = {
          static_cast<float>(fit(0, k) + fit(2, k) * v + fit(5, k) * v * v),
          static_cast<float>(fit(1, k) + fit(4, k) * v), static_cast<float>(fit(3, k))};
    for (int x = 0; x < colours.cols; ++x) {
      const cv::Vec3f& c = colours(y, x);
      const float u = static_cast<float>((x - middle) / middle);
      const float b = c[0] - (row[0][0] + u * (row[0][1] + u * row[0][2])),
                  g = c[1] - (row[1][0] + u * (row[1][1] + u * row[1][2])),
                  r = c[2] - (row[2][0] + u * (row[2][1] + u * row[2][2]));
      const float mean = (b + g + r) / 3;
      d.brightness(y, x) = mean;
      d.tint(y, x) =
          std::sqrt((b - mean) * (b - mean) + (g - mean) * (g - mean) + (r - mean) * (r - mean));
    }
  }
  cv::Mat1f mean, square;
  cv::boxFilter(d.brightness, mean, -1, {5, 5});
  cv::boxFilter(d.brightness.mul(d.brightness), square, -1, {5, 5});
  cv::Mat1f variance = square - mean.mul(mean);
  variance = cv::max(variance, 0);
  cv::sqrt(variance, d.roughness);
  return d;
}

cv::Mat1b differing(const Difference& d, const cv::Mat1b& seen, float spread) {
  std::vector<float> tint, brightness, roughness;
  for (int y = 0; y < seen.rows; ++y)
    for (int x = 0; x < seen.cols; ++x)
      if (seen(y, x) && std::abs(d.brightness(y, x)) + d.tint(y, x) < spread) {
        tint.push_back(d.tint(y, x));
        brightness.push_back(std::abs(d.brightness(y, x)));
        roughness.push_back(d.roughness(y, x));
      }
  const float most_tint = std::max(kLeastTint, kTintSpreads * medianOf(std::move(tint)));
  const float most_light =
      std::max(kLeastBrightness, kBrightnessSpreads * medianOf(std::move(brightness)));
  const float most_rough =
      std::max(kLeastRoughness, kRoughnessSpreads * medianOf(std::move(roughness)));
  cv::Mat1b rough = d.roughness > most_rough;
  cv::erode(rough, rough, disc(5));  // its window reaches over the outline
  cv::Mat1b all = (d.tint > most_tint) | (d.brightness > most_light) |
                  (d.brightness < -kDarkerThanShadow) | rough;
  return all & seen;
}

cv::Mat1b filled(const cv::Mat1b& mask) {
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(mask, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  cv::Mat1b whole(mask.size(), 0);
  cv::drawContours(whole, outlines, -1, 255, cv::FILLED);
  return whole;
}

// The thresholds lie far below a sherd's own difference, so the blur of its edge counts as sherd.
// The edge is where the difference is half of what it is further in.
void trimEdges(const Difference& d, cv::Mat1b& sherd) {
  cv::Mat1f strength, within(sherd.size(), 0.f), further_in;
  cv::magnitude(d.tint, d.brightness, strength);
  strength.copyTo(within, sherd);
  cv::dilate(within, further_in, disc(9));
  cv::Mat1b inside;
  cv::erode(sherd, inside, disc(7));
  const cv::Mat1b blurred = (strength < 0.5f * further_in) & ~inside;
  sherd.setTo(0, blurred);
  cv::morphologyEx(sherd, sherd, cv::MORPH_OPEN, disc(5));
}

}  // namespace

double freeRadius_mm(const batch::Plate& plate) {
  double radius = std::numeric_limits<double>::infinity();
  for (const batch::Marker& marker : plate.markers) {
    const double cell = (marker.corners[0] - marker.corners[1]).norm() / 6;
    for (const Eigen::Vector3d& corner : marker.corners)
      radius = std::min(radius, corner.head<2>().norm() - 1.25 * cell);  // and the quiet zone
  }
  return std::isfinite(radius) ? std::max(radius, 0.0) : 0.0;
}

PlateMap mapPlate(const cv::Mat& picture, const Eigen::Matrix3d& pixel_from_plate,
                  double radius_mm) {
  PlateMap map;
  map.radius_mm = radius_mm;
  const int size = static_cast<int>(2 * radius_mm / PlateMap::kPixelMm) + 1;
  Eigen::Matrix3d plate_from_map;
  plate_from_map << PlateMap::kPixelMm, 0, -radius_mm, 0, -PlateMap::kPixelMm, radius_mm, 0, 0, 1;
  const Eigen::Matrix3d pixel_from_map = pixel_from_plate * plate_from_map;
  const cv::Matx33d warp(pixel_from_map(0, 0), pixel_from_map(0, 1), pixel_from_map(0, 2),
                         pixel_from_map(1, 0), pixel_from_map(1, 1), pixel_from_map(1, 2),
                         pixel_from_map(2, 0), pixel_from_map(2, 1), pixel_from_map(2, 2));
  cv::Mat above;
  cv::warpPerspective(picture, above, warp, {size, size}, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP);
  cv::warpPerspective(cv::Mat1b(picture.size(), 255), map.seen, warp, {size, size},
                      cv::INTER_NEAREST | cv::WARP_INVERSE_MAP);
  cv::Mat1b within(size, size, uchar{0});
  cv::circle(within, {size / 2, size / 2}, size / 2 - 1, 255, cv::FILLED);
  map.seen &= within;
  cv::GaussianBlur(above, above, {0, 0}, 1.0);
  cv::Mat3f colours;
  above.convertTo(colours, CV_32F);
  colours += cv::Scalar::all(kDarkLevel);
  cv::log(colours, colours);

  Samples samples;
  const double middle = (size - 1) / 2.0;
  for (int y = 0; y < size; y += 4)
    for (int x = 0; x < size; x += 4)
      if (map.seen(y, x)) {
        const cv::Vec3f& c = colours(y, x);
        samples.terms.push_back(lightTerms((x - middle) / middle, (middle - y) / middle));
        samples.colours.emplace_back(c[0], c[1], c[2]);
      }
  map.sherd = cv::Mat1b(size, size, uchar{0});
  if (samples.terms.size() < 200) return map;  // hardly any of the disc is in the picture
  float spread = 0;
  const auto fit = fitFelt(samples, spread);
  const Difference difference = differenceFrom(colours, fit);
  cv::Mat1b mask = differing(difference, map.seen, spread);
  cv::morphologyEx(mask, mask, cv::MORPH_CLOSE, disc(3));
  cv::morphologyEx(filled(mask), map.sherd, cv::MORPH_OPEN, disc(7));
  trimEdges(difference, map.sherd);
  return map;
}

std::vector<MapPiece> piecesOf(const PlateMap& map, double smallest_mm) {
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(map.sherd, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  std::vector<MapPiece> pieces;
  const double radius_px = map.radius_mm / PlateMap::kPixelMm;
  for (std::vector<cv::Point>& outline : outlines) {
    const cv::Rect box = cv::boundingRect(outline);
    MapPiece piece;
    piece.extent_mm = std::max(box.width, box.height) * PlateMap::kPixelMm;
    if (piece.extent_mm < smallest_mm) continue;
    piece.area_mm2 = cv::contourArea(outline) * PlateMap::kPixelMm * PlateMap::kPixelMm;
    const cv::Moments m = cv::moments(outline);
    piece.centre_mm = m.m00 > 0 ? map.plate_mm(m.m10 / m.m00, m.m01 / m.m00)
                                : map.plate_mm(outline[0].x, outline[0].y);
    for (const cv::Point& p : outline) {
      // The picture ends beside this pixel, though the disc goes on.
      const cv::Rect around = cv::Rect(p.x - 2, p.y - 2, 5, 5) & cv::Rect({0, 0}, map.seen.size());
      const bool inner = std::hypot(p.x - radius_px, p.y - radius_px) < radius_px - 6;
      if (inner && cv::countNonZero(map.seen(around)) < around.area()) piece.cut_off = true;
    }
    piece.outline = std::move(outline);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

double gapBetween_mm(const MapPiece& a, const MapPiece& b) {
  const cv::Rect box_a = cv::boundingRect(a.outline), box_b = cv::boundingRect(b.outline);
  const int across = std::max(box_b.x - box_a.br().x, box_a.x - box_b.br().x),
            down = std::max(box_b.y - box_a.br().y, box_a.y - box_b.br().y);
  double nearest = std::max({across, down, 0});  // exact only where it matters
  if (nearest * PlateMap::kPixelMm > kNear_mm) return nearest * PlateMap::kPixelMm;
  nearest = std::numeric_limits<double>::infinity();
  for (const cv::Point& p : a.outline)
    for (const cv::Point& q : b.outline)
      nearest = std::min(nearest, std::hypot(p.x - q.x, p.y - q.y));
  return nearest * PlateMap::kPixelMm;
}

namespace {

int partsOf(const MapPiece& piece, double neck_share) {
  const cv::Rect box = cv::boundingRect(piece.outline);
  cv::Mat1b mask(box.size(), uchar{0});
  cv::drawContours(mask, std::vector<std::vector<cv::Point>>{piece.outline}, 0, 255, cv::FILLED,
                   cv::LINE_8, cv::noArray(), 0, -box.tl());
  PointCloud cloud;
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x)
      if (mask(y, x))
        cloud.points.emplace_back(static_cast<float>(x * PlateMap::kPixelMm),
                                  static_cast<float>(y * PlateMap::kPixelMm), 0.f);
  return scan::cutTouching(cloud, {.neck_share = neck_share}).count;
}

}  // namespace

int sherdsInPiece(const MapPiece& piece) {
  return partsOf(piece, scan::TouchingOptions().neck_share);
}

namespace {

// The deepest points of the outline's notches, as indices.
std::vector<std::size_t> notchesOf(const std::vector<cv::Point>& outline, const cv::Mat1b& mask) {
  const int reach = static_cast<int>(kNotchReach_mm / PlateMap::kPixelMm);
  cv::Mat1f share, window;
  disc(2 * reach + 1).convertTo(window, CV_32F);
  mask.convertTo(share, CV_32F, 1.0 / 255);
  cv::filter2D(share, share, -1, window / cv::sum(window)[0], {-1, -1}, 0, cv::BORDER_CONSTANT);
  std::vector<std::size_t> notches;
  const std::size_t n = outline.size();
  const auto at = [&](std::size_t i) { return share(outline[i % n]); };
  for (std::size_t i = 0; i < n; ++i) {
    if (at(i) < kNotch) continue;
    bool deepest = true;  // the first of several that are as deep
    for (std::size_t k = 1; deepest && k <= static_cast<std::size_t>(reach) && k < n; ++k)
      deepest = at(i + k) <= at(i) && at(i + n - k) < at(i);
    if (deepest) notches.push_back(i);
  }
  return notches;
}

bool liesWithin(const cv::Mat1b& mask, const cv::Point& a, const cv::Point& b) {
  cv::LineIterator line(mask, a, b);
  int outside = 0;
  for (int i = 0; i < line.count; ++i, ++line) outside += mask(line.pos()) == 0;
  return outside <= 0.03 * line.count;
}

}  // namespace

bool hasOppositeNotches(const MapPiece& piece) {
  const int border = static_cast<int>(kNotchReach_mm / PlateMap::kPixelMm) + 1;
  const cv::Rect box = cv::boundingRect(piece.outline);
  cv::Mat1b mask(box.height + 2 * border, box.width + 2 * border, uchar{0});
  std::vector<cv::Point> outline;
  for (const cv::Point& p : piece.outline)
    outline.push_back(p - box.tl() + cv::Point(border, border));
  cv::fillPoly(mask, std::vector<std::vector<cv::Point>>{outline}, 255);
  const std::vector<std::size_t> notches = notchesOf(outline, mask);
  constexpr double kPixel_mm2 = PlateMap::kPixelMm * PlateMap::kPixelMm;
  const double whole_mm2 = cv::contourArea(outline) * kPixel_mm2;
  for (std::size_t a = 0; a < notches.size(); ++a)
    for (std::size_t b = a + 1; b < notches.size(); ++b) {
      const auto first = outline.begin() + static_cast<std::ptrdiff_t>(notches[a]),
                 last = outline.begin() + static_cast<std::ptrdiff_t>(notches[b]);
      const double part_mm2 = cv::contourArea(std::vector<cv::Point>(first, last + 1)) * kPixel_mm2;
      const double smaller_mm2 = std::min(part_mm2, whole_mm2 - part_mm2);
      const double seam_mm = cv::norm(*first - *last) * PlateMap::kPixelMm;
      if (smaller_mm2 >= kLeastPart_mm2 && seam_mm <= kLongestSeam * std::sqrt(smaller_mm2) &&
          liesWithin(mask, *first, *last))
        return true;
    }
  return false;
}

bool mayBeSeveral(const MapPiece& piece) {
  std::vector<cv::Point> hull;
  cv::convexHull(piece.outline, hull);
  const double hull_mm2 = cv::contourArea(hull) * PlateMap::kPixelMm * PlateMap::kPixelMm;
  return piece.area_mm2 < kLeastSolidity * hull_mm2 || partsOf(piece, kDoubtfulNeck) > 1 ||
         hasOppositeNotches(piece);
}

}  // namespace ostraka::capture
