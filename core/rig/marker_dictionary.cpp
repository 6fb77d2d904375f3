#include "rig/marker_dictionary.h"

#include <array>
#include <map>
#include <opencv2/aruco/charuco.hpp>
#include <utility>

#include "base/message.h"

namespace ostraka::rig {
namespace {

using Named = std::pair<const char*, cv::aruco::PREDEFINED_DICTIONARY_NAME>;

constexpr std::array<Named, 21> kDictionaries{{
    {"DICT_4X4_50", cv::aruco::DICT_4X4_50},
    {"DICT_4X4_100", cv::aruco::DICT_4X4_100},
    {"DICT_4X4_250", cv::aruco::DICT_4X4_250},
    {"DICT_4X4_1000", cv::aruco::DICT_4X4_1000},
    {"DICT_5X5_50", cv::aruco::DICT_5X5_50},
    {"DICT_5X5_100", cv::aruco::DICT_5X5_100},
    {"DICT_5X5_250", cv::aruco::DICT_5X5_250},
    {"DICT_5X5_1000", cv::aruco::DICT_5X5_1000},
    {"DICT_6X6_50", cv::aruco::DICT_6X6_50},
    {"DICT_6X6_100", cv::aruco::DICT_6X6_100},
    {"DICT_6X6_250", cv::aruco::DICT_6X6_250},
    {"DICT_6X6_1000", cv::aruco::DICT_6X6_1000},
    {"DICT_7X7_50", cv::aruco::DICT_7X7_50},
    {"DICT_7X7_100", cv::aruco::DICT_7X7_100},
    {"DICT_7X7_250", cv::aruco::DICT_7X7_250},
    {"DICT_7X7_1000", cv::aruco::DICT_7X7_1000},
    {"DICT_ARUCO_ORIGINAL", cv::aruco::DICT_ARUCO_ORIGINAL},
    {"DICT_APRILTAG_16h5", cv::aruco::DICT_APRILTAG_16h5},
    {"DICT_APRILTAG_25h9", cv::aruco::DICT_APRILTAG_25h9},
    {"DICT_APRILTAG_36h10", cv::aruco::DICT_APRILTAG_36h10},
    {"DICT_APRILTAG_36h11", cv::aruco::DICT_APRILTAG_36h11},
}};

using Corner = std::pair<int, int>;  // x, y

bool isInk(const cv::Mat& cells, int x, int y) {
  return x >= 0 && y >= 0 && x < cells.cols && y < cells.rows && cells.at<std::uint8_t>(y, x) < 128;
}

}  // namespace

Result<cv::Ptr<cv::aruco::Dictionary>> markerDictionary(const std::string& name) {
  for (const Named& named : kDictionaries)
    if (name == named.first) return cv::aruco::getPredefinedDictionary(named.second);
  return Error::unusable(
      message("The marker dictionary '%1' is unknown; use one such as DICT_4X4_100.", name));
}

std::vector<std::vector<Eigen::Vector2d>> outlinesOfInk(const cv::Mat& cells) {
  // Edges between ink and paper, ink to the right of their direction; ordered by where they start.
  std::multimap<Corner, Corner> edges;
  for (int y = 0; y < cells.rows; ++y)
    for (int x = 0; x < cells.cols; ++x) {
      if (!isInk(cells, x, y)) continue;
      if (!isInk(cells, x, y - 1)) edges.insert({{x, y}, {x + 1, y}});
      if (!isInk(cells, x + 1, y)) edges.insert({{x + 1, y}, {x + 1, y + 1}});
      if (!isInk(cells, x, y + 1)) edges.insert({{x + 1, y + 1}, {x, y + 1}});
      if (!isInk(cells, x - 1, y)) edges.insert({{x, y + 1}, {x, y}});
    }
  std::vector<std::vector<Eigen::Vector2d>> lines;
  while (!edges.empty()) {
    std::vector<Eigen::Vector2d> line;
    const Corner start = edges.begin()->first;
    Corner at = start;
    do {
      const auto edge = edges.find(at);
      line.emplace_back(at.first, at.second);
      at = edge->second;
      edges.erase(edge);
    } while (at != start);
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<Shape> boardInk(const batch::Board& board) {
  const auto dictionary = *markerDictionary(board.dictionary);
  const auto charuco = cv::aruco::CharucoBoard::create(
      board.squares_x, board.squares_y, static_cast<float>(board.square_mm),
      static_cast<float>(board.marker_mm), dictionary);
  constexpr int kSquare = 64;  // pixels: enough to tell black squares from those with a marker
  cv::Mat picture;
  charuco->draw({board.squares_x * kSquare, board.squares_y * kSquare}, picture, 0, 1);
  std::vector<Shape> shapes;
  int id = 0;  // OpenCV numbers the squares with markers row by row as drawn
  for (int y = 0; y < board.squares_y; ++y)
    for (int x = 0; x < board.squares_x; ++x) {
      const Eigen::Vector2d corner(x * board.square_mm, y * board.square_mm);
      cv::Mat cells = cv::Mat::zeros(1, 1, CV_8UC1);
      double side = board.square_mm;
      Eigen::Vector2d from = corner;
      if (picture.at<std::uint8_t>(y * kSquare + 3, x * kSquare + 3) > 127) {
        const int count = dictionary->markerSize + 2;
        cv::aruco::drawMarker(dictionary, id++, count, cells, 1);
        side = board.marker_mm;
        from += Eigen::Vector2d::Constant((board.square_mm - board.marker_mm) / 2);
      }
      Shape shape{outlinesOfInk(cells), true, 0.0, {}, 0, 0};
      for (auto& line : shape.lines)
        for (Eigen::Vector2d& p : line) p = from + p * (side / cells.cols);
      shapes.push_back(std::move(shape));
    }
  return shapes;
}

Shape markerInk(const cv::Ptr<cv::aruco::Dictionary>& dictionary, int id,
                const std::array<Eigen::Vector2d, 4>& corners) {
  cv::Mat picture;
  const int cells = dictionary->markerSize + 2;
  cv::aruco::drawMarker(dictionary, id, cells, picture, 1);
  Shape shape{outlinesOfInk(picture), true, 0.0, {}, 0, 0};
  for (auto& line : shape.lines)
    for (Eigen::Vector2d& p : line)
      p = corners[0] +
          (p.x() * (corners[1] - corners[0]) + p.y() * (corners[3] - corners[0])) / cells;
  return shape;
}

}  // namespace ostraka::rig
