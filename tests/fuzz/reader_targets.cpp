#include "targets.h"

#include <nlohmann/json.hpp>
#include <string>

#include "batch/batch.h"
#include "capture/rig_devices.h"
#include "cloud/ply.h"
#include "evaluate/pairs.h"
#include "files/json.h"
#include "images/decode.h"
#include "images/heif_image.h"
#include "images/image_header.h"
#include "memory_file.h"
#include "must.h"
#include "rig/camera.h"
#include "rig/rig.h"
#include "segmentation/network_mask.h"
#include "turntables/text_turntable.h"

namespace ostraka::fuzz {
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

void image(std::string_view bytes) {
  const Result<images::ImageSize> size = images::imageSize(bytes, "fuzz.jpg");
  mustNameItself(size);
  if (!size) return;
  must(size->width > 0 && size->height > 0, "an image has a size");
  // Decoding a large one takes its time, and what decodes HEVC has fuzzers of its own.
  if (size->width * std::int64_t{size->height} > 1 << 18 || images::isHeif(bytes)) return;
  for (const images::Values values :
       {images::Values::Bgr, images::Values::Grey, images::Values::AsStored}) {
    const Result<cv::Mat> pixels = images::decodeImage(bytes, values, "fuzz.jpg");
    mustNameItself(pixels);
    if (pixels)
      must(pixels->cols == size->width && pixels->rows == size->height,
           "an image has the size that its header states");
  }
}

void rigFile(std::string_view bytes) {
  const MemoryFile file(bytes);
  const Result<rig::Rig> read = rig::readRig(file.path());
  mustNameItself(read);
  if (read)
    for (const rig::RigCamera& camera : read->cameras) {
      must(camera.camera_from_turntable.matrix().allFinite(), "poses are finite");
      must(camera.intrinsics.width > 0 && camera.intrinsics.height > 0, "pictures have a size");
    }
  mustNameItself(capture::readDevices(file.path()));
  const Result<nlohmann::json> value = parseJson(bytes, "fuzz.json");
  if (!value) return;
  const Result<turntables::TextDialect> dialect = turntables::dialectFromJson(*value);
  mustNameItself(dialect);
  if (dialect) must(dialect->check().has_value(), "a dialect that was read can be used");
}

void onnxHeader(std::string_view bytes) {
  const Result<cv::Size> size =
      segmentation::networkInputSize(bytes, {640, 480}, 1024, "fuzz.onnx");
  mustNameItself(size);
  if (size)
    must(size->width > 0 && size->width <= 8192 && size->height > 0 && size->height <= 8192,
         "a network's input fits into memory");
}

}  // namespace ostraka::fuzz
