-- The first catalogue: what a record holds stands in the header files of core/catalogue.
-- Every table that people see has: row, id (UUID), created/updated at (ms UTC) and by, revision,
-- extra (JSON: custom fields). created_by and updated_by NULL: the program.

-- The file's header says what kind of SQLite file it is: the letters OSTR, as in the MIME type's magic.
PRAGMA application_id = 1330861138;

CREATE TABLE person (
  row INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE,
  created_at INTEGER NOT NULL, created_by INTEGER REFERENCES person,
  updated_at INTEGER NOT NULL, updated_by INTEGER REFERENCES person,
  revision INTEGER NOT NULL DEFAULT 1, extra TEXT NOT NULL DEFAULT '{}' CHECK (json_valid(extra)),
  name TEXT NOT NULL CHECK (name <> ''),
  initials TEXT NOT NULL CHECK (initials <> ''), initials_key TEXT NOT NULL UNIQUE,
  orcid TEXT NOT NULL DEFAULT ''
) STRICT;

CREATE TABLE project (
  row INTEGER PRIMARY KEY CHECK (row = 1), id TEXT NOT NULL UNIQUE,
  created_at INTEGER NOT NULL, created_by INTEGER REFERENCES person,
  updated_at INTEGER NOT NULL, updated_by INTEGER REFERENCES person,
  revision INTEGER NOT NULL DEFAULT 1, extra TEXT NOT NULL DEFAULT '{}' CHECK (json_valid(extra)),
  code TEXT NOT NULL CHECK (code <> ''), title TEXT NOT NULL, institution TEXT NOT NULL,
  licence TEXT NOT NULL, rights_holder TEXT NOT NULL, numbering TEXT NOT NULL,
  word_for_context TEXT NOT NULL
) STRICT;

CREATE TABLE setting (key TEXT PRIMARY KEY, value TEXT NOT NULL) STRICT, WITHOUT ROWID;

CREATE TABLE vocabulary (
  name TEXT NOT NULL, term TEXT NOT NULL CHECK (term <> ''), position INTEGER NOT NULL,
  labels TEXT NOT NULL DEFAULT '{}' CHECK (json_valid(labels)), uri TEXT NOT NULL DEFAULT '',
  PRIMARY KEY (name, term)
) STRICT, WITHOUT ROWID;

CREATE TABLE site (
  row INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE,
  created_at INTEGER NOT NULL, created_by INTEGER REFERENCES person,
  updated_at INTEGER NOT NULL, updated_by INTEGER REFERENCES person,
  revision INTEGER NOT NULL DEFAULT 1, extra TEXT NOT NULL DEFAULT '{}' CHECK (json_valid(extra)),
  code TEXT NOT NULL CHECK (code <> ''), code_key TEXT NOT NULL UNIQUE, name TEXT NOT NULL,
  latitude_deg REAL CHECK (latitude_deg BETWEEN -90 AND 90),
  longitude_deg REAL CHECK (longitude_deg BETWEEN -180 AND 180),
  location_public INTEGER NOT NULL DEFAULT 0, gazetteer TEXT NOT NULL DEFAULT ''
) STRICT;

CREATE TABLE trench (
  row INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE,
  created_at INTEGER NOT NULL, created_by INTEGER REFERENCES person,
  updated_at INTEGER NOT NULL, updated_by INTEGER REFERENCES person,
  revision INTEGER NOT NULL DEFAULT 1, extra TEXT NOT NULL DEFAULT '{}' CHECK (json_valid(extra)),
  site INTEGER NOT NULL REFERENCES site,
  code TEXT NOT NULL CHECK (code <> ''), code_key TEXT NOT NULL, name TEXT NOT NULL,
  parent INTEGER REFERENCES trench,
  -- The trench that this one turned out to be: its contexts lie there, and nothing lists it any more.
  one_with INTEGER REFERENCES trench
) STRICT;
CREATE UNIQUE INDEX trench_place ON trench (site, code_key) WHERE one_with IS NULL;
CREATE INDEX trench_code ON trench (code_key);

