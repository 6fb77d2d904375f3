#include "evaluate/truth.h"

#include <nlohmann/json.hpp>

#include "base/limits.h"
#include "cloud/ply.h"
#include "files/contained_path.h"
#include "files/json.h"

namespace ostraka::evaluate {
namespace {

using Json = nlohmann::json;

Result<TrueSherd> readSherd(const Json& entry, const std::filesystem::path& folder,
                            const std::filesystem::path& file) {
  if (!entry.is_object() || !entry.contains("mesh") || !entry["mesh"].is_string() ||
      !entry.contains("plate_from_model_front"))
    return Error::unusable("A true sherd lacks mesh or plate_from_model_front.", file);
  TrueSherd sherd;
  const Json id = entry.value("id", Json(nullptr));
  sherd.id = id.is_string() ? id.get<std::string>() : id.dump();
  const Result<Eigen::Isometry3d> front =
      isometryFromJson(entry["plate_from_model_front"], file.string(), limits::kPoseReach_mm);
  if (!front) return front.error();
  sherd.plate_front_from_model = sherd.plate_back_from_model = *front;
  if (entry.contains("plate_from_model_back")) {
    const Result<Eigen::Isometry3d> back =
        isometryFromJson(entry["plate_from_model_back"], file.string(), limits::kPoseReach_mm);
    if (!back) return back.error();
    sherd.plate_back_from_model = *back;
  }
  const Result<ContainedPath> mesh = ContainedPath::parse(entry["mesh"].get<std::string>());
  if (!mesh) return Error::unusable(mesh.error().what, file);
  Result<PlyContents> contents = readPlyWithin(folder, mesh->text());
  if (!contents) return contents.error();
  if (contents->mesh.triangles.empty())
    return Error::unusable("The true mesh has no faces.", folder / mesh->text());
  sherd.mesh = std::move(contents->mesh);
  return sherd;
}

}  // namespace

Result<std::vector<TrueSherd>> readTrueSherds(const std::filesystem::path& truth_folder) {
  const std::filesystem::path file = truth_folder / "sherds.json";
  const Result<Json> value = readJson(file);
  if (!value) return value.error();
  if (!value->is_object() || !value->contains("sherds") || !(*value)["sherds"].is_array())
    return Error::unusable("The truth has no list 'sherds'.", file);
  std::vector<TrueSherd> sherds;
  for (const Json& entry : (*value)["sherds"]) {
    Result<TrueSherd> sherd = readSherd(entry, truth_folder, file);
    if (!sherd) return sherd.error();
    sherds.push_back(std::move(*sherd));
  }
  return sherds;
}

}  // namespace ostraka::evaluate
