#include "stages/batch_inputs.h"

#include <sys/stat.h>

#include <system_error>

#include "base/message.h"
#include "base/parallel.h"
#include "files/files.h"

namespace ostraka::stages {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::int64_t nanoseconds(const struct timespec& time) {
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

std::vector<fs::path> filesOf(const batch::Batch& batch) {
  std::vector<fs::path> files;
  for (const batch::Shot& shot : batch.shots) {
    files.push_back(shot.file);
    if (!shot.mask_file.empty()) files.push_back(shot.mask_file);
  }
  for (const batch::CalibrationShot& shot : batch.calibration) files.push_back(shot.file);
  for (const batch::CalibrationShot& shot : batch.empty_plates) files.push_back(shot.file);
  if (!batch.plate_file.empty()) files.push_back(batch.plate_file);
  std::error_code failed;
  for (const char* name : {"board.json", "scale.json"})
    if (fs::exists(batch.folder / name, failed)) files.push_back(batch.folder / name);
  return files;
}

// Of a plate that no file describes.
std::string hashOfPlate(const batch::Plate& plate) {
  ordered_json all{{"dictionary", plate.dictionary}};
  for (const batch::Marker& marker : plate.markers)
    for (const Eigen::Vector3d& corner : marker.corners)
      all["corners"].push_back({marker.id, corner.x(), corner.y(), corner.z()});
  return sha256(all.dump());
}

}  // namespace

BatchInputs::State BatchInputs::stateOf(const fs::path& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0) return {};
  return {found.st_dev, found.st_ino, found.st_size, nanoseconds(found.st_ctim),
          nanoseconds(found.st_mtim)};
}

std::string BatchInputs::hashOf(const fs::path& file) {
  const Result<std::string> bytes = readFile(file);
  return bytes ? sha256(*bytes) : "unreadable";
}

BatchInputs::BatchInputs(const batch::Batch& batch, int threads, const fs::path& network) {
  for (fs::path& file : filesOf(batch)) inputs_.push_back({std::move(file), {}, {}});
  const std::size_t of_batch = inputs_.size();
  if (!network.empty()) inputs_.push_back({network, {}, {}});
  parallelFor(inputs_.size(), threads, [&](std::size_t i) {
    inputs_[i].state = stateOf(inputs_[i].file);
    inputs_[i].hash = hashOf(inputs_[i].file);
  });
  for (std::size_t i = 0; i < of_batch; ++i)
    hashes_[inputs_[i].file.lexically_proximate(batch.folder).generic_string()] = inputs_[i].hash;
  if (!network.empty()) network_hash_ = inputs_.back().hash;
  if (batch.plate && batch.plate_file.empty()) hashes_["plate.json"] = hashOfPlate(*batch.plate);
}

Result<void> BatchInputs::checkUnchanged() const {
  for (const Input& input : inputs_)
    if (stateOf(input.file) != input.state && hashOf(input.file) != input.hash)
      return Error::unusable(message("The file has changed since the batch's processing began; "
                                     "nothing made from it is kept. "
                                     "Process the batch again."),
                             input.file);
  return {};
}

}  // namespace ostraka::stages
