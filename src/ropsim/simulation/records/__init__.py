"""Records of a run and its diagnostics."""
