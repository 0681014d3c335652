"""The texts of a project: edited, saved, watched on the disk."""
