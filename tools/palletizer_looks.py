"""What palletizers of makers look like: slats and rods around their link lengths, by eye."""

from dataclasses import dataclass

from ropsim.model import Box, Prism, Revolve, Shape, around, rod
from ropsim.spatial import Pose, translation

_STEEL = "#a3abb3"


@dataclass(frozen=True)
class Lengths:
    """Lengths of a palletizer [m].

    Attributes:
        height: of axes 2 and 3 above the floor.
        ahead: of axes 2 and 3 before axis 1.
        lower_arm: axis 2 to the elbow.
        forearm: elbow to the wrist.
        wrist: wrist to axis 4, ahead.
        flange: wrist to the interface, downwards.
    """

    height: float
    ahead: float
    lower_arm: float
    forearm: float
    wrist: float
    flange: float

    @property
    def size(self) -> float:
        """Return how much greater it is than one with a lower arm of 1.15 m."""
        return self.lower_arm / 1.15

    @property
    def crank(self) -> float:
        """Return axis 3 to its rod, and elbow to the rear end of the forearm [m]."""
        return 0.35 * self.lower_arm

    @property
    def pin(self) -> tuple[float, float]:
        """Return the places of the links that keep level, from their joints, ahead and up [m]."""
        return -0.16 * self.lower_arm, 0.17 * self.lower_arm


def base_shapes(lengths: Lengths, tones: list[str]) -> tuple[Shape, ...]:
    """Return the foot, in the base frame."""
    s, top = lengths.size, _deck(lengths)
    ring = ((0.0, 0.0), (0.4, 0.0), (0.4, 0.06), (0.32, 0.1), (0.32, 1.0), (0.0, 1.0))
    profile = tuple((r * s, z * s if z < 1.0 else top) for r, z in ring)
    return (
        Shape(Revolve(profile), Pose(), tones[2]),
        Shape(Box((0.95 * s, 0.95 * s, 0.03)), translation(0.0, 0.0, 0.015), tones[2]),
    )


def link_shapes(lengths: Lengths, tones: list[str]) -> list[tuple[Shape, ...]]:
    """Return the shapes of the ten bodies, each in the frame of its joint, in the order of the joints."""
    s, (pin_x, pin_z) = lengths.size, lengths.pin
    body, shade, dark = tones
    pin = (pin_x, -pin_z)  # in level frames, whose y points down
    beside = -0.125 * s
    return [
        _column(lengths, tones),
        (
            _slat(0.0, lengths.lower_arm, 0.14 * s, 0.1 * s, -0.06 * s, 0.12 * s, body),
            rod((0.0, 0.0, -0.1 * s), (0.0, 0.0, 0.1 * s), 0.14 * s, None, shade),
        ),
        (_slat(-lengths.crank, 0.0, 0.06 * s, 0.1 * s, 0.12 * s, 0.07 * s, dark),),
        (
            _slat(-lengths.crank, 0.0, 0.06 * s, 0.11 * s, -0.05 * s, 0.1 * s, body),
            _slat(0.0, lengths.forearm, 0.11 * s, 0.08 * s, -0.05 * s, 0.1 * s, body),
            rod((0.0, 0.0, -0.07 * s), (0.0, 0.0, 0.07 * s), 0.1 * s, None, shade),
        ),
        (_bar(lengths.lower_arm, 0.155 * s, 0.026 * s),),
        (
            Shape(
                Box((lengths.wrist + 0.12 * s, 0.12 * s, 0.16 * s)),
                translation(0.5 * lengths.wrist, 0.02 * s, 0.0),
                shade,
            ),
            rod((0.0, 0.0, beside), (*pin, beside), 0.03 * s, None, dark),
            rod((lengths.wrist, -0.1 * s, 0.0), (lengths.wrist, 0.09 * s, 0.0), 0.1 * s, None, dark),
        ),
        (
            rod((0.0, 0.0, beside), (0.0, 0.0, -0.05 * s), 0.05 * s, None, dark),
            rod((0.0, 0.0, beside), (*pin, beside), 0.035 * s, None, dark),
            rod((*pin, beside), (0.08 * s, -0.19 * s, beside), 0.03 * s, None, dark),
            rod((0.0, 0.0, beside), (0.08 * s, -0.19 * s, beside), 0.03 * s, None, dark),
        ),
        (_bar(lengths.lower_arm, beside, 0.022 * s),),
        (_bar(lengths.forearm, beside, 0.022 * s),),
        (
            rod((0.0, 0.0, 0.08 * s), (0.0, 0.0, lengths.flange - 0.03), 0.07 * s, None, _STEEL),
            rod((0.0, 0.0, lengths.flange - 0.03), (0.0, 0.0, lengths.flange), 0.11 * s, None, dark),
        ),
    ]


def _column(lengths: Lengths, tones: list[str]) -> tuple[Shape, ...]:
    s, low, high = lengths.size, _deck(lengths), lengths.height
    (body, _, dark), x = tones, lengths.ahead
    pin_x, pin_z = lengths.pin
    tall = high - low
    return (
        rod((0.0, 0.0, low), (0.0, 0.0, low + 0.3 * tall), 0.36 * s, 0.33 * s, body),
        *(
            Shape(
                Box((x + 0.4 * s, 0.13 * s, 0.85 * tall)),
                translation(0.5 * x, y * s, low + 0.3 * tall + 0.42 * tall),
                body,
            )
            for y in (-0.2, 0.24)
        ),
        rod((x, -0.28 * s, high), (x, 0.31 * s, high), 0.11 * s, None, dark),
        rod((x, -0.125 * s, high), (x + pin_x, -0.125 * s, high + pin_z), 0.035 * s, None, dark),
    )


def _deck(lengths: Lengths) -> float:
    """Return where the foot ends and the column begins [m]."""
    return lengths.height - 0.5 * lengths.size


def _slat(
    start: float, end: float, first: float, last: float, low: float, depth: float, colour: str
) -> Shape:
    """Return a slat along x with round ends, beginning at `low` along the joint."""
    return Shape(
        Prism(around(((start, 0.0, first), (end, 0.0, last))), depth), translation(0.0, 0.0, low), colour
    )


def _bar(length: float, beside: float, radius: float) -> Shape:
    """Return a link that turns on pins at both ends, `beside` the plane of the arm."""
    bar = Prism(around(((0.0, 0.0, 1.5 * radius), (length, 0.0, 1.5 * radius))), radius)
    return Shape(bar, translation(0.0, 0.0, beside - 0.5 * radius), _STEEL)
