#include "cloud/ply.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "base/limits.h"
#include "base/message.h"
#include "base/text.h"
#include "files/files.h"
#include "files/open_folder.h"

namespace ostraka {
namespace {

enum class Format { Ascii, Little, Big };
enum class Type { I8, U8, I16, U16, I32, U32, F32, F64 };

struct Property {
  std::string name;
  Type type = Type::F32;
  std::optional<Type> count_type;  // set for a list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Format format = Format::Ascii;
  std::vector<Element> elements;
  std::size_t size = 0;  // bytes up to the payload
};

std::size_t bytesOf(Type type) {
  switch (type) {
    case Type::I8:
    case Type::U8:
      return 1;
    case Type::I16:
    case Type::U16:
      return 2;
    case Type::F64:
      return 8;
    default:
      return 4;
  }
}

std::optional<Type> typeNamed(std::string_view name) {
  if (name == "char" || name == "int8") return Type::I8;
  if (name == "uchar" || name == "uint8") return Type::U8;
  if (name == "short" || name == "int16") return Type::I16;
  if (name == "ushort" || name == "uint16") return Type::U16;
  if (name == "int" || name == "int32") return Type::I32;
  if (name == "uint" || name == "uint32") return Type::U32;
  if (name == "float" || name == "float32") return Type::F32;
  if (name == "double" || name == "float64") return Type::F64;
  return {};
}

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> found;
  std::size_t at = 0;
  while (at < line.size()) {
    const std::size_t begin = line.find_first_not_of(" \t\r", at);
    if (begin == std::string_view::npos) break;
    const std::size_t end = std::min(line.find_first_of(" \t\r", begin), line.size());
    found.push_back(line.substr(begin, end - begin));
    at = end;
  }
  return found;
}

// One line of the header; an empty string when it was understood, else what is wrong with it.
Message readHeaderLine(const std::vector<std::string_view>& w, Header& header, bool& has_format) {
  if (w.empty() || w[0] == "comment" || w[0] == "obj_info") return {};
  if (w[0] == "format" && w.size() >= 2) {
    has_format = true;
    if (w[1] == "ascii")
      header.format = Format::Ascii;
    else if (w[1] == "binary_little_endian")
      header.format = Format::Little;
    else if (w[1] == "binary_big_endian")
      header.format = Format::Big;
    else
      return message("its format is unknown");
    return {};
  }
  if (w[0] == "element" && w.size() == 3) {
    Element element{std::string(w[1]), 0, {}};
    const auto [end, failed] =
        std::from_chars(w[2].data(), w[2].data() + w[2].size(), element.count);
    if (failed != std::errc() || end != w[2].data() + w[2].size())
      return message("a count is not a number");
    header.elements.push_back(std::move(element));
    return {};
  }
  if (w[0] == "property" && !header.elements.empty()) {
    const bool list = w.size() == 5 && w[1] == "list";
    if (!list && w.size() != 3) return message("a property cannot be read");
    Property property{std::string(w.back()), Type::F32, {}};
    const std::optional<Type> type = typeNamed(w[list ? 3 : 1]);
    if (!type) return message("a property has an unknown type");
    property.type = *type;
    if (list) {
      property.count_type = typeNamed(w[2]);
      if (!property.count_type || *property.count_type == Type::F32 ||
          *property.count_type == Type::F64)
        return message("the length of a list is not a whole number");
    }
    header.elements.back().properties.push_back(std::move(property));
    return {};
  }
  return message("a line cannot be parsed");
}

bool isMillimetre(std::string_view unit) {
  const std::string name = lowerCase(std::string(unit));
  return name == "mm" || name == "millimetre" || name == "millimetres" || name == "millimeter" ||
         name == "millimeters";
}

Result<Header> readHeader(std::string_view bytes, const std::string& where) {
  if (!bytes.starts_with("ply"))
    return Error::unusable(message("Not a PLY file; choose one, or export the scan again."), where);
  Header header;
  bool has_format = false;
  std::size_t at = 0;
  for (int line_number = 1; line_number < 1000; ++line_number) {
    const std::size_t end = bytes.find('\n', at);
    if (end == std::string_view::npos) break;
    const std::vector<std::string_view> w = words(bytes.substr(at, end - at));
    at = end + 1;
    if (line_number == 1) continue;
    if (w.size() == 3 && w[0] == "comment" && w[1] == "unit" && !isMillimetre(w[2]))
      return Error::unusable(message("The PLY file states its unit as '%1', but lengths must be in "
                                     "mm; export it in mm.",
                                     std::string(w[2].substr(0, 40))),
                             where);
    if (w.size() == 1 && w[0] == "end_header") {
      if (!has_format)
        return Error::unusable(message("The PLY header states no format; export the file again."),
                               where);
      header.size = at;
      return header;
    }
    const Message wrong = readHeaderLine(w, header, has_format);
    if (!wrong.empty())
      return Error::unusable(
          message("The PLY header has an error in line %1: %2; export the file again.", line_number,
                  wrong),
          where);
  }
  return Error::unusable(message("The PLY header has no end; export the file again."), where);
}

// The payload, value by value, whatever the format. `ok` turns false at the end of the file.
class Values {
 public:
  Values(std::string_view bytes, Format format) : bytes_(bytes), format_(format) {}

