#include <QtGlobal>

#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences sentencesOfRig() {
  static constexpr const char* kAll[] = {
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The side of a marker must be between 0.5 and 1000 mm; measure a black "
                        "square on the paper."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "No sheet with at least %1 markers of OpenCV's dictionaries is read in these %2 "
          "photographs; take photographs that show more of it, or name its plate.json."),
      QT_TRANSLATE_NOOP("ostraka::Error", "No camera explains the calibration pictures."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "No photograph of this camera shows the plate's markers."),
      QT_TRANSLATE_NOOP("ostraka::Error", "%1: The board is not seen; this picture is left out."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The dictionary %1 has too few markers for the board."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "A grid of markers needs 'dictionary', 'markers_x', 'markers_y', "
                        "'marker_length' and 'marker_separation'."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "There is nothing to calibrate from: photograph the plate at each stop "
                        "into 'front' (cam0_pos00.jpg and so on) and the board into 'calib', and "
                        "copy plate.json and board.json beside them."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "There are no pictures of the board; put them here, or into 'calib'."),
      QT_TRANSLATE_NOOP("ostraka::Error", "It is set aside."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1: its size is not that of the first; it is set aside."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The bundle adjustment of the rig did not converge; check that plate.json "
                        "and board.json describe what was photographed."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "It does not say how the sheets are bent; delete it, and they are measured "
                        "again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "It does not say what the sherds stand on; delete it, and that is found "
                        "again."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The sheet's markers can be read in %1 of %2 photographs of the %3 side; at "
          "least 3 are needed. Check that plate.json describes this sheet, that the "
          "photographs are not mirrored, and that most of the markers are in the "
          "picture."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "%1: %2 of the sheet's markers can be read in it, too few for a pose; it is "
          "left out."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "%1: most of the sheet's markers lie elsewhere in it than the other photographs say; it "
          "is left out."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Photographs that show too few of the sheet's markers for a pose are left out (%1 and %2 "
          "more); look whether they show this sheet."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Only one side was photographed: its %1 scans are open surfaces without a "
                        "back; they are in 'unpaired'."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "There is no plate.json, so the plate's markers cannot be used; copy the "
                        "one here that 'ostraka plate' wrote with the plate."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The known rig has no camera %1 with pictures of %2 x %3 pixels; the rig "
                        "is calibrated from this batch instead."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Its lens is estimated from the plate's markers instead."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The lens of camera %1 is not known: there are neither usable pictures of the board nor "
          "markers of the plate; add pictures of the board to 'calib'."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The lens of camera %1 was estimated from the plate's markers alone; add "
                        "12 pictures of the board to 'calib' for exact measures."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The plate's markers were found in %1 of %2 photographs, too few for a "
                        "pose of each side; check that plate.json belongs to this plate and that "
                        "the markers are lit and in the picture."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "No photograph of camera %1 shows two markers of the plate; all its "
                        "photographs are left out."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The known rig no longer fits: camera %1 misses the markers by %2 px; the cameras' "
          "places are estimated anew for this batch, calibrate the rig again."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "%1: none of its %2 markers lies where this camera sees them at this stop."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "It bears another photograph's name, or was taken while the plate turned; "
                        "it is left out."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "%1: no marker can be seen in it; does it show this stop? If not, take it again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Only %1 photographs of the front side have a pose, at least 3 are needed; "
                        "check that the plate's markers are lit and in the picture."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Only %1 photographs of the back side have a pose, at least 3 are needed; "
                        "check that the plate's markers are lit and in the picture."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1 sees fewer than six of the plate's markers at stop %2; check "
                        "light and focus there and that nothing lies on the markers."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Only %1 stops were photographed; take at least four around the whole "
                        "turn, so that the axis is found."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Fewer than eight markers were seen, so no distance could be kept out of "
                        "the fit: the scale is not checked."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Between the markers %1 and %2 you measured %3 mm, plate.json makes it %4 "
                        "mm (%5 %); measure the plate's ruler and make plate.json again with "
                        "'ostraka plate --ruler-measured'."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Not usable: Camera %1 misses the plate's markers by %2 px in the median; was it touched "
          "between the photographs, or is plate.json of another plate?"),
      QT_TRANSLATE_NOOP("ostraka::Error", "Not usable: the scale is not right."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Good: lenses, places and scale are determined."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Usable for a try only: the lens of camera %1 comes from the plate's markers alone."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Usable, but a focal length is known to no better than a thousandth."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Usable; what is named below would make it better."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Camera %1: focal length %2 px (%3 %)."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1: focal length %2 px (%3 %), %4 pictures of the board with %5 "
                        "px, worst %6 with %7 px, tilted up to %8 degrees."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Camera %1: focal length %2 px (%3 %), the plate's markers to %4 px in the median."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Camera %1: focal length %2 px (%3 %), %4 pictures of the board with %5 px, worst %6 "
          "with %7 px, tilted up to %8 degrees, the plate's markers to %9 px in the median."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1: take 12 pictures of the board, near and far, into all corners "
                        "of the picture, tilted by 20 to 45 degrees in different directions."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1: only 1 picture shows the board; take at least 8, better 12."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1: only %2 pictures show the board; take at least 8, better 12."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1: the board hardly reaches the %2 of the picture; add pictures "
                        "with the board there."),
      QT_TRANSLATE_NOOP("ostraka::Error", "upper left"),
      QT_TRANSLATE_NOOP("ostraka::Error", "upper middle"),
      QT_TRANSLATE_NOOP("ostraka::Error", "upper right"),
      QT_TRANSLATE_NOOP("ostraka::Error", "left middle"),
      QT_TRANSLATE_NOOP("ostraka::Error", "middle"),
      QT_TRANSLATE_NOOP("ostraka::Error", "right middle"),
      QT_TRANSLATE_NOOP("ostraka::Error", "lower left"),
      QT_TRANSLATE_NOOP("ostraka::Error", "lower middle"),
      QT_TRANSLATE_NOOP("ostraka::Error", "lower right"),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1: no picture shows the board tilted by more than 20 degrees; "
                        "take at least four, tilted to different sides."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1: only 1 picture shows the board tilted by more than 20 degrees; "
                        "take at least four, tilted to different sides."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1: only %2 pictures show the board tilted by more than 20 "
                        "degrees; take at least four, tilted to different sides."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Reprojection error %1 px over the plate's markers."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Scale: markers %1 and %2, kept out of the fit, lie %3 mm apart instead of "
                        "%4 (%5 mm, %6 %)."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Scale: markers %1 and %2, %3 mm by hand between the middles of their "
                        "outer edges, lie %4 mm apart in the photographs (%5 %)."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Set aside: %1"),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The lens is known, the cameras' places are not: no rig can be saved."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Not usable: the focal length is not determined."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Photograph the plate with its markers too: put one picture per camera and "
                        "stop into 'front' (cam0_pos00.jpg and so on) beside plate.json, the "
                        "board's pictures into 'calib'."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Marker %1 of the known length is not seen twice; name two markers of the "
                        "plate that the photographs show."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "A known length needs two different markers and millimetres above zero."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "There is no such folder; name one with photographs of the plate or of the board."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "More than five distortion terms for '%1' are not understood; undistort "
                        "its photographs first."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The camera of '%1' has no valid K, R, t or size."),
      QT_TRANSLATE_NOOP("ostraka::Error", "An image lacks file, width, height, K, R or t."),
      QT_TRANSLATE_NOOP("ostraka::Error", "An image lacks file, width, height, K, R or t (%1)."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The camera file holds no list 'images'."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "COLMAP's camera %1 has the model '%2' or values that cannot be used here; "
                        "use OPENCV instead."),
      QT_TRANSLATE_NOOP("ostraka::Error", "COLMAP's model has no camera for the image '%1'."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The file is damaged or not as COLMAP writes it; run COLMAP again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Line %1 is not as COLMAP writes it; run COLMAP again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This photograph is posed without its mask."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Without plate.json poses come from COLMAP, which is not installed; "
                        "install the package 'colmap' or photograph on a marker plate."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "COLMAP does not find how these photographs belong together; its words are "
                        "in this file. Look whether all show the same sherds with much overlap, or "
                        "photograph on a marker plate."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "COLMAP found poses for %1 of %2 photographs, too few; give masks or "
                        "photograph on a marker plate."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The scale is not right: markers %1 and %2, kept out of the fit, lie %3 mm apart instead "
          "of %4 (%5 mm, %6 %); check that plate.json belongs to this plate, that it is printed "
          "and glued true, and that a known rig was calibrated with it."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Against camera %1, camera %2 has moved by %3 mm and turned by %4 degrees "
                        "since the rig was calibrated."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1: The focal length is not determined: %2 px with a standard "
                        "deviation of %3 px; take more pictures, nearer and with the board tilted "
                        "by 20 to 45 degrees in different directions."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1: No picture shows the board tilted by more than 15 degrees; "
                        "tilt it more, so that focal length and distance can be told apart."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1: The corners scatter by %2 px, more than the 0.3 px of sharp "
                        "pictures of a flat board; check focus, light and the board's flatness."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Camera %1: The worst picture is %2 with %3 px; take it again or leave it out."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1: Only %2 calibration pictures show the board, at least 3 are "
                        "needed; take more pictures of it."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1: No camera explains the calibration pictures."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "camera %1: The focal length is not determined: %2 px with a standard "
                        "deviation of %3 px; take more pictures, nearer and with the board tilted "
                        "by 20 to 45 degrees in different directions."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "camera %1: No picture shows the board tilted by more than 15 degrees; "
                        "tilt it more, so that focal length and distance can be told apart."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "camera %1: The corners scatter by %2 px, more than the 0.3 px of sharp "
                        "pictures of a flat board; check focus, light and the board's flatness."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "camera %1: The worst picture is %2 with %3 px; take it again or leave it out."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "camera %1: Only %2 calibration pictures show the board, at least 3 are "
                        "needed; take more pictures of it."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "camera %1: No camera explains the calibration pictures."),
      QT_TRANSLATE_NOOP("ostraka::Error", "%1: the board is not seen in it; it is set aside."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The marker dictionary '%1' is not known; use one as DICT_4X4_100."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The markers' side must lie between 5 and 200 mm."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The plate's diameter must lie between 1 and 2000 mm."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Fewer than six markers of %1 mm fit on a plate of %2 mm; markers of %3 mm fit on it."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Fewer than six markers of %1 mm fit on a plate of %2 mm; make the plate larger."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Markers of %1 mm leave no room for a sherd on a plate of %2 mm; markers "
                        "of %3 mm fit on it."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Markers of %1 mm leave no room for a sherd on a plate of %2 mm; make the plate larger."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The printer's margin must lie between 0 and 40 mm."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The sheets' overlap must lie between 5 and 40 mm."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The dictionary %1 has too few markers for this plate."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "What the ruler measures must be a length in mm within the plate."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The ruler of this plate is %1 mm long as drawn, %2 mm differs by more than a tenth; "
          "print the file at 100 %, without 'fit to page', and measure again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Camera %1 has a covariance of another size; calibrate the rig again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This rig was written by another version; calibrate the rig again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Camera %1 stands twice in the rig."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This is no rig file (RIG.json); calibrate the rig again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The rig has no camera; calibrate it again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This file is there already and is no rig; name another one."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The log cannot be written."),
      QT_TRANSLATE_NOOP("ostraka::Error", "No process can be started."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The program was lost."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The program cannot be started; install it."),
      QT_TRANSLATE_NOOP("ostraka::Error", "%1 ended with an error; its words are in this file."),
  };
  return kAll;
}

}  // namespace ostraka::ui
