#include "ui/words/core_sentences.h"

namespace ostraka::ui {

Sentences CoreSentences::ofExchange() {
  static constexpr const char* kAll[] = {
      QT_TR_NOOP("New sites and trenches: %1; check for typos."),
      QT_TR_NOOP("The drawing needs a scale."),
      QT_TR_NOOP("The preview was undone."),
      QT_TR_NOOP("Restoring a project needs a new or empty folder; choose another name."),
      QT_TR_NOOP("Not an archive of a whole project; import it as an export instead."),
      QT_TR_NOOP("The manifest is missing; not an Ostraka export."),
      QT_TR_NOOP("The manifest has a line that cannot be read: %1"),
      QT_TR_NOOP("The manifest names a file outside the folder: %1"),
      QT_TR_NOOP("The manifest names a file twice: %1"),
      QT_TR_NOOP("A folder with this name already exists; choose another name."),
      QT_TR_NOOP("A name in an export must not contain '%'."),
      QT_TR_NOOP("Two files of the export would have the same name."),
      QT_TR_NOOP("Another import into this project is running; this one waits until it has ended."),
      QT_TR_NOOP("Files that were missing from the project and came back: %1."),
      QT_TR_NOOP("A folder with this name was created in the meantime; choose another name."),
      QT_TR_NOOP("Not an Ostraka export: this folder has no bagit.txt."),
      QT_TR_NOOP("This file is not in the manifest; nothing was read."),
      QT_TR_NOOP("This is a link, not a file; nothing was read."),
      QT_TR_NOOP("This folder cannot be read (%1); nothing was read."),
      QT_TR_NOOP("This file is missing; nothing was read."),
      QT_TR_NOOP("This file has changed since the export; nothing was read."),
      QT_TR_NOOP("There is no context %1; create it or let the import create it."),
      QT_TR_NOOP("There is no bag %1; create it or let the import create it."),
      QT_TR_NOOP("The column closed accepts yes or no."),
      QT_TR_NOOP("The column count_written accepts a whole number."),
      QT_TR_NOOP("The row has %1 values, but the header has %2."),
      QT_TR_NOOP("The column '%1' is unknown; its values are kept as a custom field."),
      QT_TR_NOOP("The column '%1' means the same as '%2'; its values are kept as a custom field."),
      QT_TR_NOOP("Not a text file: it contains binary data, which a table never does."),
      QT_TR_NOOP("Line %1 is not in UTF-8; save the table as 'CSV UTF-8' and try again."),
      QT_TR_NOOP("The table has more than 1,000,000 rows; split it."),
      QT_TR_NOOP("The table has more than 1,000 columns; split it."),
      QT_TR_NOOP("Line %1 has an unclosed quotation mark."),
      QT_TR_NOOP("Line %1 has characters after a closing quotation mark."),
      QT_TR_NOOP("Line %1 has a value longer than 1 MB."),
      QT_TR_NOOP("'%1' can be read as %2 or as %3; write one of the two."),
      QT_TR_NOOP("The table is empty; its first line must name the columns."),
      QT_TR_NOOP("This sherd has no model yet, so it cannot be drawn; process its batch first."),
      QT_TR_NOOP("The measurements of its batch are in doubt, and so is the size of this drawing."),
      QT_TR_NOOP("This sherd is void."),
      QT_TR_NOOP("This sherd is void; reason: %1"),
      QT_TR_NOOP("%1 is void and was left out."),
      QT_TR_NOOP("The sherd is recorded as a rim, but no part of its edge can be one; it is drawn "
                 "without a rim."),
      QT_TR_NOOP("%1 is missing and was left out."),
      QT_TR_NOOP("%1 differs from the recorded photograph; check it."),
      QT_TR_NOOP("This model or picture of the sherd %1 differs from the recorded one; reprocess "
                 "its batch %2."),
      QT_TR_NOOP("%1 is exported in full detail: %2"),
      QT_TR_NOOP("%1 is exported without photographs: %2"),
      QT_TR_NOOP("The photographs cannot be laid on a model that is not closed."),
      QT_TR_NOOP("Not drawn: %1"),
      QT_TR_NOOP("Drawn without its photographs: %1"),
      QT_TR_NOOP("Check the drawing of %1: %2"),
      QT_TR_NOOP("No pictures with masks and poses of %1: %2"),
      QT_TR_NOOP("No sherds to export; select some first."),
      QT_TR_NOOP("The row has neither a number nor a uuid."),
      QT_TR_NOOP("This appears in more than one row of the table, in the lines %1."),
      QT_TR_NOOP("This appears in more than one row of the table, in the lines %1 and %2 more."),
      QT_TR_NOOP("Check the unit: %1 is unusual for a sherd."),
      QT_TR_NOOP("Check the unit: %1 is far from the other values of this column."),
      QT_TR_NOOP("Not a uuid."),
      QT_TR_NOOP("The number and the uuid belong to different sherds."),
      QT_TR_NOOP("A new sherd needs its context."),
      QT_TR_NOOP("A column of the table has no name."),
      QT_TR_NOOP("The column '%1' appears twice."),
      QT_TR_NOOP("The table needs a column for the sherds' numbers, or columns for site and "
                 "context (contexts); select them."),
      QT_TR_NOOP("These places and batches are not in Ostraka's format."),
      QT_TR_NOOP("Not a PLY file."),
      QT_TR_NOOP("Not a GLB file."),
      QT_TR_NOOP("This export contains no sherd records (JSON); export it again with them."),
      QT_TR_NOOP("The project has this sherd with other values and keeps them; differing values "
                 "are added in fields that end in _in_%1."),
      QT_TR_NOOP("Joins with sherds that are not in the export or were not imported are left out: "
                 "%1; enter them by hand."),
      QT_TR_NOOP("Joins with rows that were not imported are left out: %1; correct these rows, "
                 "then import the table again."),
      QT_TR_NOOP("This file is not part of the export."),
      QT_TR_NOOP(
          "The project has another file with this name; rename the export and import it again."),
      QT_TR_NOOP("Not a sherd record (ostraka-sherd/1)."),
      QT_TR_NOOP("The measurement %1 has a unit other than %2."),
      QT_TR_NOOP("A value of the record has the wrong type."),
      QT_TR_NOOP("This is too large for one ZIP file; select fewer sherds."),
      QT_TR_NOOP("The export names a location in the project where no such file belongs; nothing "
                 "was imported."),
      QT_TR_NOOP("The archive contains a journal of its catalogue, which an Ostraka archive never "
                 "does; nothing was written."),
      QT_TR_NOOP("The catalogue's tables, indexes and triggers are not as Ostraka makes them; "
                 "nothing was written."),
      QT_TR_NOOP("%1 rows in total, %2 read; run the same import again for the others."),
  };
  return kAll;
}

}  // namespace ostraka::ui
