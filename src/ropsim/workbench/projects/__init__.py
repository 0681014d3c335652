"""Projects: opening, making, calibrating and running them, and the points of their programs."""
