#include "colmap/colmap_format.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "base/message.h"
#include "files/files.h"

namespace ostraka::colmap {
namespace {

static_assert(std::endian::native == std::endian::little, "COLMAP's files are little endian");

class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}
  template <class T>
  T get() {
    T value{};
    if (rest_.size() < sizeof(T)) {
      good_ = false;
      rest_ = {};
      return value;
    }
    std::memcpy(&value, rest_.data(), sizeof(T));
    rest_.remove_prefix(sizeof(T));
    return value;
  }
  // A number of things of at least `bytes_each`; more than the file can hold makes it fail.
  std::uint64_t count(std::size_t bytes_each) {
    const auto value = get<std::uint64_t>();
    if (value <= rest_.size() / bytes_each) return value;
    good_ = false;
    return 0;
  }
  double number() {
    const auto value = get<double>();
    good_ = good_ && std::isfinite(value);
    return value;
  }
  std::string text() {
    const std::size_t end = rest_.find('\0');
    if (end == std::string_view::npos) {
      good_ = false;
      return {};
    }
    const std::string value(rest_.substr(0, end));
    rest_.remove_prefix(end + 1);
    return value;
  }
  bool good() const { return good_; }
  bool whole() const { return good_ && rest_.empty(); }

 private:
  std::string_view rest_;
  bool good_ = true;
};

Error damaged(const std::string& where) {
  return Error::unusable(
      message("The file is damaged or not in COLMAP's format; run COLMAP again."), where);
}

template <class T>
std::vector<T> byId(std::vector<T> list) {
  std::stable_sort(list.begin(), list.end(), [](const T& a, const T& b) { return a.id < b.id; });
  return list;
}

ColmapImage imageFrom(Reader& reader) {
  ColmapImage image;
  image.id = reader.get<std::uint32_t>();
  double q[4], t[3];
  for (double& value : q) value = reader.number();
  for (double& value : t) value = reader.number();
  const Eigen::Quaterniond turn(q[0], q[1], q[2], q[3]);
  if (turn.norm() > 1e-6) image.camera_from_world.linear() = turn.normalized().toRotationMatrix();
  image.camera_from_world.translation() = Eigen::Vector3d(t[0], t[1], t[2]);
  image.camera = reader.get<std::uint32_t>();
  image.name = reader.text();
  const std::uint64_t observations = reader.count(24);
  for (std::uint64_t k = 0; k < observations; ++k) {
    const double x = reader.get<double>(), y = reader.get<double>();
    image.observations.push_back({{x, y}, reader.get<std::int64_t>()});
  }
  return image;
}

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

}  // namespace

Result<std::vector<ColmapCamera>> parseColmapCameras(std::string_view bytes,
                                                     const std::string& where) {
  Reader reader(bytes);
  std::vector<ColmapCamera> cameras;
  const std::uint64_t count = reader.count(24);
  for (std::uint64_t k = 0; k < count && reader.good(); ++k) {
    ColmapCamera camera;
    camera.id = reader.get<std::uint32_t>();
    camera.model = reader.get<std::int32_t>();
    camera.width = reader.get<std::uint64_t>();
    camera.height = reader.get<std::uint64_t>();
    if (colmapParameterCount(camera.model) == 0) return damaged(where);
    for (int p = 0; p < colmapParameterCount(camera.model); ++p)
      camera.parameters.push_back(reader.number());
    cameras.push_back(std::move(camera));
  }
  if (!reader.whole()) return damaged(where);
  return byId(std::move(cameras));
}

Result<std::vector<ColmapImage>> parseColmapImages(std::string_view bytes,
                                                   const std::string& where) {
  Reader reader(bytes);
  std::vector<ColmapImage> images;
  const std::uint64_t count = reader.count(73);
  for (std::uint64_t k = 0; k < count && reader.good(); ++k) images.push_back(imageFrom(reader));
  if (!reader.whole()) return damaged(where);
  return byId(std::move(images));
}

Result<std::vector<ColmapPoint>> parseColmapPoints(std::string_view bytes,
                                                   const std::string& where) {
  Reader reader(bytes);
  std::vector<ColmapPoint> points;
  const std::uint64_t count = reader.count(51);
  for (std::uint64_t k = 0; k < count && reader.good(); ++k) {
    ColmapPoint point;
    point.id = reader.get<std::uint64_t>();
    for (int c = 0; c < 3; ++c) point.position[c] = reader.number();
    for (std::uint8_t& channel : point.colour) channel = reader.get<std::uint8_t>();
    point.error_px = reader.number();
    const std::uint64_t track = reader.count(8);
    for (std::uint64_t i = 0; i < track; ++i) {
      const auto image = reader.get<std::uint32_t>();
      point.track.push_back({image, reader.get<std::uint32_t>()});
    }
    points.push_back(std::move(point));
  }
  if (!reader.whole()) return damaged(where);
  return byId(std::move(points));
}

Result<ColmapModel> readColmapModel(const std::filesystem::path& folder) {
  std::string bytes[3], names[3];
  const char* stems[3] = {"cameras", "images", "points3D"};
  for (int k = 0; k < 3; ++k) {
    const std::filesystem::path file = folder / (std::string(stems[k]) + ".bin");
    Result<std::string> read = readFile(file);
    if (!read) return read.error();
    bytes[k] = std::move(*read);
    names[k] = file.string();
  }
  Result<std::vector<ColmapCamera>> cameras = parseColmapCameras(bytes[0], names[0]);
  if (!cameras) return cameras.error();
  Result<std::vector<ColmapImage>> images = parseColmapImages(bytes[1], names[1]);
  if (!images) return images.error();
  Result<std::vector<ColmapPoint>> points = parseColmapPoints(bytes[2], names[2]);
  if (!points) return points.error();
  return ColmapModel{std::move(*cameras), std::move(*images), std::move(*points)};
}

Result<void> writeColmapModel(const std::filesystem::path& folder, const ColmapModel& model) {
  if (auto done = writeFileAtomically(folder / "cameras.txt", written(model.cameras)); !done)
    return done;
  if (auto done = writeFileAtomically(folder / "images.txt", written(model.images)); !done)
    return done;
  return writeFileAtomically(folder / "points3D.txt", written(model.points));
}

}  // namespace ostraka::colmap