CREATE TABLE context (
  row INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE,
  created_at INTEGER NOT NULL, created_by INTEGER REFERENCES person,
  updated_at INTEGER NOT NULL, updated_by INTEGER REFERENCES person,
  revision INTEGER NOT NULL DEFAULT 1, extra TEXT NOT NULL DEFAULT '{}' CHECK (json_valid(extra)),
  site INTEGER NOT NULL REFERENCES site, trench INTEGER REFERENCES trench,
  number TEXT NOT NULL CHECK (number <> ''), number_key TEXT NOT NULL,
  kind TEXT NOT NULL DEFAULT ''
    CHECK (kind IN ('', 'layer', 'cut', 'fill', 'structure', 'surface', 'unstratified')),
  excavated_on TEXT NOT NULL DEFAULT '', period TEXT NOT NULL DEFAULT '',
  date_edtf TEXT NOT NULL DEFAULT '', closed INTEGER CHECK (closed IN (0, 1)),
  note TEXT NOT NULL DEFAULT '', one_with INTEGER REFERENCES context  -- as a trench's
) STRICT;
CREATE UNIQUE INDEX context_place ON context (site, ifnull(trench, 0), number_key)
  WHERE one_with IS NULL;
CREATE INDEX context_number ON context (number_key);
CREATE INDEX context_trench ON context (trench);

CREATE TABLE bag (
  row INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE,
  created_at INTEGER NOT NULL, created_by INTEGER REFERENCES person,
  updated_at INTEGER NOT NULL, updated_by INTEGER REFERENCES person,
  revision INTEGER NOT NULL DEFAULT 1, extra TEXT NOT NULL DEFAULT '{}' CHECK (json_valid(extra)),
  context INTEGER NOT NULL REFERENCES context,
  number TEXT NOT NULL CHECK (number <> ''), number_key TEXT NOT NULL,
  collected_on TEXT NOT NULL DEFAULT '', count_written INTEGER CHECK (count_written >= 0),
  weight_g REAL CHECK (weight_g > 0), storage TEXT NOT NULL DEFAULT '',
  one_with INTEGER REFERENCES bag  -- as a trench's
) STRICT;
CREATE UNIQUE INDEX bag_place ON bag (context, number_key) WHERE one_with IS NULL;
CREATE INDEX bag_context ON bag (context);

CREATE TABLE batch (
  row INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE,
  created_at INTEGER NOT NULL, created_by INTEGER REFERENCES person,
  updated_at INTEGER NOT NULL, updated_by INTEGER REFERENCES person,
  revision INTEGER NOT NULL DEFAULT 1, extra TEXT NOT NULL DEFAULT '{}' CHECK (json_valid(extra)),
  number TEXT NOT NULL UNIQUE, operator INTEGER REFERENCES person,
  counted INTEGER NOT NULL DEFAULT 0 CHECK (counted BETWEEN 0 AND 60),
  state TEXT NOT NULL CHECK (state IN ('placed', 'front', 'flipped', 'back', 'queued', 'computed',
                                       'review', 'done', 'failed')),
  started_ms INTEGER, ended_ms INTEGER, reprojection_px REAL, scale_error_pct REAL,
  rig_sha256 TEXT NOT NULL DEFAULT '', program TEXT NOT NULL DEFAULT '',
  settings_sha256 TEXT NOT NULL DEFAULT '', note TEXT NOT NULL DEFAULT '',
  -- What makes the scale, one sentence; empty: not computed yet.
  scale TEXT NOT NULL DEFAULT '',
  -- Why the scale is in doubt, whole sentences, one a line; empty: nothing speaks against it. Until
  -- it is settled all measures that the program took of its sherds are in doubt.
  scale_doubts TEXT NOT NULL DEFAULT ''
) STRICT;

