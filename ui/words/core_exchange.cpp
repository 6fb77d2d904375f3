#include <QtGlobal>

#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences sentencesOfExchange() {
  static constexpr const char* kAll[] = {
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Sites and trenches that were not there: %1; look that none is a slip of the pen."),
      QT_TRANSLATE_NOOP("ostraka::Error", "There is no scale to draw it at."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A preview is taken back."),
      QT_TRANSLATE_NOOP("ostraka::Error", "An archive must not lie in the project itself."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "A project is restored into a new or an empty folder; choose another name."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This is no archive of a whole project; read it as an export instead."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The manifest is missing; this is no export of Ostraka."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The manifest has a line that cannot be read: %1"),
      QT_TRANSLATE_NOOP("ostraka::Error", "The manifest names a file outside the folder: %1"),
      QT_TRANSLATE_NOOP("ostraka::Error", "The manifest names a file twice: %1"),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This cannot be written; check the space left and the permissions."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "There is a folder of this name already; choose another name."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A name in an export must not hold '%'."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Two files of the export would have the same name."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Somebody made a folder of this name meanwhile; choose another name."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This folder is no export of Ostraka: bagit.txt is missing."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This file is not in the manifest; nothing was read."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This is a link, not a file; nothing was read."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This folder cannot be read (%1); nothing was read."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This file is missing; nothing was read."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This file was changed after the export; nothing was read."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "There is no context %1; make it, or let the import make it."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "There is no bag %1; make it, or let the import make it."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The column closed takes yes or no."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The column count_written takes a whole number."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The row has %1 values, the header %2."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The column '%1' is not known; its values are kept as a field of your own."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The column '%1' says the same as '%2'; its values are kept as a field of your own."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The file is no text: it holds binary data, which no table does."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Line %1 is not in UTF-8; save the table as 'CSV UTF-8' and try again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The table has more than 1,000,000 rows; split it."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Line %1 opens a quotation mark that is never closed."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Line %1 has letters behind a closing quotation mark."),
      QT_TRANSLATE_NOOP("ostraka::Error", "Line %1 has a value longer than 1 MB."),
      QT_TRANSLATE_NOOP("ostraka::Error", "'%1' can be read as %2 or as %3; write one of the two."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The table is empty; its first line must name the columns."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "This sherd has no model yet, so it cannot be drawn; compute its batch first."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The measures of its batch are in doubt: so is the size of this drawing."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This sherd is void."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This sherd is void, because: %1"),
      QT_TRANSLATE_NOOP("ostraka::Error", "%1 is void and was left out."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "It is said to be a rim, but no stretch of its edge can be one; drawn without."),
      QT_TRANSLATE_NOOP("ostraka::Error", "%1 is not there and was left out."),
      QT_TRANSLATE_NOOP("ostraka::Error", "%1 is not the photograph that was entered; check it."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "This model or picture of the sherd %1 is not the one that was entered; compute its "
          "batch %2 again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "%1 goes along whole: %2"),
      QT_TRANSLATE_NOOP("ostraka::Error", "Not drawn: %1"),
      QT_TRANSLATE_NOOP("ostraka::Error", "Check the drawing of %1: %2"),
      QT_TRANSLATE_NOOP("ostraka::Error", "No pictures with masks and poses of %1: %2"),
      QT_TRANSLATE_NOOP("ostraka::Error", "There is no sherd to export; choose some first."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The row has neither a number nor a uuid."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This stands in two rows of the table."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This is no uuid."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The number belongs to another sherd than the uuid."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A new sherd needs its context."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A column of the table has no name."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The column '%1' is there twice."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The table needs a column for the sherds' numbers, or columns for site and "
                        "context (contexts); say which they are."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "These places and batches are not written as Ostraka writes them."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This is no PLY file."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This is no GLB file."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "This export holds no records (JSON) of sherds; export it again with them."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The project has this sherd with other values; they stay, and what differs "
                        "is kept beside them in fields that end in _in_%1."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "Joins with sherds that the export does not hold, or that did not enter, are left out: "
          "%1; enter them by hand."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Joins with rows that did not enter are left out: %1; import the table "
                        "again when these rows are corrected."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This file is not among the files of the export."),
      QT_TRANSLATE_NOOP(
          "ostraka::Error",
          "The project has another file of this name; rename the export, and import it again."),
      QT_TRANSLATE_NOOP("ostraka::Error", "This is no record of a sherd (ostraka-sherd/1)."),
      QT_TRANSLATE_NOOP("ostraka::Error", "The measurement %1 has another unit than %2."),
      QT_TRANSLATE_NOOP("ostraka::Error", "A value of the record has another type than it should."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "This is too large for one ZIP file; choose fewer sherds."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The export names a place in the project where no such file belongs; "
                        "nothing was entered."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "The archive holds a journal of its catalogue, which no archive of Ostraka "
                        "does; nothing was written."),
      QT_TRANSLATE_NOOP("ostraka::Error",
                        "Of %1 rows %2 are entered; the same import enters the others."),
  };
  return kAll;
}

}  // namespace ostraka::ui
