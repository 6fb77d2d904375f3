-- What people said about pieces that the masks separated or joined wrongly. Only added to.
CREATE TABLE piece_decision (
  row INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE, at INTEGER NOT NULL,
  decision TEXT NOT NULL DEFAULT '',  -- its id in the batch's decisions.json
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
CREATE TRIGGER piece_decision_stays BEFORE UPDATE ON piece_decision
  BEGIN SELECT raise(ABORT, 'decisions about pieces are only added to'); END;
CREATE TRIGGER piece_decision_is_kept BEFORE DELETE ON piece_decision
  BEGIN SELECT raise(ABORT, 'decisions about pieces are only added to'); END;
