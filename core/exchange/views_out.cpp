#include "exchange/views_out.h"

#include <algorithm>
#include <vector>

#include "exchange/csv.h"
#include "pipeline/saved_views.h"
#include "stereo/outside_door.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMask = ".mask.png";

std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code code;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, code))
    if (entry.is_regular_file(code)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

Result<void> addSide(BagWriter& bag, const fs::path& folder, const std::string& to,
                     const std::stop_token& stop) {
  for (const fs::path& file : filesIn(folder)) {
    const std::string name = file.lexically_relative(folder).generic_string();
    if (name == "lock") continue;  // of the working folder
    if (const auto added = bag.addFile(to + name, file, stop); !added) return added.error();
    if (!name.ends_with(kMask)) continue;
    // COLMAP looks for the image's whole name with .png behind it.
    const std::string image = name.substr(0, name.size() - kMask.size());
    if (const auto added = bag.addFile(to + image + ".png.png", file, stop); !added)
      return added.error();
  }
  return {};
}

Result<void> addBothSides(BagWriter& bag, const fs::path& project, const std::string& number,
                          const fs::path& scratch, const std::stop_token& stop) {
  const fs::path batch = project / "batches" / number;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    const auto views = pipeline::savedViews(project / "results" / number, batch, side, stop);
    if (!views) return views.error();
    stereo::DenseOptions options;
    std::error_code code;
    if (fs::exists(batch / "plate.json", code)) options.floor_z_mm = 0.0;
    const Result<FolderLock> held =
        stereo::writeOutsideFolder(*views, options, scratch, stereo::MaskStyle::OpenMvs, stop);
    if (!held) return held.error();
    const std::string to = "views/" + number + "/" + batch::name(side) + "/";
    if (Result<void> added = addSide(bag, scratch, to, stop); !added) return added;
    std::string names = csvLine({"image", "photograph"});
    for (std::size_t i = 0; i < views->size(); ++i)
      names += csvLine({stereo::viewName(i) + ".png",
                        fs::path((*views)[i].camera.file).lexically_relative(batch).string()});
    if (const auto added = bag.add(to + "photographs.csv", names); !added) return added.error();
  }
  return {};
}

}  // namespace

Result<void> addViews(BagWriter& bag, const fs::path& project, const std::string& number,
                      const fs::path& scratch, const std::stop_token& stop) {
  const Result<void> done = addBothSides(bag, project, number, scratch, stop);
  std::error_code ignored;
  fs::remove_all(scratch, ignored);
  return done;
}

}  // namespace ostraka::exchange
