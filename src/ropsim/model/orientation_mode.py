"""How a controller turns the tool on its paths."""

from enum import Enum


class OrientationMode(Enum):
    """Which of the ways from one orientation to another the tool takes.

    With wrist angles the joints of the wrist turn evenly along a line or an arc, on a curve smoothly from
    point to point, and how the tool turns follows from the arm; a path by itself, which knows no arm, has a
    fixed axis then.
    """

    FIXED_AXIS = "fixed axis"
    DRIVE_TRANSFORM = "drive transform"
    WRIST_ANGLES = "wrist angles"
