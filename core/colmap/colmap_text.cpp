#include "colmap/colmap_text.h"

#include <charconv>
#include <cmath>
#include <optional>

#include "colmap/colmap_format.h"

namespace ostraka::colmap::colmap_text {
namespace {

Error badLine(std::size_t line, const std::string& where) {
  return {ErrorCode::UnusableInput,
          "Line " + std::to_string(line) + " is not in COLMAP's format; run COLMAP again.", where};
}

// Words of one line; the first failed conversion makes everything fail.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}
  std::string_view next() {
    while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\t')) rest_.remove_prefix(1);
    const std::size_t end = std::min(rest_.find_first_of(" \t"), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return word;
  }
  template <class T>
  T number() {
    const std::string_view word = next();
    T value{};
    const auto [end, failed] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (failed != std::errc() || end != word.data() + word.size()) good_ = false;
    if constexpr (std::is_floating_point_v<T>) good_ = good_ && std::isfinite(value);
    return value;
  }
  bool empty() {
    while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\t')) rest_.remove_prefix(1);
    return rest_.empty();
  }
  std::string_view remainder() { return empty() ? std::string_view() : rest_; }
  bool good() const { return good_; }

 private:
  std::string_view rest_;
  bool good_ = true;
};

class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}
  // Any line, even an empty one; nothing at the end.
  std::optional<std::string_view> next() {
    if (rest_.empty()) return std::nullopt;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++number_;
    return line;
  }
  std::optional<std::string_view> nextContent() {
    while (auto line = next())
      if (!line->empty() && (*line)[0] != '#') return line;
    return std::nullopt;
  }
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

void append(std::string& text, double value) {
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value).ptr;
  text.append(buffer, end);
  text += ' ';
}

void append(std::string& text, std::uint64_t value) {
  text += std::to_string(value) + " ";
}

void endLine(std::string& text) {
  if (text.ends_with(' ')) text.pop_back();
  text += '\n';
}

}  // namespace

Result<std::vector<ColmapCamera>> cameras(std::string_view text, const std::string& where) {
  std::vector<ColmapCamera> cameras;
  Lines lines(text);
  while (const auto line = lines.nextContent()) {
    Words words(*line);
    ColmapCamera camera;
    camera.id = words.number<std::uint32_t>();
    camera.model = colmapModelNumber(std::string(words.next()));
    camera.width = words.number<std::uint64_t>();
    camera.height = words.number<std::uint64_t>();
    for (int k = 0; k < colmapParameterCount(camera.model); ++k)
      camera.parameters.push_back(words.number<double>());
    if (!words.good() || !words.empty() || camera.model < 0) return badLine(lines.number(), where);
    cameras.push_back(std::move(camera));
  }
  return cameras;
}

Result<std::vector<ColmapImage>> images(std::string_view text, const std::string& where) {
  std::vector<ColmapImage> images;
  Lines lines(text);
  while (const auto line = lines.nextContent()) {
    Words words(*line);
    ColmapImage image;
    image.id = words.number<std::uint32_t>();
    double q[4], t[3];
    for (double& value : q) value = words.number<double>();
    for (double& value : t) value = words.number<double>();
    image.camera = words.number<std::uint32_t>();
    image.name = std::string(words.remainder());
    const Eigen::Quaterniond turn(q[0], q[1], q[2], q[3]);
    if (!words.good() || image.name.empty() || !(turn.norm() > 1e-6))
      return badLine(lines.number(), where);
    image.camera_from_world.linear() = turn.normalized().toRotationMatrix();
    image.camera_from_world.translation() = Eigen::Vector3d(t[0], t[1], t[2]);
    Words pixels(lines.next().value_or(std::string_view()));
    while (pixels.good() && !pixels.empty()) {
      const double x = pixels.number<double>(), y = pixels.number<double>();
      image.observations.push_back({{x, y}, pixels.number<std::int64_t>()});
    }
    if (!pixels.good()) return badLine(lines.number(), where);
    images.push_back(std::move(image));
  }
  return images;
}

Result<std::vector<ColmapPoint>> points(std::string_view text, const std::string& where) {
  std::vector<ColmapPoint> points;
  Lines lines(text);
  while (const auto line = lines.nextContent()) {
    Words words(*line);
    ColmapPoint point;
    point.id = words.number<std::uint64_t>();
    for (int k = 0; k < 3; ++k) point.position[k] = words.number<double>();
    for (std::uint8_t& channel : point.colour) channel = words.number<std::uint8_t>();
    point.error_px = words.number<double>();
    while (words.good() && !words.empty()) {
      const auto image = words.number<std::uint32_t>();
      point.track.push_back({image, words.number<std::uint32_t>()});
    }
    if (!words.good()) return badLine(lines.number(), where);
    points.push_back(std::move(point));
  }
  return points;
}

std::string written(const std::vector<ColmapCamera>& cameras) {
  std::string text = "# CAMERA_ID MODEL WIDTH HEIGHT PARAMS[]\n";
  for (const ColmapCamera& camera : cameras) {
    append(text, std::uint64_t{camera.id});
    text += std::string(colmapModelName(camera.model)) + " ";
    append(text, camera.width);
    append(text, camera.height);
    for (const double value : camera.parameters) append(text, value);
    endLine(text);
  }
  return text;
}

std::string written(const std::vector<ColmapImage>& images) {
  std::string text = "# IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME, then X Y POINT3D_ID ...\n";
  for (const ColmapImage& image : images) {
    const Eigen::Quaterniond q(image.camera_from_world.linear());
    append(text, std::uint64_t{image.id});
    for (const double value : {q.w(), q.x(), q.y(), q.z()}) append(text, value);
    for (int k = 0; k < 3; ++k) append(text, image.camera_from_world.translation()[k]);
    append(text, std::uint64_t{image.camera});
    text += image.name + "\n";
    // The second line must be there even when it is empty, or COLMAP aborts.
    for (const ColmapImage::Observation& seen : image.observations) {
      append(text, seen.pixel.x());
      append(text, seen.pixel.y());
      text += std::to_string(seen.point) + " ";
    }
    endLine(text);
  }
  return text;
}

std::string written(const std::vector<ColmapPoint>& points) {
  std::string text = "# POINT3D_ID X Y Z R G B ERROR TRACK[]\n";
  for (const ColmapPoint& point : points) {
    append(text, point.id);
    for (int k = 0; k < 3; ++k) append(text, point.position[k]);
    for (const std::uint8_t channel : point.colour) append(text, std::uint64_t{channel});
    append(text, point.error_px);
    for (const auto& seen : point.track)
      for (const std::uint32_t value : seen) append(text, std::uint64_t{value});
    endLine(text);
  }
  return text;
}

}  // namespace ostraka::colmap::colmap_text
