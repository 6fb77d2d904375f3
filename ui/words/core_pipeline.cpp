#include <QtGlobal>

#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences sentencesOfPipeline() {
  static constexpr const char* kAll[] = {
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "No plate.json describes the sheet: %1 markers of %2 with sides of %3 mm were found in "
          "the photographs (%4 px) and are used instead. Measure the distance between two markers "
          "that lie far apart and compare it with plate.json in the output folder."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "No plate.json describes the sheet: %1 markers of %2 were found in the photographs (%3 "
          "px), but their size is unknown, so the result has no scale. Measure the side of a "
          "marker's black square and give it with --marker-mm."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The results of this batch no longer exist; reprocess it, then decide."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Camera %1: its photographs come from different cameras (%2); give each camera its own "
          "name, because photographs with the same camera name share one lens calibration."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1: its focal length varies between photographs (%2); all share "
                        "one lens calibration, so fix the zoom and reshoot."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Camera %1: its aperture varies between photographs (%2); set the camera to manual, "
          "because uneven photographs make masks and colours less reliable."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Camera %1: its exposure time varies between photographs (%2); set the camera to manual, "
          "because uneven photographs make masks and colours less reliable."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Camera %1: its sensitivity varies between photographs (%2); set the camera to manual, "
          "because uneven photographs make masks and colours less reliable."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Camera %1: its white balance varies between photographs (%2); set the camera to manual, "
          "because uneven photographs make masks and colours less reliable."),
      QT_TRANSLATE_NOOP("ostraka::Error", "No batch folder was given."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A candidate refers to a scan that does not exist."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Not a candidate table; reprocess the batch, which redoes only its pairs."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The decision of %1 by %2 concerns %3, whose side has been reshot since; decide again."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The decision of %1 by %2 concerns %3, which is no longer on the plate; decide again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The decision of %1 by %2 has no effect: the decision of %3 by %4, "
                        "which is later, concerns the same scan; withdraw one of them."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "A decision is of an unknown kind; a newer version of Ostraka wrote it."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A pair needs one front and one back."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Nothing is selected to set aside or reshoot."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Fragments to merge must be of one side."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "A split needs one fragment and a line of at least 1 mm."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Nothing is selected to withdraw."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "A newer version of Ostraka wrote these decisions; use that version."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Decision %1 cannot be used."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Its id is missing or used twice."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Correct it, or restore a copy of the file."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Not a decisions file of Ostraka; move it elsewhere, or restore a copy of it."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This decision is no longer in effect."),
      QT_TRANSLATE_NOOP("ostraka::Error", "There is no photograph of this side."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The outlines of these two sides cannot be overlaid."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 may be two sherds that touch, %2 and %3 of the other side: split it in "
                        "the review, or move them apart and reshoot its side."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Not a list of mask strokes; restore an earlier one, or delete it."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This batch has no masks yet; process it first."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This file does not state how well the rig fits."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This calibration is for other cameras than those of the batch; calibrate "
                        "the rig from its own photographs."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Masks cannot be made without plate.json; put masks next to the "
                        "photographs, or choose a network (--masks MODEL.onnx)."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The result has no scale: without plate.json no length is known, and lengths in mm rest "
          "on a guessed pixel size; photograph on a marker plate, lay the board of board.json "
          "beside the sherds on both sides, or mark a known length on both in scale.json."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The output folder contains files that Ostraka did not write; choose "
                        "another or an empty one."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The output folder contains another batch; choose another folder."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The output folder contains other files; choose a new or empty folder."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "A pair refers to a scan that does not exist; delete this file and reprocess the batch."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Not a pair table; delete it and reprocess the batch."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 and %2 were paired by hand, but their relative pose is unknown; align "
                        "the back by hand in the review: %3"),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1: The photograph is blurred: its edges are %2 pixels wide, those of the "
                        "camera's sharpest %3; it is left out, retake it."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1: The photograph is blurred: its edges are %2 pixels wide, those of the "
                        "camera's sharpest %3; retake it."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "All photographs of the front side are blurred: even in the sharpest, the "
                        "markers' edges are %1 pixels wide, so its scans are coarse. Check focus "
                        "and shutter speed, and reshoot this side."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "All photographs of the back side are blurred: even in the sharpest, the "
                        "markers' edges are %1 pixels wide, so its scans are coarse. Check focus "
                        "and shutter speed, and reshoot this side."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 of the plate's %2 markers are visible in no photograph of the front "
                        "side (%3); camera poses rely on the others, so uncover these."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 of the plate's %2 markers are visible in no photograph of the back "
                        "side (%3); camera poses rely on the others, so uncover these."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The decision of %1 by %2 merges fragments that no longer exist; decide again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The decision of %1 by %2 splits a fragment that does not exist, or misses "
                        "it; decide again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The program %1 is not installed, but the selected stereo needs it; "
                        "install it, or use the built-in stereo."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The photographs show no marker plate, so finding the cameras needs the "
                        "program %1, which is not installed; install it."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This needs about %1 GB of memory, but only %2 GB are free: the computer "
                        "may stop the program or become very slow."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Close other programs, or process a draft."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1: the camera was not where it stood while the plate turned; the "
                        "photograph is left out."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 moved by about %2 mm on the front side: from position %3 on (pos%4), "
                        "it lies elsewhere; reshoot this side."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 moved by about %2 mm on the back side: from position %3 on (pos%4), it "
                        "lies elsewhere; reshoot this side."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 moved by about %2 mm on the front side: from %3 on, it lies elsewhere; "
                        "reshoot this side."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 moved by about %2 mm on the back side: from %3 on, it lies elsewhere; "
                        "reshoot this side."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The output folder lies inside the batch folder, to which Ostraka never "
                        "writes; choose one next to it."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Photographs cannot be reduced to less than 0.3 megapixels."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "There is no such segmentation network; masks are 'auto', 'given' or an ONNX file."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The fronts are not in mm: lengths in the result, although labelled mm, "
                        "are in the fronts' own unit."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The pairs of this batch are not processed yet; process the batch: "
                        "complete results are kept."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The scale is wrong: %1, so all measurements would be %2 % too small; "
                        "measure the ruler on the plate and set its true size in plate.json with "
                        "'ostraka plate --ruler-measured', or reprint the plate at 100 %; if the "
                        "plate is correct, measure the length and set its marks again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The scale is wrong: %1, so all measurements would be %2 % too large; "
                        "measure the ruler on the plate and set its true size in plate.json with "
                        "'ostraka plate --ruler-measured', or reprint the plate at 100 %; if the "
                        "plate is correct, measure the length and set its marks again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "the length of %1 mm marked on the front side measures %2 +- %3 mm in the "
                        "photographs (%4 %)"),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The length of %1 mm in scale.json could not be checked: mark each of its ends on at "
          "least two photographs of the front side, taken from different directions."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "the length of %1 mm marked on the back side measures %2 +- %3 mm in the "
                        "photographs (%4 %)"),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The length of %1 mm in scale.json could not be checked: mark each of its ends on at "
          "least two photographs of the back side, taken from different directions."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The folder cannot be read; choose a folder of PLY files."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "This folder contains no PLY files; each sherd's scan must be one PLY file."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1: 1 point without finite coordinates was left out; check the export."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "%1: %2 points without finite coordinates were left out; check the export."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "%1: 1 point far from all others, or at 0, 0, 0, was left out; check the export."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "%1: %2 points far from all others, or at 0, 0, 0, were left out; check the export."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The scan has fewer than 100 points; rescan this side."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The scan has no normals; export it with nx, ny and nz."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The scan lies %1 times its length away from the origin, so its "
                        "coordinates are rounded; move it to the origin and export it again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "None of the scans can be used: %1"),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The median length of these scans is %1 mm; their unit seems to be %2: %3."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The median length of these scans is %1 mm; no sherds are of that size: %2."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The median length of the fronts is %1 mm, of the backs %2 mm, so their "
                        "units differ: %3."),
      QT_TRANSLATE_NOOP("ostraka::Error", "centimetres"),
      QT_TRANSLATE_NOOP("ostraka::Error", "metres"),
      QT_TRANSLATE_NOOP("ostraka::Error", "micrometres"),
      QT_TRANSLATE_NOOP("ostraka::Error", "export them in mm"),
      QT_TRANSLATE_NOOP("ostraka::Error", "export them in mm, or use --scale free"),
      QT_TRANSLATE_NOOP("ostraka::Error", "Sherd %1 has no model: %2"),
      QT_TRANSLATE_NOOP("ostraka::Error", "Sherd %1 has no photographic texture: %2"),
      QT_TRANSLATE_NOOP("ostraka::Error", "The texture of sherd %1 lacks a photograph: %2"),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Sherd %1: its model has a hole right through it (%2 mm²). If the sherd "
                        "has none, the photographs do not show that area; reshoot the sherd."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Sherd %1: %2 % of its surface is unseen by any camera and filled in, "
                        "orange in its picture; reshoot it if that matters."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The file lists %1, which is not in the batch; delete the file to find the "
                        "cameras again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This photograph has no mask; provide one for each photograph to be used."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This photograph is not used."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "%1 of the front side's photographs have no pose from COLMAP and are left out."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "%1 of the back side's photographs have no pose from COLMAP and are left out."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The rig was not used: without plate.json the poses come from COLMAP."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1: The mask marks no sherd in this photograph; it is left out."),
      QT_TRANSLATE_NOOP("ostraka::Error", "If it shows sherds, retake it or edit its mask."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Masks mark sherds in %1 photographs of the front side; 3 are needed."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Masks mark sherds in %1 photographs of the back side; 3 are needed."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Check the masks, and whether sherds were on the plate."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 was retaken after its mask was edited; the strokes on the earlier "
                        "photograph are left out. Check its mask."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The batch is not fully processed; let the queue process it, then review its pairs."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The output folder is gone: it was moved or deleted while Ostraka was writing to it. The "
          "photographs are untouched; run the same command again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The file has changed since the batch's processing began; nothing made "
                        "from it is kept. Process the batch again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The markers have sides of %1 mm in this file, but --marker-mm says %2 mm. "
                        "Measure one; then correct the file, or leave the option out."),
  };
  return kAll;
}

}  // namespace ostraka::ui
