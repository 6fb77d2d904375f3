#include "stereo/openmvs_adapter.h"

#include <algorithm>
#include <string>

#include "base/message.h"
#include "base/parallel.h"
#include "colmap/colmap_program.h"
#include "stereo/outside_adapter.h"

namespace ostraka::stereo {

namespace fs = std::filesystem;

Result<PointCloud> reconstructWithOpenMvs(std::span<const View> views, const DenseOptions& options,
                                          const fs::path& workspace, Progress& progress,
                                          std::stop_token stop) {
  const Result<fs::path> interface = outsideProgram("InterfaceCOLMAP", "openmvs");
  if (!interface) return interface.error();
  const Result<fs::path> densify = outsideProgram("DensifyPointCloud", "openmvs");
  if (!densify) return densify.error();
  const fs::path folder = fs::absolute(workspace), log = folder / "log.txt";
  progress.report(0, 10);
  const Result<FolderLock> held =
      writeOutsideFolder(views, options, folder, MaskStyle::OpenMvs, stop);
  if (!held) return held.error();
  progress.report(1, 10);
  progress.note(NoteLevel::Info, "stereo: OpenMVS's InterfaceCOLMAP");
  const std::string scene = (folder / "scene.mvs").string();
  if (const Result<void> r = colmap::runProgram(
          *interface,
          // The photographs are looked for in images/ beside the model.
          {"-w", folder.string(), "-i", folder.string() + "/", "-o", scene}, log, stop);
      !r)
    return r.error();
  std::error_code failed;
  if (!fs::is_regular_file(scene, failed))
    return Error{ErrorCode::Failed,
                 message("InterfaceCOLMAP wrote no scene; its output is in this file."),
                 log.string()};
  progress.report(2, 10);
  progress.note(NoteLevel::Info, "stereo: OpenMVS's DensifyPointCloud");
  int longest_px = 0;
  for (const View& view : views)
    longest_px = std::max({longest_px, view.photograph.cols, view.photograph.rows});
  const int threads = options.threads > 0 ? options.threads : availableThreads();
  if (const Result<void> r = colmap::runProgram(
          *densify,
          {"-w", folder.string(), "-i", scene, "-o", (folder / "dense.mvs").string(),
           // Full size, as the built-in stereo; it halves photographs and caps them at 2560
           // unasked.
           "--resolution-level", "0", "--max-resolution", std::to_string(longest_px), "--mask-path",
           (folder / "masks").string() + "/", "--ignore-mask-label", "0", "--estimate-colors", "2",
           "--estimate-normals", "2", "--max-threads", std::to_string(threads)},
          log, stop);
      !r)
    return r.error();
  progress.report(10, 10);
  // Versions differ in whether they put _dense behind the name they were given.
  const fs::path plain = folder / "dense.ply", suffixed = folder / "dense_dense.ply";
  return readOutsideCloud(fs::is_regular_file(plain, failed) ? plain : suffixed, "OpenMVS", log,
                          views, options);
}

}  // namespace ostraka::stereo
