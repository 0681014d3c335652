"""Tasks that an operator chooses: their list, the state of each step, the time of the program."""
