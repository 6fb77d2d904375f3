-- The file's header says what kind of SQLite file it is: the letters OSTR, as in the MIME type's magic.
PRAGMA application_id = 1330861138;
