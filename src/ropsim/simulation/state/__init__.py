"""The running state of a cell and its stations, its inputs and what its sensors see."""
