#include <QtGlobal>

#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences sentencesOfBase() {
  static constexpr const char* kAll[] = {
      QT_TRANSLATE_NOOP("ostraka::Error", "Stopped on request."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The disk is full; free some space and start the same command again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The image is cut off before its end; copy it from the camera again."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "This cannot be written (%1); choose another place, or check its permissions."),
      QT_TRANSLATE_NOOP("ostraka::Error", "There is no such file; check its name."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The file cannot be opened (%1); check its permissions."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The file is larger than the %1 bytes that are read here; is it the right one?"),
      QT_TRANSLATE_NOOP("ostraka::Error", "The file cannot be read (%1); copy it again."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Another run is writing here; wait until it has ended, or choose another folder."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The JSON text is larger than 64 MiB."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The JSON is nested deeper than 64 levels."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This is not valid JSON (line %1); mend it there, or copy the file again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The JSON holds a number that is too large; mend it."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A transform must be a 4x4 matrix."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A transform holds something not a number."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A transform is not rigid."),
      QT_TRANSLATE_NOOP("ostraka::Error", "There is no such folder; name the folder of a batch."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The front side is missing; put its photographs into the folder '%1'."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The back side is missing; put its photographs into the folder '%1'."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This is no batch: it has neither the folders 'front' and 'back' nor "
                        "'top_images' and 'bottom_images'; name the folder of a batch."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The name is not of the form %1; this photograph is left out."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Another photograph has the same camera and stop; this one is left out."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This photograph is left out."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Photographs are missing here: %1 and %2 more; what only they see will be "
                        "filled in, so take them again if they matter."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Photographs are missing here: %1; what only they see will be filled in, "
                        "so take them again if they matter."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The name is that of a rig's photograph, but most others are not; this "
                        "photograph is left out."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Another photograph has the same name; this one is left out."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Photographs of less than %1 megapixels are left out (%2 and %3 more); "
                        "copy the originals from the camera in place of thumbnails."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Photographs of less than %1 megapixels are left out (%2); copy the "
                        "originals from the camera in place of thumbnails."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "%1 of the %2 photographs are used: the most detailed ones, spread over "
                        "the series. More take longer and add little."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "There are no photographs in this folder; put the photographs of one side there."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "There are neither photographs in this folder nor the folders 'front' and "
                        "'back' of a batch; name a folder with photographs."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "There is no such folder; name one with the photographs of a side."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "This folder was named for the front and for the back; name the folder of each side."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The front side has %1 usable photographs, at least %2 are needed; take "
                        "more from all around."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The back side has %1 usable photographs, at least %2 are needed; take "
                        "more from all around."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The HEIC image is damaged; copy it again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The RAW image is damaged, or of a camera that is not known; copy it "
                        "again, or export it as TIFF."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This mask is not used."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The mask's size is not its photograph's; it is not used."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The image has %1 x %2 pixels, the others of its camera have %3 x %4; this "
                        "photograph is left out."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The front side has %1 usable photographs, at least %2 are needed; put "
                        "photographs named %3 there."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The back side has %1 usable photographs, at least %2 are needed; put "
                        "photographs named %3 there."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The name is neither cam<C>_cal<NN>.jpg nor empty_cam<C>.jpg; this picture is left out."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This picture is left out."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The image has %1 x %2 pixels, the photographs of its camera have %3 x %4; "
                        "this picture is left out."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The image claims a size of %1 x %2 pixels, which cannot be used."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The JPEG image is damaged; copy it again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The JPEG image has no picture in it."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The PNG image is damaged; copy it again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The TIFF image has no size in it."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The file is empty; copy it from the camera again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This is no JPEG, PNG, TIFF, HEIC or RAW image."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The known lengths cannot be used: %1."),
      QT_TRANSLATE_NOOP("ostraka::Error", "'side' must be 'front' or 'back'"),
      QT_TRANSLATE_NOOP("ostraka::Error", "'ends' must be two lists of marks"),
      QT_TRANSLATE_NOOP("ostraka::Error", "each end must be marked on two photographs at least"),
      QT_TRANSLATE_NOOP("ostraka::Error", "their unit must be mm"),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "each needs 'side', 'length' and 'ends' with 'file' and 'pixel'"),
      QT_TRANSLATE_NOOP("ostraka::Error", "The mask cannot be decoded; copy it again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The image cannot be decoded; copy it again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The plate's unit must be mm; print the plate's file again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The plate names more than 1024 markers."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The plate needs 'dictionary' and 'markers' with an id and four corners of "
                        "three numbers each; 'diameter', where it is given, is a number in mm."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The plate names no marker."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Marker %1 of the plate has no valid corners."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Marker %1 stands twice on the plate."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The board needs 'dictionary', 'squares_x', 'squares_y', 'square_mm' and 'marker_mm'."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The mesh has no faces to write."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A face of the mesh names a vertex that is not there."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This is not a PLY file; name one, or export the scan again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The PLY header names no format; export it again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The PLY header is wrong in line %1: %2; export it again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "its format is not known"),
      QT_TRANSLATE_NOOP("ostraka::Error", "a count is no number"),
      QT_TRANSLATE_NOOP("ostraka::Error", "a property cannot be read"),
      QT_TRANSLATE_NOOP("ostraka::Error", "a property has an unknown type"),
      QT_TRANSLATE_NOOP("ostraka::Error", "a list has no whole number as its length"),
      QT_TRANSLATE_NOOP("ostraka::Error", "a line cannot be understood"),
      QT_TRANSLATE_NOOP("ostraka::Error", "The PLY header has no end; export it again."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The PLY header claims %1 of '%2', more than the file holds; it may be cut off."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The PLY file has two lists of vertices; export it again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The PLY vertices lack x, y or z; export it again."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The PLY file ends early or holds something not a number; export it again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "A face of the PLY names a vertex that is not there; export it again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The PLY file ends within its faces; copy it again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The PLY file ends within '%1'; copy it again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The PLY file has no vertices; export the scan again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The PLY file holds more than its header claims; export it again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The PLY file holds no usable point; export the scan again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This is not a regular file; name a file."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This is a folder, not a file; name a file."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This is a pipe, not a file; name a file."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This is a socket, not a file; name a file."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This is a device, not a file; name a file."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "A link stands where the lock of this folder belongs; delete it."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "No temporary folder can be made here (%1); make room, or set TMPDIR to another folder."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The JSON names '%1' twice in one object; delete one of the two."),
      QT_TRANSLATE_NOOP("ostraka::Error", "'%1' must be a whole number from %2 to %3; mend it."),
      QT_TRANSLATE_NOOP("ostraka::Error", "'%1' must be a number from %2 to %3; mend it."),
      QT_TRANSLATE_NOOP("ostraka::Error", "'%1' must be a number; mend it."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Marker %1 of the plate is mirrored: its corners go round "
                        "counter-clockwise as seen from above; print the plate's file again."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Marker %1 of the plate is not convex; name its corners one after the "
                        "other along its edge."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The markers %1 and %2 of the plate overlap; print the plate's file again."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The board's markers must be smaller than its squares; mend 'marker_mm' or 'square_mm'."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "A face of the PLY has more than %1 corners; export it again as triangles."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The PLY file has more than %1 of '%2'; export it with fewer."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "A link or a file stands where a folder belongs, or a link where a file "
                        "does; put the files themselves there."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "There is a file of this name already; it is not overwritten."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The folder holds files already; name a new or empty one."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "This folder is a disk of its own, or the one you are in; name a new folder in it."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "This folder is needed for unfinished files, but holds others; move it away."),
  };
  return kAll;
}

}  // namespace ostraka::ui