  double next(Type type) {
    if (format_ == Format::Ascii) return nextWord();
    const std::size_t n = bytesOf(type);
    if (bytes_.size() - at_ < n) {
      ok = false;
      return 0;
    }
    unsigned char raw[8] = {};
    std::memcpy(raw, bytes_.data() + at_, n);
    at_ += n;
    if (format_ == Format::Big) std::reverse(raw, raw + n);
    return decode(raw, type);
  }

  // Does anything follow what was read, other than blanks and zeros, which some programs append?
  bool isMoreLeft() const {
    return bytes_.find_first_not_of(std::string_view(" \t\r\n\0", 5), at_) !=
           std::string_view::npos;
  }

  bool ok = true;

 private:
  template <class T>
  static double as(const unsigned char* raw) {
    T value;
    std::memcpy(&value, raw, sizeof value);
    return static_cast<double>(value);
  }

  static double decode(const unsigned char* raw, Type type) {
    switch (type) {
      case Type::I8:
        return as<std::int8_t>(raw);
      case Type::U8:
        return as<std::uint8_t>(raw);
      case Type::I16:
        return as<std::int16_t>(raw);
      case Type::U16:
        return as<std::uint16_t>(raw);
      case Type::I32:
        return as<std::int32_t>(raw);
      case Type::U32:
        return as<std::uint32_t>(raw);
      case Type::F32:
        return as<float>(raw);
      case Type::F64:
        return as<double>(raw);
    }
    return 0;
  }

  double nextWord() {
    const std::size_t begin = bytes_.find_first_not_of(" \t\r\n", at_);
    if (begin == std::string_view::npos) {
      ok = false;
      return 0;
    }
    const std::size_t end = std::min(bytes_.find_first_of(" \t\r\n", begin), bytes_.size());
    double value = 0;
    const char* first = bytes_.data() + begin;
    if (*first == '+') ++first;
    const auto [stop, failed] = std::from_chars(first, bytes_.data() + end, value);
    if (failed == std::errc::invalid_argument || stop != bytes_.data() + end) ok = false;
    at_ = end;
    return value;
  }

