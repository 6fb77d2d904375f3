#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences CoreSentences::ofRig() {
  static constexpr const char* kAll[] = {
      QT_TR_NOOP("The side of a marker must be between 0.5 and 1000 mm; measure a black square on "
                 "the paper."),
      QT_TR_NOOP(
          "No sheet with at least %1 markers of OpenCV's dictionaries was found in these %2 "
          "photographs; take photographs that show more of the sheet, or specify its plate.json."),
      QT_TR_NOOP("No camera model fits the calibration pictures."),
      QT_TR_NOOP("No photograph of this camera shows the plate's markers."),
      QT_TR_NOOP("%1: The board was not detected; this picture is left out."),
      QT_TR_NOOP("The dictionary %1 has too few markers for the board."),
      QT_TR_NOOP("A grid of markers needs 'dictionary', 'markers_x', 'markers_y', 'marker_length' "
                 "and 'marker_separation'."),
      QT_TR_NOOP("Nothing to calibrate from: photograph the plate at each position into 'front' "
                 "(cam0_pos00.jpg and so on) and the board into 'calib', and copy plate.json and "
                 "board.json next to them."),
      QT_TR_NOOP("No pictures of the board found; put them here or into 'calib'."),
      QT_TR_NOOP("It is set aside."),
      QT_TR_NOOP("%1: its size differs from that of the first picture; it is set aside."),
      QT_TR_NOOP("The bundle adjustment of the rig did not converge; check that plate.json and "
                 "board.json describe what was photographed."),
      QT_TR_NOOP(
          "The file does not describe how the sheets bend; delete it to measure them again."),
      QT_TR_NOOP("The file does not describe what the sherds stand on; delete it to determine this "
                 "again."),
      QT_TR_NOOP("The sheet's markers can be read in %1 of %2 photographs of the %3 side; at least "
                 "3 are needed. Check that plate.json describes this sheet, that the photographs "
                 "are not mirrored, and that most of the markers are in the picture."),
      QT_TR_NOOP("%1: %2 of the sheet's markers can be read, too few for a pose; the photograph is "
                 "left out."),
      QT_TR_NOOP("%1: most of the sheet's markers are not where the other photographs place them; "
                 "the photograph is left out."),
      QT_TR_NOOP("Photographs that show too few of the sheet's markers for a pose are left out (%1 "
                 "and %2 more); check that they show this sheet."),
      QT_TR_NOOP("Only one side was photographed: its %1 scans are open surfaces without a back; "
                 "they are in 'unpaired'."),
      QT_TR_NOOP("plate.json is missing, so the plate's markers cannot be used; copy the file that "
                 "'ostraka plate' wrote with the plate into this folder."),
      QT_TR_NOOP("The known rig has no camera %1 with pictures of %2 x %3 pixels; the rig is "
                 "calibrated from this batch instead."),
      QT_TR_NOOP("Its lens is estimated from the plate's markers instead."),
      QT_TR_NOOP("The lens of camera %1 is unknown: no usable pictures of the board and no plate "
                 "markers were found; add pictures of the board to 'calib'."),
      QT_TR_NOOP("The lens of camera %1 was estimated from the plate's markers alone; add 12 "
                 "pictures of the board to 'calib' for accurate measurements."),
      QT_TR_NOOP("The plate's markers were found in %1 of %2 photographs, too few for a pose of "
                 "each side; check that plate.json belongs to this plate and that the markers are "
                 "lit and in the picture."),
      QT_TR_NOOP("No photograph of camera %1 shows two markers of the plate; all its photographs "
                 "are left out."),
      QT_TR_NOOP("The known rig no longer fits: camera %1 misses the markers by %2 px. The camera "
                 "poses are re-estimated for this batch; recalibrate the rig."),
      QT_TR_NOOP("%1: none of its %2 markers is where this camera sees them at this position."),
      QT_TR_NOOP("It has another photograph's name or was taken while the plate was turning; it is "
                 "left out."),
      QT_TR_NOOP("%1: no marker is visible; check that the photograph shows this position. If not, "
                 "retake it."),
      QT_TR_NOOP("Only %1 photographs of the front side have a pose; at least 3 are needed. Check "
                 "that the plate's markers are lit and in the picture."),
      QT_TR_NOOP("Only %1 photographs of the back side have a pose; at least 3 are needed. Check "
                 "that the plate's markers are lit and in the picture."),
      QT_TR_NOOP("Camera %1 sees fewer than six of the plate's markers at position %2; check "
                 "lighting and focus there and that nothing covers the markers."),
      QT_TR_NOOP("Only %1 positions were photographed; photograph at least four around the full "
                 "turn to determine the axis."),
      QT_TR_NOOP("Fewer than eight markers were detected, so no distance could be held out of the "
                 "fit: the scale is not checked."),
      QT_TR_NOOP("Markers %1 and %2: you measured %3 mm, plate.json says %4 mm (%5 %); measure the "
                 "plate's ruler and regenerate plate.json with 'ostraka plate --ruler-measured'."),
      QT_TR_NOOP(
          "Not usable: Camera %1 misses the plate's markers by a median of %2 px; check that it "
          "did not move between the photographs and that plate.json belongs to this plate."),
      QT_TR_NOOP("Not usable: the scale is wrong."),
      QT_TR_NOOP("Good: lenses, camera poses and scale are determined."),
      QT_TR_NOOP(
          "Usable for a trial only: the lens of camera %1 comes from the plate's markers alone."),
      QT_TR_NOOP("Usable, but a focal length is uncertain by more than a thousandth."),
      QT_TR_NOOP("Usable; the steps below improve it."),
      QT_TR_NOOP("Camera %1: focal length %2 px (%3 %)."),
      QT_TR_NOOP("Camera %1: focal length %2 px (%3 %), %4 pictures of the board with %5 px, worst "
                 "%6 with %7 px, tilted up to %8 degrees."),
      QT_TR_NOOP(
          "Camera %1: focal length %2 px (%3 %), median error at the plate's markers %4 px."),
      QT_TR_NOOP(
          "Camera %1: focal length %2 px (%3 %), %4 pictures of the board with %5 px, worst %6 "
          "with %7 px, tilted up to %8 degrees, median error at the plate's markers %9 px."),
      QT_TR_NOOP("Camera %1: take 12 pictures of the board, near and far, in all corners of the "
                 "picture, tilted by 20 to 45 degrees in different directions."),
      QT_TR_NOOP("Camera %1: only 1 picture shows the board; take at least 8, preferably 12."),
      QT_TR_NOOP("Camera %1: only %2 pictures show the board; take at least 8, preferably 12."),
      QT_TR_NOOP("Camera %1: the board barely reaches the %2 of the picture; add pictures with the "
                 "board there."),
      QT_TR_NOOP("upper left"),
      QT_TR_NOOP("upper middle"),
      QT_TR_NOOP("upper right"),
      QT_TR_NOOP("left middle"),
      QT_TR_NOOP("middle"),
      QT_TR_NOOP("right middle"),
      QT_TR_NOOP("lower left"),
      QT_TR_NOOP("lower middle"),
      QT_TR_NOOP("lower right"),
      QT_TR_NOOP("Camera %1: no picture shows the board tilted by more than 20 degrees; take at "
                 "least four, tilted to different sides."),
      QT_TR_NOOP("Camera %1: only 1 picture shows the board tilted by more than 20 degrees; take "
                 "at least four, tilted to different sides."),
      QT_TR_NOOP("Camera %1: only %2 pictures show the board tilted by more than 20 degrees; take "
                 "at least four, tilted to different sides."),
      QT_TR_NOOP("Reprojection error %1 px over the plate's markers."),
      QT_TR_NOOP("Scale: markers %1 and %2, held out of the fit, are %3 mm apart instead of %4 (%5 "
                 "mm, %6 %)."),
      QT_TR_NOOP("Scale: markers %1 and %2, measured by hand as %3 mm between the midpoints of "
                 "their outer edges, are %4 mm apart in the photographs (%5 %)."),
      QT_TR_NOOP("Set aside: %1"),
      QT_TR_NOOP("The lens is known but the camera poses are not, so no rig can be saved."),
      QT_TR_NOOP("Not usable: the focal length is not determined."),
      QT_TR_NOOP("Photograph the plate with its markers too: put one picture per camera and "
                 "position into 'front' (cam0_pos00.jpg and so on) next to plate.json, and the "
                 "board's pictures into 'calib'."),
      QT_TR_NOOP("Marker %1 of the known length is visible in fewer than two photographs; choose "
                 "two markers of the plate that the photographs show."),
      QT_TR_NOOP("A known length needs two different markers and a value greater than 0 mm."),
      QT_TR_NOOP("Folder not found; choose one with photographs of the plate or of the board."),
      QT_TR_NOOP("More than five distortion terms for '%1' are not supported; undistort its "
                 "photographs first."),
      QT_TR_NOOP("The camera of '%1' has no valid K, R, t or size."),
      QT_TR_NOOP("An image lacks file, width, height, K, R or t."),
      QT_TR_NOOP("An image lacks file, width, height, K, R or t (%1)."),
      QT_TR_NOOP("The camera file has no list 'images'."),
      QT_TR_NOOP("COLMAP's camera %1 has the model '%2' or values that Ostraka does not support; "
                 "use OPENCV instead."),
      QT_TR_NOOP("COLMAP's model has no camera for the image '%1'."),
      QT_TR_NOOP("The file is damaged or not in COLMAP's format; run COLMAP again."),
      QT_TR_NOOP("The pose of this photograph is estimated without its mask."),
      QT_TR_NOOP("Without plate.json, poses come from COLMAP, which is not installed; install the "
                 "package 'colmap' or photograph on a marker plate."),
      QT_TR_NOOP("COLMAP cannot align these photographs; its output is in this file. Check that "
                 "all show the same sherds with large overlap, or photograph on a marker plate."),
      QT_TR_NOOP("COLMAP found poses for %1 of %2 photographs, too few; provide masks or "
                 "photograph on a marker plate."),
      QT_TR_NOOP(
          "The scale is wrong: markers %1 and %2, held out of the fit, are %3 mm apart instead of "
          "%4 (%5 mm, %6 %); check that plate.json belongs to this plate, that the plate is "
          "printed and glued without distortion, and that a known rig was calibrated with it."),
      QT_TR_NOOP("Relative to camera %1, camera %2 has moved by %3 mm and turned by %4 degrees "
                 "since the rig was calibrated."),
      QT_TR_NOOP("Camera %1: The focal length is not determined: %2 px with a standard deviation "
                 "of %3 px; take more pictures, closer and with the board tilted by 20 to 45 "
                 "degrees in different directions."),
      QT_TR_NOOP("Camera %1: No picture shows the board tilted by more than 15 degrees; tilt it "
                 "more to separate focal length from distance."),
      QT_TR_NOOP("Camera %1: The corners scatter by %2 px, more than the 0.3 px of sharp pictures "
                 "of a flat board; check focus, lighting and the board's flatness."),
      QT_TR_NOOP("Camera %1: The worst picture is %2 with %3 px; retake it or leave it out."),
      QT_TR_NOOP("Camera %1: Only %2 calibration pictures show the board; at least 3 are needed. "
                 "Take more pictures of it."),
      QT_TR_NOOP("Camera %1: No camera model fits the calibration pictures."),
      QT_TR_NOOP("camera %1: The focal length is not determined: %2 px with a standard deviation "
                 "of %3 px; take more pictures, closer and with the board tilted by 20 to 45 "
                 "degrees in different directions."),
      QT_TR_NOOP("camera %1: No picture shows the board tilted by more than 15 degrees; tilt it "
                 "more to separate focal length from distance."),
      QT_TR_NOOP("camera %1: The corners scatter by %2 px, more than the 0.3 px of sharp pictures "
                 "of a flat board; check focus, lighting and the board's flatness."),
      QT_TR_NOOP("camera %1: The worst picture is %2 with %3 px; retake it or leave it out."),
      QT_TR_NOOP("camera %1: Only %2 calibration pictures show the board; at least 3 are needed. "
                 "Take more pictures of it."),
      QT_TR_NOOP("camera %1: No camera model fits the calibration pictures."),
      QT_TR_NOOP("%1: the board was not detected; the picture is set aside."),
      QT_TR_NOOP("The marker dictionary '%1' is unknown; use one such as DICT_4X4_100."),
      QT_TR_NOOP("The markers' side must be between 5 and 200 mm."),
      QT_TR_NOOP("The plate's diameter must be between 1 and 2000 mm."),
      QT_TR_NOOP(
          "Fewer than six markers of %1 mm fit on a plate of %2 mm; markers of %3 mm fit on it."),
      QT_TR_NOOP("Fewer than six markers of %1 mm fit on a plate of %2 mm; make the plate larger."),
      QT_TR_NOOP("Markers of %1 mm leave no room for a sherd on a plate of %2 mm; markers of %3 mm "
                 "fit on it."),
      QT_TR_NOOP(
          "Markers of %1 mm leave no room for a sherd on a plate of %2 mm; make the plate larger."),
      QT_TR_NOOP("The printer's margin must be between 0 and 40 mm."),
      QT_TR_NOOP("The sheets' overlap must be between 5 and 40 mm."),
      QT_TR_NOOP("The dictionary %1 has too few markers for this plate."),
      QT_TR_NOOP("The measured ruler length must be in mm and within the plate."),
      QT_TR_NOOP("This file describes another plate, or this plate with another ruler length; "
                 "choose another folder."),
      QT_TR_NOOP("This file describes another calibration board; choose another folder."),
      QT_TR_NOOP("This folder contains photographs, and a new plate.json would describe the sheet "
                 "under their sherds; choose another folder."),
      QT_TR_NOOP("The ruler of this plate is drawn %1 mm long; %2 mm differs by more than a tenth. "
                 "Print the file at 100 %, without 'fit to page', and measure again."),
      QT_TR_NOOP("Camera %1 has a covariance of the wrong size; recalibrate the rig."),
      QT_TR_NOOP("Another version of Ostraka wrote this rig; recalibrate the rig."),
      QT_TR_NOOP("Camera %1 appears twice in the rig."),
      QT_TR_NOOP("Not a rig file (RIG.json); recalibrate the rig."),
      QT_TR_NOOP("The rig has no camera; recalibrate it."),
      QT_TR_NOOP("This file already exists and is not a rig; choose another name."),
      QT_TR_NOOP("The log cannot be written."),
      QT_TR_NOOP("A process cannot be started."),
      QT_TR_NOOP("The program's exit status is unknown."),
      QT_TR_NOOP("The program cannot be started; install it."),
      QT_TR_NOOP("%1 ended with an error; its output is in this file."),
  };
  return kAll;
}

}  // namespace ostraka::ui
