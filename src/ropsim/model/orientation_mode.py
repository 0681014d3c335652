"""How a controller turns the tool on its paths."""

from enum import Enum


class OrientationMode(Enum):
    """Which of the ways from one orientation to another the tool takes."""

    FIXED_AXIS = "fixed axis"
    DRIVE_TRANSFORM = "drive transform"
