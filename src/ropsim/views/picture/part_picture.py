"""A part of the library as a picture: a tool hangs down with its fingers open, anything else stands."""

from collections.abc import Iterator

import numpy as np

from ropsim.kinematics import joint_frames
from ropsim.model import Shape
from ropsim.parts import LibraryPart
from ropsim.spatial import Array, fingerprint
from ropsim.views.picture.robot_picture import DRAWING, PictureOptions, Placed, bodies_png

SEEN = PictureOptions(azimuth=-58.0, elevation=12.0)
"""How parts are seen without other options."""
_CLEAR = 0.2
_DIGITS = 9  # of places, in metres
_HANGING = np.diag([1.0, -1.0, -1.0, 1.0])


def part_print(part: LibraryPart, options: PictureOptions = SEEN) -> str:
    """Return a key that changes with the picture of a part, not with its mass or its tool frame.

    Places are rounded: their last digits depend on the processor.
    """
    turn = _turn(part)
    drawn = [
        (shape.solid, np.round(turn @ X @ shape.pose.matrix(), _DIGITS) + 0.0, shape.colour, shape.material)
        for X, shapes in _bodies(part)
        for shape in _seen(shapes)
    ]
    return fingerprint((DRAWING, options, drawn))


def part_png(title: str, part: LibraryPart, options: PictureOptions = SEEN) -> bytes:
    """Return a picture of a part as a PNG file, on a transparent ground."""
    words = {"Title": title, "Source": part_print(part, options)}
    turn = _turn(part)
    return bodies_png(((turn @ X, _seen(shapes)) for X, shapes in _bodies(part)), words, options)


def _turn(part: LibraryPart) -> Array:
    """Return the pose in which a part is seen, shape (4, 4)."""
    return np.eye(4) if part.X_MT is None else _HANGING


def _seen(shapes: tuple[Shape, ...]) -> tuple[Shape, ...]:
    """Return the shapes that are not nearly clear: the picture has no opacity."""
    return tuple(shape for shape in shapes if shape.opacity > _CLEAR)


def _bodies(part: LibraryPart) -> Iterator[Placed]:
    """Yield the fixed body, the moving one and the fingers."""
    yield np.eye(4), part.shapes
    yield np.eye(4), part.moving_shapes
    fingers = part.gripper.fingers if part.gripper else None
    if fingers is not None:
        frames = joint_frames(fingers.mechanism, np.array([fingers.opened]))
        for X, link in zip(frames, fingers.mechanism.links, strict=False):
            yield X, link.shapes
