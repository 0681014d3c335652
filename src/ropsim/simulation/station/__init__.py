"""A station at work: instructions, motion sequences, moves, settling."""
