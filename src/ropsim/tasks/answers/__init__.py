"""Whether a call is possible, what it lacks, and which tasks reach a goal."""
