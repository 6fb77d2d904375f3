#include "colmap/colmap_format.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "colmap/colmap_text.h"
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

template <class T>
void put(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

Error damaged(const std::string& where) {
  return {ErrorCode::UnusableInput,
          "The file is damaged or not in COLMAP's format; run COLMAP again.", where};
}

template <class T>
Result<std::vector<T>> byId(Result<std::vector<T>> list) {
  if (list)
    std::stable_sort(list->begin(), list->end(),
                     [](const T& a, const T& b) { return a.id < b.id; });
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

}  // namespace

Result<std::vector<ColmapCamera>> parseColmapCameras(std::string_view bytes, ColmapFormat format,
                                                     const std::string& where) {
  if (format == ColmapFormat::Text) return byId(colmap_text::cameras(bytes, where));
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
  return byId(Result<std::vector<ColmapCamera>>(std::move(cameras)));
}

Result<std::vector<ColmapImage>> parseColmapImages(std::string_view bytes, ColmapFormat format,
                                                   const std::string& where) {
  if (format == ColmapFormat::Text) return byId(colmap_text::images(bytes, where));
  Reader reader(bytes);
  std::vector<ColmapImage> images;
  const std::uint64_t count = reader.count(73);
  for (std::uint64_t k = 0; k < count && reader.good(); ++k) images.push_back(imageFrom(reader));
  if (!reader.whole()) return damaged(where);
  return byId(Result<std::vector<ColmapImage>>(std::move(images)));
}

Result<std::vector<ColmapPoint>> parseColmapPoints(std::string_view bytes, ColmapFormat format,
                                                   const std::string& where) {
  if (format == ColmapFormat::Text) return byId(colmap_text::points(bytes, where));
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
  return byId(Result<std::vector<ColmapPoint>>(std::move(points)));
}

std::string colmapBytes(const std::vector<ColmapCamera>& cameras, ColmapFormat format) {
  if (format == ColmapFormat::Text) return colmap_text::written(cameras);
  std::string bytes;
  put(bytes, std::uint64_t{cameras.size()});
  for (const ColmapCamera& camera : cameras) {
    put(bytes, camera.id);
    put(bytes, std::int32_t{camera.model});
    put(bytes, camera.width);
    put(bytes, camera.height);
    for (const double value : camera.parameters) put(bytes, value);
  }
  return bytes;
}

std::string colmapBytes(const std::vector<ColmapImage>& images, ColmapFormat format) {
  if (format == ColmapFormat::Text) return colmap_text::written(images);
  std::string bytes;
  put(bytes, std::uint64_t{images.size()});
  for (const ColmapImage& image : images) {
    const Eigen::Quaterniond q(image.camera_from_world.linear());
    put(bytes, image.id);
    for (const double value : {q.w(), q.x(), q.y(), q.z()}) put(bytes, value);
    for (int k = 0; k < 3; ++k) put(bytes, double{image.camera_from_world.translation()[k]});
    put(bytes, image.camera);
    bytes += image.name + '\0';
    put(bytes, std::uint64_t{image.observations.size()});
    for (const ColmapImage::Observation& seen : image.observations) {
      put(bytes, double{seen.pixel.x()});
      put(bytes, double{seen.pixel.y()});
      put(bytes, seen.point);
    }
  }
  return bytes;
}

std::string colmapBytes(const std::vector<ColmapPoint>& points, ColmapFormat format) {
  if (format == ColmapFormat::Text) return colmap_text::written(points);
  std::string bytes;
  put(bytes, std::uint64_t{points.size()});
  for (const ColmapPoint& point : points) {
    put(bytes, point.id);
    for (int k = 0; k < 3; ++k) put(bytes, double{point.position[k]});
    for (const std::uint8_t channel : point.colour) put(bytes, channel);
    put(bytes, point.error_px);
    put(bytes, std::uint64_t{point.track.size()});
    for (const auto& seen : point.track)
      for (const std::uint32_t value : seen) put(bytes, value);
  }
  return bytes;
}

Result<ColmapModel> readColmapModel(const std::filesystem::path& folder) {
  std::error_code ignored;
  const bool binary = std::filesystem::exists(folder / "cameras.bin", ignored);
  const ColmapFormat format = binary ? ColmapFormat::Binary : ColmapFormat::Text;
  const char* ending = binary ? ".bin" : ".txt";
  std::string bytes[3], names[3];
  const char* stems[3] = {"cameras", "images", "points3D"};
  for (int k = 0; k < 3; ++k) {
    const std::filesystem::path file = folder / (std::string(stems[k]) + ending);
    Result<std::string> read = readFile(file);
    if (!read) return read.error();
    bytes[k] = std::move(*read);
    names[k] = file.string();
  }
  Result<std::vector<ColmapCamera>> cameras = parseColmapCameras(bytes[0], format, names[0]);
  if (!cameras) return cameras.error();
  Result<std::vector<ColmapImage>> images = parseColmapImages(bytes[1], format, names[1]);
  if (!images) return images.error();
  Result<std::vector<ColmapPoint>> points = parseColmapPoints(bytes[2], format, names[2]);
  if (!points) return points.error();
  return ColmapModel{std::move(*cameras), std::move(*images), std::move(*points)};
}

Result<void> writeColmapModel(const std::filesystem::path& folder, const ColmapModel& model,
                              ColmapFormat format) {
  const std::string ending = format == ColmapFormat::Binary ? ".bin" : ".txt";
  if (auto done =
          writeFileAtomically(folder / ("cameras" + ending), colmapBytes(model.cameras, format));
      !done)
    return done;
  if (auto done =
          writeFileAtomically(folder / ("images" + ending), colmapBytes(model.images, format));
      !done)
    return done;
  return writeFileAtomically(folder / ("points3D" + ending), colmapBytes(model.points, format));
}

}  // namespace ostraka::colmap