CREATE TABLE batch_bag (
  batch INTEGER NOT NULL REFERENCES batch, position INTEGER NOT NULL,
  bag INTEGER NOT NULL REFERENCES bag, PRIMARY KEY (batch, position), UNIQUE (batch, bag)
) STRICT, WITHOUT ROWID;
CREATE INDEX batch_bag_bag ON batch_bag (bag);

CREATE TABLE photograph (
  row INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE,
  created_at INTEGER NOT NULL, created_by INTEGER REFERENCES person,
  updated_at INTEGER NOT NULL, updated_by INTEGER REFERENCES person,
  revision INTEGER NOT NULL DEFAULT 1, extra TEXT NOT NULL DEFAULT '{}' CHECK (json_valid(extra)),
  batch INTEGER NOT NULL REFERENCES batch, side TEXT NOT NULL CHECK (side IN ('front', 'back')),
  camera TEXT NOT NULL, stop INTEGER NOT NULL, take INTEGER NOT NULL, path TEXT NOT NULL,
  serial TEXT NOT NULL DEFAULT '', exif TEXT NOT NULL DEFAULT '{}' CHECK (json_valid(exif)),
  angle_deg REAL, sharpness REAL, used INTEGER NOT NULL DEFAULT 1,
  reason TEXT NOT NULL DEFAULT '', UNIQUE (batch, side, camera, stop, take)
) STRICT;

CREATE TABLE scan (
  row INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE,
  created_at INTEGER NOT NULL, created_by INTEGER REFERENCES person,
  updated_at INTEGER NOT NULL, updated_by INTEGER REFERENCES person,
  revision INTEGER NOT NULL DEFAULT 1, extra TEXT NOT NULL DEFAULT '{}' CHECK (json_valid(extra)),
  batch INTEGER NOT NULL REFERENCES batch, side TEXT NOT NULL CHECK (side IN ('front', 'back')),
  position INTEGER NOT NULL, name TEXT NOT NULL, path TEXT NOT NULL, points INTEGER,
  coverage_pct REAL, plate_x_mm REAL, plate_y_mm REAL,
  state TEXT NOT NULL DEFAULT 'open' CHECK (state IN ('open', 'paired', 'aside')),
  UNIQUE (batch, side, position)
) STRICT;

-- Only added to. person NULL: the program.
CREATE TABLE pair_decision (
  row INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE, at INTEGER NOT NULL,
  decision TEXT NOT NULL DEFAULT '',  -- its id in the batch's decisions.json; '': the program's own
  came_alone INTEGER NOT NULL DEFAULT 0 CHECK (came_alone IN (0, 1)),  -- 1: without that file
  person INTEGER REFERENCES person, batch INTEGER NOT NULL REFERENCES batch,
  front INTEGER REFERENCES scan, back INTEGER REFERENCES scan,
  front_from_back TEXT NOT NULL DEFAULT '', score REAL, margin REAL,
  ambiguous INTEGER NOT NULL DEFAULT 0, fracture_rms_mm REAL, fracture_overlap REAL,
  verdict TEXT NOT NULL CHECK (verdict IN ('accept', 'reject', 'aside', 'reshoot', 'withdraw')),
  replaces INTEGER REFERENCES pair_decision, note TEXT NOT NULL DEFAULT '',
  CHECK (verdict NOT IN ('accept', 'reject') OR (front IS NOT NULL AND back IS NOT NULL)),
  CHECK (verdict <> 'withdraw' OR replaces IS NOT NULL)
) STRICT;
CREATE INDEX pair_decision_batch ON pair_decision (batch);

