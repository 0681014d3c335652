"""The work cell: stations, tools, devices, parts, signals and frames, and the tree of its bodies."""
