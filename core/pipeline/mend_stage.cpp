// Masks as people painted on them, beside those of the program, which are never painted over.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "base/files.h"
#include "batch/photograph.h"
#include "pipeline/chain.h"
#include "pipeline/mask_strokes.h"

namespace ostraka::pipeline {
namespace {

namespace fs = std::filesystem;

// The strokes on this photograph, in their order.
std::vector<MaskStroke> strokesOn(const std::vector<MaskStroke>& strokes,
                                  const rig::PosedImage& image) {
  std::vector<MaskStroke> own;
  for (const MaskStroke& s : strokes)
    if (s.side == image.side && s.camera == image.camera && s.stop == image.stop) own.push_back(s);
  return own;
}

Result<void> mendInto(const fs::path& to, const fs::path& from,
                      const std::vector<MaskStroke>& strokes) {
  if (strokes.empty()) {
    const Result<std::string> bytes = readFile(from);
    return bytes ? writeFileAtomically(to, *bytes) : Result<void>(bytes.error());
  }
  const Result<cv::Mat> read = batch::readMask(from);
  if (!read) return read.error();
  cv::Mat1b mask = read->clone();
  for (const MaskStroke& stroke : strokes) paintStroke(mask, stroke);
  std::vector<unsigned char> bytes;
  cv::imencode(".png", mask, bytes, {cv::IMWRITE_PNG_COMPRESSION, 3});
  return writeFileAtomically(to, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace

Result<Staged<Masks>> mendStage(const Run& run, batch::Side side, const Staged<Poses>& poses,
                                Staged<Masks> found) {
  Result<std::vector<MaskStroke>> strokes = readMaskStrokes(run.options.output);
  if (!strokes) return strokes.error();
  std::erase_if(*strokes, [&](const MaskStroke& s) { return s.side != side; });
  if (strokes->empty()) return found;
  const std::vector<rig::PosedImage> images = poses.value.of(side);
  const fs::path as_found = run.work / (std::string("masks_") + batch::name(side));
  const auto work = [&](const fs::path& folder) -> Result<StageNotes> {
    int mended = 0;
    for (const rig::PosedImage& image : images) {
      if (run.stop.stop_requested()) return Error::cancelled();
      const std::vector<MaskStroke> own = strokesOn(*strokes, image);
      mended += own.empty() ? 0 : 1;
      const std::string name = maskName(image);
      if (Result<void> done = mendInto(folder / name, as_found / name, own); !done)
        return done.error();
    }
    return StageNotes{{{"strokes", strokes->size()},
                       {"strokes_sha256", sha256(toJson(*strokes).dump())},
                       {"mended_masks", mended}},
                      {}};
  };
  const std::string name = std::string("mended_") + batch::name(side);
  const Result<StageRecord> record = runStage(
      run.work, name,
      {{"masks", found.record.outputs_hash}, {"strokes", toJson(*strokes)}, {"notes", "2"}}, work,
      run.progress);
  if (!record) return record.error();
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (strokesOn(*strokes, images[i]).empty()) continue;
    const Result<cv::Mat> mask = batch::readMask(run.work / name / maskName(images[i]));
    if (!mask) return mask.error();
    found.value[i] =
        batch::reducedTo(*mask, images[i].intrinsics.width, images[i].intrinsics.height);
  }
  // Warnings about the masks as found still say which photographs show nothing.
  StageRecord both = *record;
  both.notes.warnings = found.record.notes.warnings;
  return Staged<Masks>{std::move(found.value), std::move(both)};
}

}  // namespace ostraka::pipeline
