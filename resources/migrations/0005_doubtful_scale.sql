-- Why the scale of a batch is in doubt, whole sentences, one a line; empty: nothing speaks against
-- it. Until it is settled all measures that the program took of its sherds are in doubt.
ALTER TABLE batch ADD COLUMN scale_doubts TEXT NOT NULL DEFAULT '';