-- What people said about pieces that the masks separated or joined wrongly. Only added to.
CREATE TABLE piece_decision (
  row INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE, at INTEGER NOT NULL,
  decision TEXT NOT NULL DEFAULT '',  -- its id in the batch's decisions.json
  came_alone INTEGER NOT NULL DEFAULT 0 CHECK (came_alone IN (0, 1)),  -- 1: without that file
  person INTEGER REFERENCES person, batch INTEGER NOT NULL REFERENCES batch,
  side TEXT NOT NULL CHECK (side IN ('front', 'back')),
  verdict TEXT NOT NULL CHECK (verdict IN ('join', 'cut', 'withdraw')),
  -- [{"name": "f003", "place_mm": [x, y]}]: scans come and go with each computation, places stay
  pieces TEXT NOT NULL DEFAULT '[]' CHECK (json_type(pieces) = 'array'),
  cut_mm TEXT NOT NULL DEFAULT '[]' CHECK (json_type(cut_mm) = 'array'),  -- [[x, y], [x, y]]
  replaces INTEGER REFERENCES piece_decision, note TEXT NOT NULL DEFAULT '',
  CHECK (verdict <> 'withdraw' OR replaces IS NOT NULL)
) STRICT;
CREATE INDEX piece_decision_batch ON piece_decision (batch);

CREATE TABLE sherd (
  row INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE,
  created_at INTEGER NOT NULL, created_by INTEGER REFERENCES person,
  updated_at INTEGER NOT NULL, updated_by INTEGER REFERENCES person,
  revision INTEGER NOT NULL DEFAULT 1, extra TEXT NOT NULL DEFAULT '{}' CHECK (json_valid(extra)),
  number TEXT NOT NULL DEFAULT '',
  number_sort TEXT NOT NULL DEFAULT '',  -- runs of digits by their value; drafts last
  state TEXT NOT NULL DEFAULT 'draft' CHECK (state IN ('draft', 'numbered', 'void')),
  void_reason TEXT NOT NULL DEFAULT '',
  context INTEGER REFERENCES context, bag INTEGER REFERENCES bag,
  batch INTEGER REFERENCES batch,
  front INTEGER UNIQUE REFERENCES scan, back INTEGER UNIQUE REFERENCES scan,
  part TEXT NOT NULL DEFAULT '[]' CHECK (json_type(part) = 'array'),
  decoration TEXT NOT NULL DEFAULT '[]' CHECK (json_type(decoration) = 'array'),
  condition TEXT NOT NULL DEFAULT '[]' CHECK (json_type(condition) = 'array'),
  ware TEXT NOT NULL DEFAULT '', fabric TEXT NOT NULL DEFAULT '',
  inclusions TEXT NOT NULL DEFAULT '', manufacture TEXT NOT NULL DEFAULT '',
  firing TEXT NOT NULL DEFAULT '', surface_out TEXT NOT NULL DEFAULT '',
  surface_in TEXT NOT NULL DEFAULT '', munsell_out TEXT NOT NULL DEFAULT '',
  munsell_in TEXT NOT NULL DEFAULT '', munsell_core TEXT NOT NULL DEFAULT '',
  period TEXT NOT NULL DEFAULT '', date_edtf TEXT NOT NULL DEFAULT '',
  vessel TEXT NOT NULL DEFAULT '', note TEXT NOT NULL DEFAULT '',
  preview_path TEXT NOT NULL DEFAULT '', model_path TEXT NOT NULL DEFAULT '',
  CHECK (state <> 'numbered' OR (number <> '' AND context IS NOT NULL)),
  CHECK (state <> 'draft' OR number = '')
) STRICT;
CREATE INDEX sherd_context ON sherd (context);
CREATE INDEX sherd_bag ON sherd (bag);
CREATE INDEX sherd_batch ON sherd (batch);
CREATE INDEX sherd_updated ON sherd (updated_at);
-- The table of the window is put into another order from indexes alone: none of the rows is read.
-- State and number tell which sherds are shown.
CREATE INDEX sherd_number ON sherd (number_sort, row, state, number);
CREATE INDEX sherd_state ON sherd (state);
CREATE INDEX sherd_part ON sherd (part);
CREATE INDEX sherd_ware ON sherd (ware);

