#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences CoreSentences::ofBase() {
  static constexpr const char* kAll[] = {
      QT_TR_NOOP("Cancelled."),
      QT_TR_NOOP("The disk is full; free some space and try again."),
      QT_TR_NOOP("The image file is truncated; copy it from the camera again."),
      QT_TR_NOOP("The file or folder cannot be written (%1); choose another location, or check its "
                 "permissions."),
      QT_TR_NOOP("There is no such file; check its name."),
      QT_TR_NOOP("The file cannot be opened (%1); check its permissions."),
      QT_TR_NOOP("The file is larger than the limit of %1 bytes; check that it is the right one."),
      QT_TR_NOOP("The file cannot be read (%1); copy it again."),
      QT_TR_NOOP(
          "Another run is writing to this folder; wait until it ends, or choose another folder."),
      QT_TR_NOOP("The JSON text is larger than 64 MiB."),
      QT_TR_NOOP("The JSON is nested deeper than 64 levels."),
      QT_TR_NOOP("Not valid JSON (line %1); correct that line, or copy the file again."),
      QT_TR_NOOP("The JSON contains a number that is too large; correct it."),
      QT_TR_NOOP("A transform must be a 4x4 matrix."),
      QT_TR_NOOP("A transform contains a value that is not a number."),
      QT_TR_NOOP("A transform is not rigid."),
      QT_TR_NOOP("There is no such folder; choose a batch folder."),
      QT_TR_NOOP("The front side is missing; put its photographs into the folder '%1'."),
      QT_TR_NOOP("The back side is missing; put its photographs into the folder '%1'."),
      QT_TR_NOOP("Not a batch folder: it has neither the folders 'front' and 'back' nor "
                 "'top_images' and 'bottom_images'; choose a batch folder."),
      QT_TR_NOOP("The file name does not match the form %1; this photograph is left out."),
      QT_TR_NOOP("Another photograph has the same camera and position; this one is left out."),
      QT_TR_NOOP("This photograph is left out."),
      QT_TR_NOOP("Photographs are missing: %1 and %2 more. Surfaces that only they show are filled "
                 "in; retake them if that matters."),
      QT_TR_NOOP("Photographs are missing: %1. Surfaces that only they show are filled in; retake "
                 "them if that matters."),
      QT_TR_NOOP("This file name follows the naming of rig photographs, but most others do not; "
                 "this photograph is left out."),
      QT_TR_NOOP("Another photograph has the same name; this one is left out."),
      QT_TR_NOOP("Photographs of less than %1 megapixels are left out (%2 and %3 more); copy the "
                 "originals from the camera instead of thumbnails."),
      QT_TR_NOOP("Photographs of less than %1 megapixels are left out (%2); copy the originals "
                 "from the camera instead of thumbnails."),
      QT_TR_NOOP("%1 of the %2 photographs are used: the most detailed ones, spread over the "
                 "series. More would take longer and add little."),
      QT_TR_NOOP("This folder contains no photographs; put the photographs of one side into it."),
      QT_TR_NOOP("This folder contains neither photographs nor the folders 'front' and 'back' of a "
                 "batch; choose a folder with photographs."),
      QT_TR_NOOP("There is no such folder; choose one with the photographs of one side."),
      QT_TR_NOOP(
          "The same folder is given for the front and the back; choose the folder of each side."),
      QT_TR_NOOP("The front side has %1 usable photographs; at least %2 are needed. Take more from "
                 "all directions."),
      QT_TR_NOOP("The back side has %1 usable photographs; at least %2 are needed. Take more from "
                 "all directions."),
      QT_TR_NOOP("The HEIC image is damaged; copy it again."),
      QT_TR_NOOP("The RAW image is damaged, or its camera is not supported; copy it again, or "
                 "export it as TIFF."),
      QT_TR_NOOP("This mask is not used."),
      QT_TR_NOOP("The mask and its photograph differ in size; the mask is not used."),
      QT_TR_NOOP("The image has %1 x %2 pixels, but the others from its camera have %3 x %4; this "
                 "photograph is left out."),
      QT_TR_NOOP("The front side has %1 usable photographs; at least %2 are needed. Add "
                 "photographs named %3."),
      QT_TR_NOOP("The back side has %1 usable photographs; at least %2 are needed. Add photographs "
                 "named %3."),
      QT_TR_NOOP("The file name is neither cam<C>_cal<NN>.jpg nor empty_cam<C>.jpg; this picture "
                 "is left out."),
      QT_TR_NOOP("This picture is left out."),
      QT_TR_NOOP("The image has %1 x %2 pixels, but the photographs from its camera have %3 x %4; "
                 "this picture is left out."),
      QT_TR_NOOP("The image header states a size of %1 x %2 pixels, which cannot be used."),
      QT_TR_NOOP("The JPEG image is damaged; copy it again."),
      QT_TR_NOOP("The JPEG file contains no image."),
      QT_TR_NOOP("The PNG image is damaged; copy it again."),
      QT_TR_NOOP("The TIFF file does not state the image's size."),
      QT_TR_NOOP("The file is empty; copy it from the camera again."),
      QT_TR_NOOP("Not a JPEG, PNG, TIFF, HEIC or RAW image."),
      QT_TR_NOOP("The known lengths cannot be used: %1."),
      QT_TR_NOOP("'side' must be 'front' or 'back'"),
      QT_TR_NOOP("'ends' must be two lists of marks"),
      QT_TR_NOOP("each end must be marked on at least two photographs"),
      QT_TR_NOOP("their unit must be mm"),
      QT_TR_NOOP("each needs 'side', 'length' and 'ends' with 'file' and 'pixel'"),
      QT_TR_NOOP("The mask cannot be decoded; copy it again."),
      QT_TR_NOOP("The image cannot be decoded; copy it again."),
      QT_TR_NOOP("The plate's unit must be mm; create the plate file again."),
      QT_TR_NOOP("The plate file lists more than 1024 markers."),
      QT_TR_NOOP("The plate file needs 'dictionary' and 'markers', each with an id and four "
                 "corners of three numbers; 'diameter', if given, is a number in mm, 'sheet' the "
                 "paper's width and height."),
      QT_TR_NOOP("The plate file lists no markers."),
      QT_TR_NOOP("Marker %1 of the plate has no valid corners."),
      QT_TR_NOOP("Marker %1 occurs twice on the plate."),
      QT_TR_NOOP(
          "The board needs 'dictionary', 'squares_x', 'squares_y', 'square_mm' and 'marker_mm'."),
      QT_TR_NOOP("The mesh has no faces to write."),
      QT_TR_NOOP("Not every vertex has a place in the texture."),
      QT_TR_NOOP("The texture of this GLB model cannot be read, so the model is used without it; "
                 "reprocess its batch to write the file anew."),
      QT_TR_NOOP("The texture of this model has more than 67,108,864 pixels, so the model is used "
                 "without it; export the model with a smaller one."),
      QT_TR_NOOP("A face of the mesh refers to a vertex that does not exist."),
      QT_TR_NOOP("Not a PLY file; choose one, or export the scan again."),
      QT_TR_NOOP("The PLY header states no format; export the file again."),
      QT_TR_NOOP("The PLY header has an error in line %1: %2; export the file again."),
      QT_TR_NOOP("its format is unknown"),
      QT_TR_NOOP("a count is not a number"),
      QT_TR_NOOP("a property cannot be read"),
      QT_TR_NOOP("a property has an unknown type"),
      QT_TR_NOOP("the length of a list is not a whole number"),
      QT_TR_NOOP("a line cannot be parsed"),
      QT_TR_NOOP("The PLY header has no end; export the file again."),
      QT_TR_NOOP("The PLY header declares %1 of '%2', more than the file contains; the file may be "
                 "truncated."),
      QT_TR_NOOP("The PLY file has two lists of vertices; export it again."),
      QT_TR_NOOP("The PLY vertices lack x, y or z; export the file again."),
      QT_TR_NOOP(
          "The PLY file ends early or contains a value that is not a number; export it again."),
      QT_TR_NOOP(
          "A face of the PLY file refers to a vertex that does not exist; export the file again."),
      QT_TR_NOOP("The PLY file ends within its faces; copy it again."),
      QT_TR_NOOP("The PLY file ends within '%1'; copy it again."),
      QT_TR_NOOP("The PLY file has no vertices; export the scan again."),
      QT_TR_NOOP("The PLY file contains more data than its header declares; export it again."),
      QT_TR_NOOP("The PLY file contains no usable points; export the scan again."),
      QT_TR_NOOP("Not a regular file; choose a file."),
      QT_TR_NOOP("This is a folder, not a file; choose a file."),
      QT_TR_NOOP("This is a pipe, not a file; choose a file."),
      QT_TR_NOOP("This is a socket, not a file; choose a file."),
      QT_TR_NOOP("This is a device, not a file; choose a file."),
      QT_TR_NOOP("A link has taken the place of this folder's lock file; delete the link."),
      QT_TR_NOOP("A link has taken the place of a folder of a project or of a result; what it "
                 "leads to was "
                 "not touched. Delete the link, or move the folder itself here."),
      QT_TR_NOOP("No temporary folder can be created here (%1); free some space, or set TMPDIR to "
                 "another folder."),
      QT_TR_NOOP("The JSON contains '%1' twice in one object; delete one of the two."),
      QT_TR_NOOP("'%1' must be a whole number from %2 to %3; correct it."),
      QT_TR_NOOP("'%1' must be a number from %2 to %3; correct it."),
      QT_TR_NOOP("'%1' must be a number; correct it."),
      QT_TR_NOOP("Marker %1 of the plate is mirrored: its corners run counter-clockwise as seen "
                 "from above; create the plate file again."),
      QT_TR_NOOP("Marker %1 of the plate is not convex; list its corners in order along its edge."),
      QT_TR_NOOP("The markers %1 and %2 of the plate overlap; create the plate file again."),
      QT_TR_NOOP("The board's markers must be smaller than its squares; correct 'marker_mm' or "
                 "'square_mm'."),
      QT_TR_NOOP(
          "A face of the PLY file has more than %1 corners; export the file again as triangles."),
      QT_TR_NOOP("The PLY file has more than %1 of '%2'; export it with fewer."),
      QT_TR_NOOP("A link or a file has taken the place of a folder, or a link that of a file; "
                 "replace it with the folder or the file itself."),
      QT_TR_NOOP("A file of this name already exists; it is not overwritten."),
      QT_TR_NOOP("The folder already contains files; choose a new or empty one."),
      QT_TR_NOOP("This location belongs to the archive or export '%1', which new files would make "
                 "invalid; choose a location outside it."),
      QT_TR_NOOP("This location belongs to the project '%1'; choose a location outside it."),
      QT_TR_NOOP("The name of this output must end in %1; choose another name."),
      QT_TR_NOOP("This is a folder, not a file; choose another name."),
      QT_TR_NOOP("This output is one of the input files, which it would overwrite; choose another "
                 "name."),
      QT_TR_NOOP("This location belongs to the project '%1'; choose a folder directly in '%2', or "
                 "one outside the project."),
      QT_TR_NOOP(
          "This folder is a mount point or the current folder; choose a new folder inside it."),
      QT_TR_NOOP(
          "This folder is needed for unfinished files but contains others; move it elsewhere."),
      QT_TR_NOOP("This photograph is identical to %1; it is left out."),
  };
  return kAll;
}

}  // namespace ostraka::ui
