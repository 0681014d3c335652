"""Charts as SVG text: over time, in a plane."""