-- Every number that was ever given: none comes back, not even after a sherd was renumbered.
CREATE TABLE given_number (
  number_key TEXT PRIMARY KEY,       -- NFC, case-folded
  slug_key TEXT NOT NULL UNIQUE,     -- of the file names made from it
  number TEXT NOT NULL, sherd INTEGER NOT NULL REFERENCES sherd, at INTEGER NOT NULL
) STRICT;
-- The running numbers of a place, written with blanks (char(160) is one that joins) or without.
CREATE INDEX given_number_place ON given_number (
  replace(replace(number_key, ' ', ''), char(160), ''));
CREATE INDEX given_number_sherd ON given_number (sherd);

CREATE TABLE sherd_join (
  sherd INTEGER NOT NULL REFERENCES sherd, other INTEGER NOT NULL REFERENCES sherd,
  PRIMARY KEY (sherd, other), CHECK (sherd <> other)
) STRICT, WITHOUT ROWID;

-- A new value is a new row that replaces the older one; current marks what counts.
CREATE TABLE measurement (
  row INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE, at INTEGER NOT NULL,
  person INTEGER REFERENCES person, sherd INTEGER NOT NULL REFERENCES sherd,
  kind TEXT NOT NULL, value REAL NOT NULL CHECK (value >= 0),
  unit TEXT NOT NULL CHECK (unit IN ('mm', 'mm2', 'mm3', 'g', 'deg', 'pct')), uncertainty REAL,
  method TEXT NOT NULL CHECK (method IN ('program', 'scale', 'calliper', 'estimate', 'imported')),
  model_sha256 TEXT NOT NULL DEFAULT '', replaces INTEGER REFERENCES measurement,
  current INTEGER NOT NULL DEFAULT 1
) STRICT;
CREATE UNIQUE INDEX measurement_current ON measurement (sherd, kind) WHERE current = 1;
CREATE INDEX measurement_sherd ON measurement (sherd, kind, value);

-- What counts now, one row a sherd, for the table and its order.
CREATE TABLE sherd_measure (
  sherd INTEGER PRIMARY KEY REFERENCES sherd,
  length REAL, width REAL, thickness_min REAL, thickness_mean REAL, thickness_max REAL,
  area REAL, volume REAL, filled_pct REAL, rim_diameter REAL, rim_pct REAL, weight REAL
) STRICT;
CREATE INDEX sherd_measure_length ON sherd_measure (length);
CREATE INDEX sherd_measure_width ON sherd_measure (width);
CREATE INDEX sherd_measure_thickness ON sherd_measure (thickness_mean);
CREATE INDEX sherd_measure_area ON sherd_measure (area);
CREATE INDEX sherd_measure_volume ON sherd_measure (volume);
CREATE INDEX sherd_measure_rim ON sherd_measure (rim_diameter);
CREATE INDEX sherd_measure_weight ON sherd_measure (weight);

CREATE TABLE file (
  row INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE,
  created_at INTEGER NOT NULL, created_by INTEGER REFERENCES person,
  updated_at INTEGER NOT NULL, updated_by INTEGER REFERENCES person,
  revision INTEGER NOT NULL DEFAULT 1, extra TEXT NOT NULL DEFAULT '{}' CHECK (json_valid(extra)),
  path TEXT NOT NULL UNIQUE, sha256 TEXT NOT NULL, bytes INTEGER NOT NULL CHECK (bytes >= 0),
  media_type TEXT NOT NULL,
  role TEXT NOT NULL CHECK (role IN ('photo', 'mask', 'scan', 'model', 'preview', 'drawing',
                                     'report', 'scale')),
  state TEXT NOT NULL DEFAULT 'present' CHECK (state IN ('present', 'missing', 'changed')),
  sherd INTEGER REFERENCES sherd, batch INTEGER REFERENCES batch
) STRICT;
CREATE INDEX file_sherd ON file (sherd);
CREATE INDEX file_batch ON file (batch);

