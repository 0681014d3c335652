"""The running state of a cell and its stations, its inputs and the inputs of its sensors."""
