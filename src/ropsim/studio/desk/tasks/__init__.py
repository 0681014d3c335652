"""Tasks that an operator chooses: what there is, what is said of each step, how long the program takes."""