-- Only added to. person NULL: the program.
CREATE TABLE history (
  number INTEGER PRIMARY KEY, at INTEGER NOT NULL, person INTEGER REFERENCES person,
  table_name TEXT NOT NULL, row INTEGER NOT NULL, field TEXT NOT NULL, old TEXT NOT NULL,
  new TEXT NOT NULL, why TEXT NOT NULL, source TEXT NOT NULL
) STRICT;
CREATE INDEX history_row ON history (table_name, row);
-- Which front of an earlier plate a sherd had before it was photographed again.
CREATE INDEX history_front ON history (old) WHERE table_name = 'sherd' AND field = 'front';

CREATE TRIGGER history_stays BEFORE UPDATE ON history
  BEGIN SELECT raise(ABORT, 'history is only added to'); END;
CREATE TRIGGER history_is_kept BEFORE DELETE ON history
  BEGIN SELECT raise(ABORT, 'history is only added to'); END;
CREATE TRIGGER pair_decision_stays BEFORE UPDATE ON pair_decision
  BEGIN SELECT raise(ABORT, 'pair decisions are only added to'); END;
CREATE TRIGGER pair_decision_is_kept BEFORE DELETE ON pair_decision
  BEGIN SELECT raise(ABORT, 'pair decisions are only added to'); END;
CREATE TRIGGER piece_decision_stays BEFORE UPDATE ON piece_decision
  BEGIN SELECT raise(ABORT, 'decisions about pieces are only added to'); END;
CREATE TRIGGER piece_decision_is_kept BEFORE DELETE ON piece_decision
  BEGIN SELECT raise(ABORT, 'decisions about pieces are only added to'); END;
CREATE TRIGGER given_number_is_kept BEFORE DELETE ON given_number
  BEGIN SELECT raise(ABORT, 'a number that was given stays taken'); END;

-- Terms of the vocabularies, and the text that is searched; written with each saved sherd.
CREATE TABLE sherd_term (
  term TEXT NOT NULL, field TEXT NOT NULL, sherd INTEGER NOT NULL REFERENCES sherd,
  PRIMARY KEY (term, field, sherd)
) STRICT, WITHOUT ROWID;
CREATE INDEX sherd_term_sherd ON sherd_term (sherd);

CREATE VIEW sherd_terms AS
  SELECT sherd.row AS sherd, 'part' AS field, value AS term FROM sherd, json_each(part)
  UNION ALL SELECT sherd.row, 'decoration', value FROM sherd, json_each(decoration)
  UNION ALL SELECT sherd.row, 'condition', value FROM sherd, json_each(condition)
  UNION ALL SELECT row, 'manufacture', manufacture FROM sherd WHERE manufacture <> ''
  UNION ALL SELECT row, 'firing', firing FROM sherd WHERE firing <> ''
  UNION ALL SELECT row, 'surface_out', surface_out FROM sherd WHERE surface_out <> ''
  UNION ALL SELECT row, 'surface_in', surface_in FROM sherd WHERE surface_in <> '';

CREATE VIEW sherd_words AS
  SELECT s.row AS sherd, s.number || char(10) || ifnull(site.code, '')
    || char(10) || ifnull(trench.code, '') || char(10) || ifnull(context.number, '')
    || char(10) || ifnull(batch.number, '') || char(10) || s.part || char(10) || s.decoration
    || char(10) || s.condition || char(10) || s.ware || char(10) || s.fabric
    || char(10) || s.inclusions || char(10) || s.manufacture || char(10) || s.firing
    || char(10) || s.surface_out || char(10) || s.surface_in || char(10) || s.munsell_out
    || char(10) || s.munsell_in || char(10) || s.munsell_core || char(10) || s.period
    || char(10) || s.date_edtf || char(10) || s.vessel || char(10) || s.note
    || char(10) || ifnull((SELECT group_concat(value, char(10)) FROM json_each(s.extra)), '') AS words
  FROM sherd s LEFT JOIN context ON context.row = s.context LEFT JOIN site ON site.row = context.site
    LEFT JOIN trench ON trench.row = context.trench LEFT JOIN batch ON batch.row = s.batch;

CREATE VIRTUAL TABLE sherd_text USING fts5(words, tokenize = 'trigram');
