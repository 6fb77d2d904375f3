// The precompiled headers of the window belong to a target; this is its only source.
