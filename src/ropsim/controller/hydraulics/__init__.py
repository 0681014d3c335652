"""Laws of hydraulic axes: parallel PI loops, and the law of flow, load and damping."""
