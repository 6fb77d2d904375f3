#include "targets.h"

#include <sys/mman.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <string>

#include "base/json.h"
#include "batch/batch.h"
#include "batch/image_header.h"
#include "cloud/ply.h"
#include "evaluate/pairs.h"
#include "must.h"
#include "rig/camera.h"

namespace ostraka::fuzz {
namespace {

// The bytes as a file that is in memory only.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes) : fd_(::memfd_create("fuzz", 0)) {
    must(::write(fd_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()), "memory");
  }
  ~MemoryFile() { ::close(fd_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(fd_); }

 private:
  int fd_;
};

}  // namespace

void ply(std::string_view bytes) {
  const Result<PlyContents> read = parsePly(bytes, "fuzz.ply");
  mustNameItself(read);
  if (!read) return;
  const TriangleMesh& mesh = read->mesh;
  const std::size_t n = mesh.vertices.size();
  const auto fits = [&](std::size_t size) { return size == 0 || size == n; };
  must(fits(mesh.normals.size()) && fits(mesh.colors.size()) && fits(mesh.seen.size()) &&
           fits(read->quality.size()),
       "arrays are empty or as long as the vertices");
  for (const Eigen::Vector3f& v : mesh.vertices) must(v.allFinite(), "points are finite");
  for (const Eigen::Vector3f& v : mesh.normals) must(v.allFinite(), "normals are finite");
  for (const auto& t : mesh.triangles)
    for (const int v : t) must(v >= 0 && static_cast<std::size_t>(v) < n, "faces name vertices");
  const std::string written = formatPly(mesh, "fuzz");
  const Result<PlyContents> again = parsePly(written, "again.ply");
  must(again.has_value() && again->mesh.vertices == mesh.vertices &&
           again->mesh.triangles == mesh.triangles,
       "what was read can be written and read");
}

void json(std::string_view bytes) {
  const Result<nlohmann::json> value = parseJson(bytes, "fuzz.json");
  mustNameItself(value);
  if (!value) return;
  mustNameItself(isometryFromJson(*value, "fuzz.json"));
  const MemoryFile file(bytes);
  mustNameItself(rig::readCameras(file.path()));
  mustNameItself(batch::readPlate(file.path()));
  mustNameItself(batch::readBoard(file.path()));
  mustNameItself(batch::readKnownLengths(file.path()));
  mustNameItself(evaluate::readProposal(file.path()));
  mustNameItself(evaluate::readPairsTruth(file.path()));
}

void imageHeader(std::string_view bytes) {
  const Result<batch::ImageSize> size = batch::imageSize(bytes, "fuzz.jpg");
  mustNameItself(size);
  if (size) must(size->width > 0 && size->height > 0, "an image has a size");
}

}  // namespace ostraka::fuzz
