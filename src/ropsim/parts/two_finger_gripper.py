"""Two-finger grippers: a housing with a rail across it, on which two fingers with pads go apart."""

from ropsim.model import DARK_GREY, STEEL_GREY, Box, Fingers, Gripper, Material, Shape
from ropsim.parts.elements import (
    ADAPTER,
    HOUSING,
    RUBBER,
    adapter_plate,
    block,
    housing,
    length_of,
    tool_parameters,
)
from ropsim.parts.fingers import shaped_fingers
from ropsim.parts.gripper_products import TWO_FINGER_PRODUCTS
from ropsim.parts.part_kind import TCP, LibraryPart, PartKind, UpperBound, Use, Values
from ropsim.parts.solid_mass import filled, with_com
from ropsim.spatial import Pose, translation

_RAIL = 0.016  # [m], height of the rail over the housing
_PAD = 0.4  # share of a finger's thickness
_CAPTURE = 0.01  # [m]
_SHORTEST = 0.02  # [m], of a housing

_PARAMETERS = (
    length_of("stroke", 0.08, 0.002, 0.4, "Distance between the open fingers; closed they touch."),
    *tool_parameters(0.8, 0.2, 0.2),
    length_of("body_length", 0.08, 0.02, 0.4, "Length of the housing along the approach direction."),
    length_of("body_width", 0.1, 0.02, 0.5, "Width of the housing along the way of the fingers."),
    length_of("body_depth", 0.06, 0.02, 0.3, "Depth of the housing across both."),
    length_of("finger_length", 0.055, 0.01, 0.4, "Length of the fingers in front of the rail."),
    length_of("finger_width", 0.02, 0.004, 0.2, "Width of the fingers across their way."),
    length_of("finger_thickness", 0.012, 0.003, 0.1, "Thickness of a finger along its way."),
    length_of("grip_depth", 0.012, 0.0, 0.2, "Distance by which the fingers reach beyond the TCP."),
    length_of("flange_diameter", 0.063, 0.02, 0.3, "Diameter of the adapter plate."),
)


def _make(values: Values) -> LibraryPart:
    """Return a gripper; its TCP is between the pads, `grip_depth` behind the tips of the fingers."""
    body, finger = _lengths(values)
    front = ADAPTER + body + _RAIL
    X_MT = translation(0.0, 0.0, front + finger - values["grip_depth"])
    shapes = (*adapter_plate(values["flange_diameter"]), *_housing(values, body))
    fingers = shaped_fingers(X_MT, values["stroke"], 0.0, _finger(values, front, finger, X_MT))
    load = filled((*shapes, *_opened(fingers)), values["mass"])
    gripper = Gripper(values["open_time"], values["close_time"], _CAPTURE, fingers)
    return LibraryPart(shapes, (), with_com(load, values.get("com")), X_MT, gripper, HOUSING)


def _lengths(values: Values) -> tuple[float, float]:
    """Return the lengths of housing and fingers, which reach to a given TCP [m]."""
    if TCP not in values:
        return values["body_length"], values["finger_length"]
    both = values[TCP] + values["grip_depth"] - ADAPTER - _RAIL
    finger = min(values["finger_length"], both - _SHORTEST)
    return both - finger, finger


def _housing(values: Values, length: float) -> tuple[Shape, ...]:
    """Return housing, cover and rail of a housing of a length [m], in the mechanical interface frame."""
    width, depth = values["body_width"], values["body_depth"]
    span = max(width, values["stroke"] + 3.0 * values["finger_thickness"])
    front = ADAPTER + length + _RAIL
    return (
        *housing((depth, width, length), (0.7, 1.02, 0.7)),
        block((0.8 * depth, span, 0.4 * _RAIL), (0.0, 0.0, front - 0.8 * _RAIL), DARK_GREY),
        block(
            (0.35 * depth, 0.98 * span, 0.6 * _RAIL),
            (0.0, 0.0, front - 0.3 * _RAIL),
            STEEL_GREY,
            Material.STEEL,
        ),
    )


def _finger(values: Values, front: float, length: float, X_MT: Pose) -> tuple[Shape, ...]:
    """Return jaw, finger and pad on the side of +y at distance 0, in the tool frame."""
    thick, width = values["finger_thickness"], values["finger_width"]
    reach = values["grip_depth"]
    jaw, embraced = min(0.35 * length, 0.02), 0.5 * _RAIL
    base = front - float(X_MT.position[2])  # of the finger, along z of the tool
    pad, pad_length = _PAD * thick, min(0.022, 0.5 * length)
    wide = 1.4 * width
    return (
        block(
            (wide, 1.3 * thick, jaw + embraced),
            (0.0, 0.7 * pad + 0.65 * thick, base + (jaw - embraced) / 2.0),
            DARK_GREY,
        ),
        block(
            (width, thick - pad, length),
            (0.0, pad + (thick - pad) / 2.0, base + length / 2.0),
            STEEL_GREY,
            Material.STEEL,
        ),
        Shape(
            Box((width, pad, pad_length)),
            translation(0.0, pad / 2.0, reach - pad_length / 2.0),
            RUBBER,
            material=Material.RUBBER,
        ),
    )


def _opened(fingers: Fingers) -> tuple[Shape, ...]:
    """Return the shapes of open fingers in the mechanical interface frame."""
    out = translation(0.0, 0.0, fingers.opened)
    return tuple(
        Shape(shape.solid, joint.placement @ out @ shape.pose)
        for joint, link in zip(fingers.mechanism.joints, fingers.mechanism.links, strict=True)
        for shape in link.shapes
    )


TWO_FINGER_GRIPPER = PartKind(
    "two_finger_gripper",
    "Two-finger gripper",
    Use.TOOL,
    "The mechanical interface; the TCP is between the pads, the fingers go apart along y.",
    _PARAMETERS,
    _make,
    TWO_FINGER_PRODUCTS,
    (UpperBound("grip_depth", "finger_length"),),
)
