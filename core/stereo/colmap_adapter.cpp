#include "stereo/colmap_adapter.h"

#include <string>

#include "base/message.h"
#include "base/parallel.h"
#include "colmap/colmap_program.h"
#include "files/files.h"
#include "stereo/outside_adapter.h"

namespace ostraka::stereo {
namespace {

namespace fs = std::filesystem;

// What image_undistorter leaves beside the images: lists of the images and where results go.
Result<void> writeStereoFolder(const fs::path& workspace, std::size_t views) {
  for (const char* name : {"depth_maps", "normal_maps", "consistency_graphs"})
    if (Result<void> made = makeFolder(workspace / "stereo" / name); !made) return made;
  std::string match, fuse;
  for (std::size_t i = 0; i < views; ++i) {
    const std::string name = viewName(i) + ".png\n";
    match += name + "__auto__, 20\n";  // its own default number of neighbours
    fuse += name;
  }
  if (const Result<void> r = writeFileAtomically(workspace / "stereo" / "patch-match.cfg", match);
      !r)
    return r;
  return writeFileAtomically(workspace / "stereo" / "fusion.cfg", fuse);
}

bool saysThatCudaIsMissing(const fs::path& log) {
  const Result<std::string> words = readFile(log);
  return words && words->find("requires CUDA") != std::string::npos;
}

}  // namespace

Result<PointCloud> reconstructWithColmap(std::span<const View> views, const DenseOptions& options,
                                         const fs::path& workspace, Progress& progress,
                                         std::stop_token stop) {
  const Result<fs::path> program = outsideProgram("colmap", "colmap");
  if (!program) return program.error();
  const fs::path folder = fs::absolute(workspace), log = folder / "log.txt";
  progress.report(0, 10);
  const Result<FolderLock> held =
      writeOutsideFolder(views, options, folder, MaskStyle::Colmap, stop);
  if (!held) return held.error();
  if (const Result<void> r = writeStereoFolder(folder, views.size()); !r) return r.error();
  progress.report(1, 10);
  progress.note(NoteLevel::Info, "stereo: COLMAP's patch_match_stereo");
  if (const Result<void> r = colmap::runProgram(
          *program,
          {"patch_match_stereo", "--workspace_path", folder.string(), "--workspace_format",
           "COLMAP", "--PatchMatchStereo.geom_consistency", "true"},
          log, stop);
      !r) {
    if (r.error().code == ErrorCode::Failed && saysThatCudaIsMissing(log))
      return Error{
          ErrorCode::Missing,
          message("This COLMAP was built without CUDA, which its dense stereo needs; install one "
                  "with CUDA, or use --dense builtin, which needs neither."),
          program->string()};
    return r.error();
  }
  progress.report(8, 10);
  progress.note(NoteLevel::Info, "stereo: COLMAP's stereo_fusion");
  const fs::path fused = folder / "fused.ply";
  const int threads = options.threads > 0 ? options.threads : availableThreads();
  if (const Result<void> r = colmap::runProgram(
          *program,
          {"stereo_fusion", "--workspace_path", folder.string(), "--workspace_format", "COLMAP",
           "--input_type", "geometric", "--output_path", fused.string(), "--StereoFusion.mask_path",
           (folder / "masks").string(),
           // Steep broken edges are seen by few of a turntable's views; the default is 5.
           "--StereoFusion.min_num_pixels", "3", "--StereoFusion.num_threads",
           std::to_string(threads)},
          log, stop);
      !r)
    return r.error();
  progress.report(10, 10);
  return readOutsideCloud(fused, "COLMAP", log, views, options);
}

}  // namespace ostraka::stereo
