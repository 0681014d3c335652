"""Two-finger grippers: a housing with a rail across it, on which two fingers with pads go apart."""

from ropsim.model import Box, Fingers, Gripper, Material, Shape
from ropsim.parts.elements import (
    BODY,
    DARK,
    RUBBER,
    STEEL,
    at,
    block,
    length_of,
    tool_parameters,
    upright,
)
from ropsim.parts.fingers import shaped_fingers
from ropsim.parts.gripper_products import TWO_FINGER_PRODUCTS
from ropsim.parts.part_kind import LibraryPart, PartKind, Use, Values
from ropsim.parts.solid_mass import filled, with_com
from ropsim.spatial import Pose

_PLATE = 0.012  # [m], thickness of the adapter plate
_RAIL = 0.016  # [m], height of the rail over the housing
_PAD = 0.4  # share of a finger's thickness
_CAPTURE = 0.01  # [m]

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
    front = _PLATE + values["body_length"] + _RAIL
    X_MT = at(0.0, 0.0, front + values["finger_length"] - values["grip_depth"])
    shapes = _housing(values, front)
    fingers = shaped_fingers(X_MT, values["stroke"], 0.0, _finger(values, front, X_MT))
    load = filled((*shapes, *_opened(fingers)), values["mass"])
    gripper = Gripper(values["open_time"], values["close_time"], _CAPTURE, fingers)
    return LibraryPart(shapes, (), with_com(load, values.get("com")), X_MT, gripper, BODY)


def _housing(values: Values, front: float) -> tuple[Shape, ...]:
    """Return adapter plate, housing, covers and rail, in the mechanical interface frame."""
    width, depth, length = values["body_width"], values["body_depth"], values["body_length"]
    radius = values["flange_diameter"] / 2.0
    span = max(width, values["stroke"] + 3.0 * values["finger_thickness"])
    middle = _PLATE + length / 2.0
    return (
        upright(radius, 0.0, 0.7 * _PLATE, STEEL, Material.STEEL),
        upright(0.8 * radius, 0.7 * _PLATE, _PLATE, DARK),
        block((depth, width, length), (0.0, 0.0, middle), BODY),
        block((0.7 * depth, 1.02 * width, 0.7 * length), (0.0, 0.0, middle), DARK),
        block((0.8 * depth, span, 0.4 * _RAIL), (0.0, 0.0, front - 0.8 * _RAIL), DARK),
        block(
            (0.35 * depth, 0.98 * span, 0.6 * _RAIL), (0.0, 0.0, front - 0.3 * _RAIL), STEEL, Material.STEEL
        ),
    )


def _finger(values: Values, front: float, X_MT: Pose) -> tuple[Shape, ...]:
    """Return jaw, finger and pad on the side of +y at distance 0, in the tool frame."""
    thick, width = values["finger_thickness"], values["finger_width"]
    length, reach = values["finger_length"], values["grip_depth"]
    jaw, embraced = min(0.35 * length, 0.02), 0.5 * _RAIL
    base = front - float(X_MT.position[2])  # of the finger, along z of the tool
    pad, pad_length = _PAD * thick, min(0.022, 0.5 * length)
    wide = 1.4 * width
    return (
        block(
            (wide, 1.3 * thick, jaw + embraced),
            (0.0, 0.7 * pad + 0.65 * thick, base + (jaw - embraced) / 2.0),
            DARK,
        ),
        block(
            (width, thick - pad, length),
            (0.0, pad + (thick - pad) / 2.0, base + length / 2.0),
            STEEL,
            Material.STEEL,
        ),
        Shape(
            Box((width, pad, pad_length)),
            at(0.0, pad / 2.0, reach - pad_length / 2.0),
            RUBBER,
            material=Material.RUBBER,
        ),
    )


def _opened(fingers: Fingers) -> tuple[Shape, ...]:
    """Return the shapes of open fingers in the mechanical interface frame."""
    out = at(0.0, 0.0, fingers.opened)
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
    (("grip_depth", "finger_length"),),
)
