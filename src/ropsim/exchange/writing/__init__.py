"""A robot as joints of one freedom, and what the formats lose of it."""
