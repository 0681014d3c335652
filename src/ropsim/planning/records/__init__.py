"""Records of planning, and the protocols of its entities."""
