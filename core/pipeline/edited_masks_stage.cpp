// Masks as people painted on them, beside those of the program, which are never painted over.
#include <nlohmann/json.hpp>

#include "base/message.h"
#include "batch/moved_batch.h"
#include "batch/photograph.h"
#include "decisions/mask_strokes.h"
#include "files/files.h"
#include "files/json_message.h"
#include "images/png_image.h"
#include "pipeline/chain.h"

namespace ostraka::pipeline {
namespace {

namespace fs = std::filesystem;

/// What people painted on a side's photographs, one entry for each image.
struct SideStrokes {
  std::vector<std::vector<decisions::MaskStroke>> on;
  std::vector<Message> warnings;  ///< of photographs that were taken again since
};

SideStrokes sideStrokes(const std::vector<decisions::MaskStroke>& strokes,
                        const std::vector<rig::PosedImage>& images, const fs::path& output) {
  SideStrokes side;
  for (const rig::PosedImage& image : images) {
    const fs::path file = batch::photographNow(image.file, output);
    decisions::StrokesOn own =
        decisions::strokesOn(strokes, image.side, image.camera, image.stop, {});
    if (own.taken_again)  // only where it is asked for is a photograph read for it
      own = decisions::strokesOn(strokes, image.side, image.camera, image.stop,
                                 decisions::photographHash(file));
    if (own.taken_again)
      side.warnings.push_back(
          message("%1 was retaken after its mask was edited; the strokes on the earlier photograph "
                  "are left out. Check its mask.",
                  file.filename().string()));
    side.on.push_back(std::move(own.holding));
  }
  return side;
}

Result<void> editInto(const fs::path& to, const fs::path& from,
                      const std::vector<decisions::MaskStroke>& strokes) {
  if (strokes.empty()) {
    const Result<std::string> bytes = readFile(from);
    return bytes ? writeFileAtomically(to, *bytes) : Result<void>(bytes.error());
  }
  const Result<cv::Mat> read = batch::readMask(from);
  if (!read) return read.error();
  cv::Mat1b mask = read->clone();
  for (const decisions::MaskStroke& stroke : strokes) decisions::paintStroke(mask, stroke);
  return writeFileAtomically(to, images::encodedPng(mask));
}

}  // namespace

Result<Staged<Masks>> editedMasksStage(const Run& run, batch::Side side, const Staged<Poses>& poses,
                                       Staged<Masks> found) {
  Result<std::vector<decisions::MaskStroke>> strokes =
      decisions::readMaskStrokes(run.options.output);
  if (!strokes) return strokes.error();
  std::erase_if(*strokes, [&](const decisions::MaskStroke& s) { return s.side != side; });
  if (strokes->empty()) return found;
  const std::vector<rig::PosedImage> images = poses.value.of(side);
  const SideStrokes own = sideStrokes(*strokes, images, run.options.output);
  const fs::path as_found = run.work / (std::string("masks_") + batch::name(side));
  const auto work = [&](const fs::path& folder) -> Result<stages::StageNotes> {
    int edited = 0;
    for (std::size_t i = 0; i < images.size(); ++i) {
      if (run.stop.stop_requested()) return Error::cancelled();
      edited += own.on[i].empty() ? 0 : 1;
      const std::string name = maskName(images[i]);
      if (Result<void> done = editInto(folder / name, as_found / name, own.on[i]); !done)
        return done.error();
    }
    return stages::StageNotes{{{"strokes", strokes->size()},
                               {"strokes_sha256", sha256(toJson(*strokes).dump())},
                               {"edited_masks", edited}},
                              own.warnings};
  };
  const std::string name = std::string("edited_") + batch::name(side);
  const Result<stages::StageRecord> record = runStage(run, name,
                                                      {{"masks", found.record.outputs_hash},
                                                       {"strokes", toJson(*strokes)},
                                                       {"taken_again", toJson(own.warnings)},
                                                       {"notes", "2"}},
                                                      work);
  if (!record) return record.error();
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (own.on[i].empty()) continue;
    const Result<cv::Mat> mask = batch::readMask(run.work / name / maskName(images[i]));
    if (!mask) return mask.error();
    found.value[i] =
        batch::reducedTo(*mask, images[i].intrinsics.width, images[i].intrinsics.height);
  }
  // Warnings about the masks as found still say which photographs show nothing.
  stages::StageRecord both = *record;
  both.notes.warnings = found.record.notes.warnings;
  for (const Message& warning : record->notes.warnings) both.notes.warnings.push_back(warning);
  return Staged<Masks>{std::move(found.value), std::move(both)};
}

}  // namespace ostraka::pipeline
