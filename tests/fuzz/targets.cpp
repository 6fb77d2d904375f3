#include "targets.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "base/json.h"
#include "batch/batch.h"
#include "batch/image_header.h"
#include "capture/comxim.h"
#include "capture/grbl.h"
#include "capture/text_turntable.h"
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

template <class T>
void mustNameItself(const Result<T>& result) {
  if (!result) must(!result.error().what.empty(), "an error has a sentence");
}

// Says the bytes, cut into pieces, whatever it is told; then it is silent.
class SayingChannel final : public capture::ByteChannel {
 public:
  SayingChannel(std::string_view bytes, std::shared_ptr<capture::Clock> clock)
      : bytes_(bytes), clock_(std::move(clock)) {}
  std::string name() const override { return "fuzz"; }
  Result<void> write(std::string_view) override { return {}; }
  Result<std::string> read(double timeout_s, std::stop_token stop) override {
    if (bytes_.empty()) {
      clock_->sleep(timeout_s > 0 ? timeout_s + 1e-6 : 0, stop);  // time passes
      return std::string();
    }
    std::string piece(bytes_.substr(0, 7));
    bytes_.remove_prefix(piece.size());
    clock_->sleep(0.01, stop);
    return piece;
  }
  Result<void> reopen(std::stop_token) override { return {}; }
  void close() override {}

 private:
  std::string_view bytes_;
  std::shared_ptr<capture::Clock> clock_;
};

class FuzzClock final : public capture::Clock {
 public:
  double now_s() override { return now_s_; }
  bool sleep(double seconds, std::stop_token) override {
    now_s_ += seconds;
    must(now_s_ < 1e5, "drivers give up in the end");
    return true;
  }

 private:
  double now_s_ = 0;
};

// An open table that was told to turn either stands there or says what is wrong.
void mustStandOrSay(const Result<std::unique_ptr<capture::Turntable>>& table) {
  mustNameItself(table);
  if (!table) return;
  mustNameItself((*table)->zeroHere({}));
  const Result<void> moved = (*table)->moveTo(45, {});
  mustNameItself(moved);
  if (moved)
    must(std::abs((*table)->position_deg().value_or(1e9) - 45) < 0.5,
         "arrived is where it was told");
}

}  // namespace

void deviceReplies(std::string_view bytes) {
  for (std::string_view rest = bytes; !rest.empty();) {
    const std::size_t end = rest.find_first_of("\n;");
    const std::string_view line = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    if (const auto report = capture::parseGrblReport(line))
      must(!report->machine || std::isfinite(*report->machine), "positions are finite");
    (void)capture::grblTrouble(line);
    for (const auto dialect : {capture::ComXimDialect::Brackets, capture::ComXimDialect::Commas})
      must(std::isfinite(capture::parseComXimReply(line, dialect).angle_deg), "angles are finite");
  }
  const auto clock = std::make_shared<FuzzClock>();
  mustStandOrSay(capture::openGrbl(std::make_unique<SayingChannel>(bytes, clock), {}, clock, {}));
  for (const auto dialect : {capture::ComXimDialect::Brackets, capture::ComXimDialect::Commas}) {
    capture::ComXimOptions options;
    options.dialect = dialect;
    mustStandOrSay(
        capture::openComXim(std::make_unique<SayingChannel>(bytes, clock), options, clock, {}));
  }
  mustStandOrSay(
      capture::openTextTable(std::make_unique<SayingChannel>(bytes, clock), {}, clock, {}));
}

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
  mustNameItself(evaluate::readProposal(file.path()));
  mustNameItself(evaluate::readPairsTruth(file.path()));
}

void imageHeader(std::string_view bytes) {
  const Result<batch::ImageSize> size = batch::imageSize(bytes, "fuzz.jpg");
  mustNameItself(size);
  if (size) must(size->width > 0 && size->height > 0, "an image has a size");
}

}  // namespace ostraka::fuzz