  std::string_view bytes_;
  Format format_;
  std::size_t at_ = 0;
};

// The least number of bytes that one entry of this element can take.
std::size_t leastBytes(const Element& element, Format format) {
  std::size_t least = 0;
  for (const Property& p : element.properties)
    least += format == Format::Ascii ? 2 : bytesOf(p.count_type.value_or(p.type));
  return least;
}

// Where each property of a vertex goes.
struct VertexColumns {
  int xyz[3] = {-1, -1, -1}, normal[3] = {-1, -1, -1}, rgb[3] = {-1, -1, -1}, quality = -1,
      seen = -1;
};

VertexColumns columnsOf(const Element& element) {
  VertexColumns c;
  const auto place = [&](int i, std::string_view name) {
    const char* const xyz[] = {"x", "y", "z"};
    const char* const normal[] = {"nx", "ny", "nz"};
    const char* const long_normal[] = {"normal_x", "normal_y", "normal_z"};
    const char* const rgb[] = {"red", "green", "blue"};
    const char* const long_rgb[] = {"diffuse_red", "diffuse_green", "diffuse_blue"};
    for (int k = 0; k < 3; ++k) {
      if (name == xyz[k]) c.xyz[k] = i;
      if (name == normal[k] || name == long_normal[k]) c.normal[k] = i;
      if (name == rgb[k] || name == long_rgb[k]) c.rgb[k] = i;
    }
    if (name == "quality" || name == "confidence") c.quality = i;
    if (name == "scalar_seen") c.seen = i;
  };
  for (std::size_t i = 0; i < element.properties.size(); ++i)
    if (!element.properties[i].count_type) place(static_cast<int>(i), element.properties[i].name);
  return c;
}

bool all(const int (&columns)[3]) {
  return columns[0] >= 0 && columns[1] >= 0 && columns[2] >= 0;
}

float unit(double value, Type type) {
  return static_cast<float>(type == Type::F32 || type == Type::F64 ? value * 255.0 : value);
}

// A unit normal stays as it is, as far as floats tell: else each reading and writing of a file
// would change its last bits.
Eigen::Vector3f unitNormal(const Eigen::Vector3f& normal) {
  if (std::abs(normal.squaredNorm() - 1) < 8 * std::numeric_limits<float>::epsilon()) return normal;
  const float length = normal.norm();
  return std::isfinite(length) && length > 1e-12f ? Eigen::Vector3f(normal / length)
                                                  : Eigen::Vector3f::Zero();
}

// Vertices; new_index gets each vertex's place after dropping those that are not finite.
bool readVertices(const Element& element, Values& values, PlyContents& out,
                  std::vector<int>& new_index) {
  const VertexColumns c = columnsOf(element);
  const bool has_normals = all(c.normal), has_colors = all(c.rgb);
  std::vector<double> row(element.properties.size());
  for (std::size_t v = 0; v < element.count && values.ok; ++v) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const Property& p = element.properties[i];
      if (!p.count_type) {
        row[i] = values.next(p.type);
        continue;
      }
      const double n = values.next(*p.count_type);
      for (double k = 0; k < n && values.ok; ++k) values.next(p.type);
    }
    const auto vector = [&](const int(&at)[3]) {
      return Eigen::Vector3f(static_cast<float>(row[at[0]]), static_cast<float>(row[at[1]]),
                             static_cast<float>(row[at[2]]));
    };
    const Eigen::Vector3f point = vector(c.xyz);
    if (!point.allFinite() || point.cwiseAbs().maxCoeff() > 1e9f) {
      ++out.dropped_not_finite;
      new_index.push_back(-1);
      continue;
    }
    new_index.push_back(static_cast<int>(out.mesh.vertices.size()));
    out.mesh.vertices.push_back(point);
    if (has_normals) out.mesh.normals.push_back(unitNormal(vector(c.normal)));
    if (has_colors) {
      Color color{};
      for (int k = 0; k < 3; ++k) {
        const float level = unit(row[c.rgb[k]], element.properties[c.rgb[k]].type);
        color[k] = static_cast<std::uint8_t>(level >= 0 ? std::min(255.0f, level + 0.5f) : 0.0f);
      }
      out.mesh.colors.push_back(color);
    }
    if (c.quality >= 0) out.quality.push_back(static_cast<float>(row[c.quality]));
    if (c.seen >= 0) out.mesh.seen.push_back(row[c.seen] != 0 ? 1 : 0);
  }
  return values.ok;
}

enum class FaceOutcome { Fine, Truncated, AbsentVertex, TooManyCorners, TooManyFaces };

FaceOutcome readFaces(const Element& element, Values& values, const std::vector<int>& new_index,
                      PlyContents& out) {
  std::vector<int> polygon;
  for (std::size_t f = 0; f < element.count && values.ok; ++f) {
    for (const Property& p : element.properties) {
      if (!p.count_type) {
        values.next(p.type);
        continue;
      }
      const bool corners = p.name == "vertex_indices" || p.name == "vertex_index";
      const double n = values.next(*p.count_type);
      if (corners && n > static_cast<double>(limits::kFaceCorners.most))
        return FaceOutcome::TooManyCorners;
      polygon.clear();
      for (double k = 0; k < n && values.ok; ++k) {
        const double index = values.next(p.type);
        if (!corners || !values.ok) continue;
        if (!(index >= 0 && index < static_cast<double>(new_index.size())))
          return FaceOutcome::AbsentVertex;
        polygon.push_back(new_index[static_cast<std::size_t>(index)]);
      }
      if (!corners || !values.ok) continue;
      for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
        if (polygon[0] >= 0 && polygon[k] >= 0 && polygon[k + 1] >= 0)
          out.mesh.triangles.push_back({polygon[0], polygon[k], polygon[k + 1]});
      if (out.mesh.triangles.size() > limits::kFaces.most) return FaceOutcome::TooManyFaces;
    }
  }
  return values.ok ? FaceOutcome::Fine : FaceOutcome::Truncated;
}

