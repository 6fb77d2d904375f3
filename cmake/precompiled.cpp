// Precompiled headers belong to a target; this is its only source.
