#include <QtGlobal>

#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences sentencesOfPipeline() {
  static constexpr const char* kAll[] = {
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "No plate.json describes the sheet: %1 markers of %2 with sides of %3 mm were found in "
          "the photographs (%4 px) and are taken for it. Measure the distance of two markers that "
          "lie far apart and compare it with plate.json in the output folder."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "No plate.json describes the sheet: %1 markers of %2 were found in the photographs (%3 "
          "px), and their size is not known, so the result has no scale. Measure the side of a "
          "marker's black square and say it with --marker-mm."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The results of this batch are not there any more; compute it again, then decide."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Camera %1: its photographs come from different cameras (%2); give each camera its own "
          "name, for one lens is computed for all that have the same."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1: its focal length is not the same in all photographs (%2); one "
                        "lens is computed for all of them, so fix the zoom and photograph again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1: its aperture is not the same in all photographs (%2); set the "
                        "camera to manual: uneven photographs make masks and colours less sure."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Camera %1: its exposure time is not the same in all photographs (%2); set the camera to "
          "manual: uneven photographs make masks and colours less sure."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Camera %1: its sensitivity is not the same in all photographs (%2); set the camera to "
          "manual: uneven photographs make masks and colours less sure."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Camera %1: its white balance is not the same in all photographs (%2); set the camera to "
          "manual: uneven photographs make masks and colours less sure."),
      QT_TRANSLATE_NOOP("ostraka::Error", "No batch folder was given."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A candidate names a scan that is not there."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "This is no table of candidates; compute the batch again, only its pairs are done anew."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Decision %1 by %2 is about %3, whose side was photographed again since; decide again."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Decision %1 by %2 is about %3, which is not on the plate any more; decide again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Decision %1 by %2 does not hold: Decision %3 by %4, which is later, is "
                        "about the same scan; withdraw one of them."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "A decision is of a kind that this program does not know; a newer one wrote it."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A pair needs one front and one back."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Nothing was named to be set aside or shot again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Pieces to be joined must be of one side."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "A cut needs one piece and a line of at least a millimetre."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Nothing was named to be withdrawn."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "These decisions were written by a newer program; use that one."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Decision %1 cannot be used."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Mend it, or put a copy of the file back."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "These are no decisions of this program; move the file away, or put a copy of it back."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This decision does not hold any more."),
      QT_TRANSLATE_NOOP("ostraka::Error", "There is no photograph of this side."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The outlines of these two sides cannot be laid on each other."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 may be two sherds that touch, %2 and %3 of the other side: cut it in "
                        "the review, or lay them apart and photograph its side again."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "This is no list of strokes on masks; put back an earlier one or remove it."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "There are no masks of this batch yet; let it be computed first."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This file does not say how well the rig fitted."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This calibration is of other cameras than the batch was photographed "
                        "with; calibrate the rig by its own photographs."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Without plate.json the masks cannot be found; put masks beside the "
                        "photographs, or name a network (--masks MODEL.onnx)."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The result has no scale: without plate.json no length is known, and what "
                        "is given in mm is a guess of the size of a pixel; photograph on a marker "
                        "plate, lay the board of board.json beside the sherds on both sides, or "
                        "mark a known length on both in scale.json."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The output folder holds something that is not from this program; choose "
                        "another or an empty one."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The output folder holds another batch; choose another folder."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The output folder holds something else; name a new or empty folder."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "A pair names a scan that is not there; delete this file and start again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This is no table of pairs; delete it and start again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 and %2 were paired by hand, but nothing tells how they lie to each "
                        "other; turn the back by hand in the review: %3"),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1: The photograph is blurred: its edges are %2 pixels wide, those of the "
                        "camera's sharpest %3; it is left out, take it again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1: The photograph is blurred: its edges are %2 pixels wide, those of the "
                        "camera's sharpest %3; take it again."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "All photographs of the front side are blurred: even in the sharpest the markers' edges "
          "are %1 pixels wide, so its scans are coarse. Look at focus and shutter speed, and "
          "photograph this side again."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "All photographs of the back side are blurred: even in the sharpest the markers' edges "
          "are %1 pixels wide, so its scans are coarse. Look at focus and shutter speed, and "
          "photograph this side again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 of the plate's %2 markers are on no photograph of the front side (%3); "
                        "the cameras rest on the others, so take off what covers them."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 of the plate's %2 markers are on no photograph of the back side (%3); "
                        "the cameras rest on the others, so take off what covers them."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Decision %1 by %2 joins pieces that are not there any more; decide again."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Decision %1 by %2 cuts a piece that is not there, or beside it; decide again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The program %1 is not installed, and the stereo that was chosen needs it; "
                        "install it, or use the built-in stereo."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The photographs show no plate with markers, so the program %1 must find "
                        "the cameras, and it is not installed."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This will take about %1 GB of memory, and only %2 GB are free: the "
                        "computer may stop it or grow very slow."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Close other programs, or compute a draft."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1: it was not taken from where the camera stood while the plate turned; "
                        "it is left out."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 was pushed by about %2 mm on the front side: from stop %3 on (pos%4) "
                        "it lies elsewhere; photograph this side again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 was pushed by about %2 mm on the back side: from stop %3 on (pos%4) it "
                        "lies elsewhere; photograph this side again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 was pushed by about %2 mm on the front side: from %3 on it lies "
                        "elsewhere; photograph this side again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 was pushed by about %2 mm on the back side: from %3 on it lies "
                        "elsewhere; photograph this side again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The output folder lies in the batch folder, where nothing is ever "
                        "written; choose one beside it."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Photographs cannot be averaged down to less than 0.3 megapixels."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "There is no such segmentation network; masks are 'auto', 'given' or an ONNX file."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The fronts are not in mm: lengths of the result, mm by name, are in the "
                        "fronts' own unit."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The pairs of this batch are not computed yet, or were computed by an "
                        "older program; compute the batch again: what is whole is kept."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The scale is not right: %1, so that all measures would be %2 % too small; "
                        "measure the ruler on the plate and give plate.json its true size with "
                        "'ostraka plate --ruler-measured' or print the plate again at 100 %; if "
                        "the plate is true, measure the length and set its marks again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The scale is not right: %1, so that all measures would be %2 % too large; "
                        "measure the ruler on the plate and give plate.json its true size with "
                        "'ostraka plate --ruler-measured' or print the plate again at 100 %; if "
                        "the plate is true, measure the length and set its marks again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "the length of %1 mm marked on the front side measures %2 +- %3 mm in the "
                        "photographs (%4 %)"),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The length of %1 mm in scale.json could not be compared: mark each of its ends on two "
          "photographs or more of the front side, taken from different directions."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "the length of %1 mm marked on the back side measures %2 +- %3 mm in the "
                        "photographs (%4 %)"),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The length of %1 mm in scale.json could not be compared: mark each of its ends on two "
          "photographs or more of the back side, taken from different directions."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The folder cannot be read; name a folder of PLY files."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "There is no PLY file in this folder; each sherd's scan must be one PLY file."),
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
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The scan has fewer than 100 points; scan this side again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The scan has no normals; export it with nx, ny and nz."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The scan lies %1 times its length away from 0, 0, 0, so its coordinates "
                        "are rounded; move it there and export it again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "None of the scans can be used: %1"),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "These scans are %1 mm long in the median; they look like %2: %3."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "These scans are %1 mm long in the median; no sherds are of that size: %2."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The fronts are %1 mm long in the median, the backs %2 mm, so their units differ: %3."),
      QT_TRANSLATE_NOOP("ostraka::Error", "centimetres"),
      QT_TRANSLATE_NOOP("ostraka::Error", "metres"),
      QT_TRANSLATE_NOOP("ostraka::Error", "micrometres"),
      QT_TRANSLATE_NOOP("ostraka::Error", "export them in mm"),
      QT_TRANSLATE_NOOP("ostraka::Error", "export them in mm, or use --scale free"),
      QT_TRANSLATE_NOOP("ostraka::Error", "Sherd %1 has no model: %2"),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Sherd %1: its model has a hole right through it (%2 mm²). If the sherd "
                        "has none, the photographs do not show that place; photograph it again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Sherd %1: %2 % of its surface was seen by no camera and is filled in, "
                        "orange in its picture; photograph it again if that matters."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "It names %1, which is not in the batch; delete this file, and the cameras "
                        "are found again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This photograph has no mask; give one for each that is to be used."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This photograph is not used."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "%1 of the front side's photographs got no pose from COLMAP and are left out."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "%1 of the back side's photographs got no pose from COLMAP and are left out."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The rig was not used: without plate.json the poses come from COLMAP."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1: No sherd is marked on this photograph; it is left out."),
      QT_TRANSLATE_NOOP("ostraka::Error", "If sherds are on it, take it again or mend its mask."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Sherds are marked on %1 photographs of the front side; 3 are needed."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Sherds are marked on %1 photographs of the back side; 3 are needed."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Look at the masks, and at whether sherds were on the plate."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 was retaken after its mask was edited; the strokes on the earlier "
                        "photograph are left out. Check its mask."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The batch is not computed to its end; let the queue compute it, then its "
                        "pairs can be looked at."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The output folder is gone: it was moved or deleted while the program was writing into "
          "it. The photographs are untouched; start the same command again."),
  };
  return kAll;
}

}  // namespace ostraka::ui