bool skip(const Element& element, Values& values) {
  for (std::size_t i = 0; i < element.count && values.ok; ++i)
    for (const Property& p : element.properties) {
      const double n = p.count_type ? values.next(*p.count_type) : 1;
      for (double k = 0; k < n && values.ok; ++k) values.next(p.type);
    }
  return values.ok;
}

Error tooMany(const Limit& limit, const std::string& of, const std::string& where) {
  return Error::unusable(
      message("The PLY file has more than %1 of '%2'; export it with fewer.", limit.most, of),
      where);
}

Result<PointCloud> pointsOf(Result<PlyContents> contents, const std::filesystem::path& path) {
  if (!contents) return contents.error();
  if (contents->mesh.vertices.empty())
    return Error::unusable(
        message("The PLY file contains no usable points; export the scan again."), path.string());
  return PointCloud{std::move(contents->mesh.vertices), std::move(contents->mesh.normals),
                    std::move(contents->mesh.colors), std::move(contents->quality)};
}

}  // namespace

Result<PlyContents> parsePly(std::string_view bytes, const std::string& where) {
  const Result<Header> header = readHeader(bytes, where);
  if (!header) return header.error();
  PlyContents out;
  std::vector<int> new_index;
  Values values(bytes.substr(header->size), header->format);
  std::size_t left = bytes.size() - header->size;
  bool has_vertices = false;
  for (const Element& element : header->elements) {
    const std::size_t least = leastBytes(element, header->format);
    // An entry without properties takes no bytes; nothing real has a million of them.
    const bool too_many =
        least == 0 ? element.count > 1'000'000 : element.count > (left + 1) / least;
    const bool faces = element.name == "face";
    if (const Limit& limit = faces ? limits::kFaces : limits::kVertices;
        !too_many && element.count > limit.most)
      return tooMany(limit, element.name, where);
    if (too_many)
      return Error::unusable(message("The PLY header declares %1 of '%2', more than the file "
                                     "contains; the file may be truncated.",
                                     element.count, element.name),
                             where);
    left -= std::min(left, element.count * least);
    if (element.name == "vertex") {
      if (has_vertices)
        return Error::unusable(message("The PLY file has two lists of vertices; export it again."),
                               where);
      if (!all(columnsOf(element).xyz))
        return Error::unusable(message("The PLY vertices lack x, y or z; export the file again."),
                               where);
      has_vertices = true;
      if (!readVertices(element, values, out, new_index))
        return Error::unusable(message("The PLY file ends early or contains a value that is not a "
                                       "number; export it again."),
                               where);
    } else if (element.name == "face") {
      const FaceOutcome outcome = readFaces(element, values, new_index, out);
      if (outcome == FaceOutcome::AbsentVertex)
        return Error::unusable(message("A face of the PLY file refers to a vertex that does not "
                                       "exist; export the file again."),
                               where);
      if (outcome == FaceOutcome::TooManyCorners)
        return Error::unusable(message("A face of the PLY file has more than %1 corners; export "
                                       "the file again as triangles.",
                                       limits::kFaceCorners.most),
                               where);
      if (outcome == FaceOutcome::TooManyFaces) return tooMany(limits::kFaces, element.name, where);
      if (outcome == FaceOutcome::Truncated)
        return Error::unusable(
            message("The PLY file ends within '%1'; copy it again.", element.name), where);
    } else if (!skip(element, values)) {
      return Error::unusable(message("The PLY file ends within '%1'; copy it again.", element.name),
                             where);
    }
  }
  if (!has_vertices)
    return Error::unusable(message("The PLY file has no vertices; export the scan again."), where);
  if (values.isMoreLeft())
    return Error::unusable(
        message("The PLY file contains more data than its header declares; export it again."),
        where);
  return out;
}

Result<PlyContents> readPly(const std::filesystem::path& path) {
  const Result<std::string> bytes = readFile(path);
  if (!bytes) return bytes.error();
  return parsePly(*bytes, path.string());
}

Result<PointCloud> readPlyCloud(const std::filesystem::path& path) {
  return pointsOf(readPly(path), path);
}

Result<PlyContents> readPlyWithin(const std::filesystem::path& folder, std::string_view path) {
  Result<OpenFile> open = OpenFile::within(folder, path);
  if (!open) return open.error();
  const Result<std::string> bytes = open->readAll();
  return bytes ? parsePly(*bytes, open->name()) : Result<PlyContents>(bytes.error());
}

Result<PointCloud> readPlyCloudWithin(const std::filesystem::path& folder, std::string_view path) {
  return pointsOf(readPlyWithin(folder, path), folder / path);
}

}  // namespace ostraka
