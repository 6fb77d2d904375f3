#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences CoreSentences::ofPipeline() {
  static constexpr const char* kAll[] = {
      QT_TR_NOOP(
          "No plate.json describes the sheet: %1 markers of %2 with sides of %3 mm were found in "
          "the photographs (%4 px) and are used instead. Measure the distance between two markers "
          "that lie far apart and compare it with plate.json in the output folder."),
      QT_TR_NOOP("No plate.json describes the sheet: %1 markers of %2 were found in the "
                 "photographs (%3 px), but their size is unknown, so the result has no scale. "
                 "Measure the side of a marker's black square and give it with --marker-mm."),
      QT_TR_NOOP("The results of this batch no longer exist; reprocess it, then decide."),
      QT_TR_NOOP(
          "Camera %1: its photographs come from different cameras (%2); give each camera its own "
          "name, because photographs with the same camera name share one lens calibration."),
      QT_TR_NOOP("Camera %1: its focal length varies between photographs (%2); all share one lens "
                 "calibration, so fix the zoom and reshoot."),
      QT_TR_NOOP("Camera %1: its aperture varies between photographs (%2); set the camera to "
                 "manual, because uneven photographs make masks and colours less reliable."),
      QT_TR_NOOP("Camera %1: its exposure time varies between photographs (%2); set the camera to "
                 "manual, because uneven photographs make masks and colours less reliable."),
      QT_TR_NOOP("Camera %1: its sensitivity varies between photographs (%2); set the camera to "
                 "manual, because uneven photographs make masks and colours less reliable."),
      QT_TR_NOOP("Camera %1: its white balance varies between photographs (%2); set the camera to "
                 "manual, because uneven photographs make masks and colours less reliable."),
      QT_TR_NOOP("No batch folder was given."),
      QT_TR_NOOP("A candidate refers to a scan that does not exist."),
      QT_TR_NOOP("Not a candidate table; reprocess the batch, which redoes only its pairs."),
      QT_TR_NOOP(
          "The decision of %1 by %2 concerns %3, whose side has been reshot since; decide again."),
      QT_TR_NOOP(
          "The decision of %1 by %2 concerns %3, which is no longer on the plate; decide again."),
      QT_TR_NOOP("The decision of %1 by %2 has no effect: the decision of %3 by %4, which is "
                 "later, concerns the same scan; withdraw one of them."),
      QT_TR_NOOP("A decision is of an unknown kind; a newer version of Ostraka wrote it."),
      QT_TR_NOOP("A pair needs one front and one back."),
      QT_TR_NOOP("Nothing is selected to set aside or reshoot."),
      QT_TR_NOOP("Fragments to merge must be of one side."),
      QT_TR_NOOP("A split needs one fragment and a line of at least 1 mm."),
      QT_TR_NOOP("Nothing is selected to withdraw."),
      QT_TR_NOOP("A newer version of Ostraka wrote these decisions; use that version."),
      QT_TR_NOOP("Decision %1 cannot be used."),
      QT_TR_NOOP("Its id is missing or used twice."),
      QT_TR_NOOP("It replaces more than %1 decisions."),
      QT_TR_NOOP("It replaces a decision twice, or one that does not come before it in the file."),
      QT_TR_NOOP(
          "A batch can have at most %1 decisions; move this file elsewhere, or restore a copy "
          "of it."),
      QT_TR_NOOP("Correct it, or restore a copy of the file."),
      QT_TR_NOOP("Not a decisions file of Ostraka; move it elsewhere, or restore a copy of it."),
      QT_TR_NOOP("This decision is no longer in effect."),
      QT_TR_NOOP("There is no photograph of this side."),
      QT_TR_NOOP("The outlines of these two sides cannot be overlaid."),
      QT_TR_NOOP("%1 may be two sherds that touch, %2 and %3 of the other side: split it in the "
                 "review, or move them apart and reshoot its side."),
      QT_TR_NOOP("Not a list of mask strokes; restore an earlier one, or delete it."),
      QT_TR_NOOP("A mask holds at most 1,000 strokes and 100,000 points; nothing is saved until "
                 "you undo some."),
      QT_TR_NOOP("This batch has no masks yet; process it first."),
      QT_TR_NOOP("This file does not state how well the rig fits."),
      QT_TR_NOOP("This calibration is for other cameras than those of the batch; calibrate the rig "
                 "from its own photographs."),
      QT_TR_NOOP("Masks cannot be made without plate.json; put masks next to the photographs, or "
                 "choose a network (--masks MODEL.onnx)."),
      QT_TR_NOOP(
          "The result has no scale: without plate.json no length is known, and lengths in mm rest "
          "on a guessed pixel size; photograph on a marker plate, lay the board of board.json "
          "beside the sherds on both sides, or mark a known length on both in scale.json."),
      QT_TR_NOOP("The output folder contains files that Ostraka did not write; choose another or "
                 "an empty one."),
      QT_TR_NOOP("The output folder contains another batch; choose another folder."),
      QT_TR_NOOP("The output folder contains other files; choose a new or empty folder."),
      QT_TR_NOOP(
          "A pair refers to a scan that does not exist; delete this file and reprocess the batch."),
      QT_TR_NOOP("Not a pair table; delete it and reprocess the batch."),
      QT_TR_NOOP("%1 and %2 were paired by hand, but their relative pose is unknown; align the "
                 "back by hand in the review: %3"),
      QT_TR_NOOP("%1: The photograph is blurred: its edges are %2 pixels wide, those of the "
                 "camera's sharpest %3; it is left out, retake it."),
      QT_TR_NOOP("%1: The photograph is blurred: its edges are %2 pixels wide, those of the "
                 "camera's sharpest %3; retake it."),
      QT_TR_NOOP("All photographs of the front side are blurred: even in the sharpest, the "
                 "markers' edges are %1 pixels wide, so its scans are coarse. Check focus and "
                 "shutter speed, and reshoot this side."),
      QT_TR_NOOP("All photographs of the back side are blurred: even in the sharpest, the markers' "
                 "edges are %1 pixels wide, so its scans are coarse. Check focus and shutter "
                 "speed, and reshoot this side."),
      QT_TR_NOOP("%1 of the plate's %2 markers are visible in no photograph of the front side "
                 "(%3); camera poses rely on the others, so uncover these."),
      QT_TR_NOOP("%1 of the plate's %2 markers are visible in no photograph of the back side (%3); "
                 "camera poses rely on the others, so uncover these."),
      QT_TR_NOOP("The decision of %1 by %2 merges fragments that no longer exist; decide again."),
      QT_TR_NOOP("The decision of %1 by %2 splits a fragment that does not exist, or misses it; "
                 "decide again."),
      QT_TR_NOOP("The program %1 is not installed, but the selected stereo needs it; install it, "
                 "or use the built-in stereo."),
      QT_TR_NOOP("The photographs show no marker plate, so finding the cameras needs the program "
                 "%1, which is not installed; install it."),
      QT_TR_NOOP("This needs about %1 GB of memory, but only %2 GB are free: the computer may stop "
                 "the program or become very slow."),
      QT_TR_NOOP("Close other programs, or process a draft."),
      QT_TR_NOOP("%1: the camera was not where it stood while the plate turned; the photograph is "
                 "left out."),
      QT_TR_NOOP("%1 moved by about %2 mm on the front side: from position %3 on (pos%4), it lies "
                 "elsewhere; reshoot this side."),
      QT_TR_NOOP("%1 moved by about %2 mm on the back side: from position %3 on (pos%4), it lies "
                 "elsewhere; reshoot this side."),
      QT_TR_NOOP("%1 moved by about %2 mm on the front side: from %3 on, it lies elsewhere; "
                 "reshoot this side."),
      QT_TR_NOOP("%1 moved by about %2 mm on the back side: from %3 on, it lies elsewhere; reshoot "
                 "this side."),
      QT_TR_NOOP("The output folder lies inside the batch folder, to which Ostraka never writes; "
                 "choose one next to it."),
      QT_TR_NOOP("Photographs cannot be reduced to less than 0.3 megapixels."),
      QT_TR_NOOP(
          "There is no such segmentation network; masks are 'auto', 'given' or an ONNX file."),
      QT_TR_NOOP("The fronts are not in mm: lengths in the result, although labelled mm, are in "
                 "the fronts' own unit."),
      QT_TR_NOOP(
          "The pairs of this batch are not processed yet; process the batch: complete results "
          "are kept."),
      QT_TR_NOOP("The scale is wrong: %1, so all measurements would be %2 % too small; measure the "
                 "ruler on the plate and set its true size in plate.json with 'ostraka plate "
                 "--ruler-measured', or reprint the plate at 100 %; if the plate is correct, "
                 "measure the length and set its marks again."),
      QT_TR_NOOP("The scale is wrong: %1, so all measurements would be %2 % too large; measure the "
                 "ruler on the plate and set its true size in plate.json with 'ostraka plate "
                 "--ruler-measured', or reprint the plate at 100 %; if the plate is correct, "
                 "measure the length and set its marks again."),
      QT_TR_NOOP("the length of %1 mm marked on the front side measures %2 +- %3 mm in the "
                 "photographs (%4 %)"),
      QT_TR_NOOP("The length of %1 mm in scale.json could not be checked: mark each of its ends on "
                 "at least two photographs of the front side, taken from different directions."),
      QT_TR_NOOP("the length of %1 mm marked on the back side measures %2 +- %3 mm in the "
                 "photographs (%4 %)"),
      QT_TR_NOOP("The length of %1 mm in scale.json could not be checked: mark each of its ends on "
                 "at least two photographs of the back side, taken from different directions."),
      QT_TR_NOOP("The folder cannot be read; choose a folder of PLY files."),
      QT_TR_NOOP("This folder contains no PLY files; each sherd's scan must be one PLY file."),
      QT_TR_NOOP("%1: 1 point without finite coordinates was left out; check the export."),
      QT_TR_NOOP("%1: %2 points without finite coordinates were left out; check the export."),
      QT_TR_NOOP("%1: 1 point far from all others, or at 0, 0, 0, was left out; check the export."),
      QT_TR_NOOP(
          "%1: %2 points far from all others, or at 0, 0, 0, were left out; check the export."),
      QT_TR_NOOP("The scan has fewer than 100 points; rescan this side."),
      QT_TR_NOOP("The scan has no normals; export it with nx, ny and nz."),
      QT_TR_NOOP("The scan lies %1 times its length away from the origin, so its coordinates are "
                 "rounded; move it to the origin and export it again."),
      QT_TR_NOOP("None of the scans can be used: %1"),
      QT_TR_NOOP("The median length of these scans is %1 mm; their unit seems to be %2: %3."),
      QT_TR_NOOP("The median length of these scans is %1 mm; no sherds are of that size: %2."),
      QT_TR_NOOP("The median length of the fronts is %1 mm, of the backs %2 mm, so their units "
                 "differ: %3."),
      QT_TR_NOOP("centimetres"),
      QT_TR_NOOP("metres"),
      QT_TR_NOOP("micrometres"),
      QT_TR_NOOP("export them in mm"),
      QT_TR_NOOP("export them in mm, or use --scale free"),
      QT_TR_NOOP("Sherd %1 has no model: %2"),
      QT_TR_NOOP("Sherd %1 has no photographic texture: %2"),
      QT_TR_NOOP("The texture of sherd %1 lacks a photograph: %2"),
      QT_TR_NOOP("Sherd %1: its model has a hole right through it (%2 mm²). If the sherd has none, "
                 "the photographs do not show that area; reshoot the sherd."),
      QT_TR_NOOP("Sherd %1: %2 % of its surface is unseen by any camera and filled in, orange in "
                 "its picture; reshoot it if that matters."),
      QT_TR_NOOP("The file lists %1, which is not in the batch; delete the file to find the "
                 "cameras again."),
      QT_TR_NOOP("This photograph has no mask; provide one for each photograph to be used."),
      QT_TR_NOOP("This photograph is not used."),
      QT_TR_NOOP("%1 of the front side's photographs have no pose from COLMAP and are left out."),
      QT_TR_NOOP("%1 of the back side's photographs have no pose from COLMAP and are left out."),
      QT_TR_NOOP("The rig was not used: without plate.json the poses come from COLMAP."),
      QT_TR_NOOP("%1: The mask marks no sherd in this photograph; it is left out."),
      QT_TR_NOOP("If it shows sherds, retake it or edit its mask."),
      QT_TR_NOOP("Masks mark sherds in %1 photographs of the front side; 3 are needed."),
      QT_TR_NOOP("Masks mark sherds in %1 photographs of the back side; 3 are needed."),
      QT_TR_NOOP("Check the masks, and whether sherds were on the plate."),
      QT_TR_NOOP("%1 was retaken after its mask was edited; the strokes on the earlier photograph "
                 "are left out. Check its mask."),
      QT_TR_NOOP(
          "The batch is not fully processed; let the queue process it, then review its pairs."),
      QT_TR_NOOP("The output folder is gone: it was moved or deleted while Ostraka was writing to "
                 "it. The photographs are untouched; run the same command again."),
      QT_TR_NOOP("The file has changed since the batch's processing began; nothing made from it is "
                 "kept. Process the batch again."),
      QT_TR_NOOP("The markers have sides of %1 mm in this file, but --marker-mm says %2 mm. "
                 "Measure one; then correct the file, or leave the option out."),
  };
  return kAll;
}

}  // namespace ostraka::ui
