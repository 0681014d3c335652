"""Typed expressions of the structured program; every value in SI units."""

from ropsim.core import frozen_dataclass
from ropsim.flow import PostureRequest
from ropsim.program.types import ValueType


@frozen_dataclass
class Constant:
    """A value: bool, int, float, str, or a tuple (VEC 3, ORI w x y z, POSE x y z qw qx qy qz, JOINTS n)."""

    value: bool | int | float | str | tuple[float, ...]
    type: ValueType


@frozen_dataclass
class Variable:
    """The value of a parameter, local or global."""

    name: str
    type: ValueType


@frozen_dataclass
class SignalValue:
    """The present value of an input or output channel (BOOL or REAL)."""

    name: str
    type: ValueType


@frozen_dataclass
class Unary:
    """One operand.

    `op` is `neg`, `not`, `abs`, `sqrt`, `sin`, `cos`, `tan`, `asin`, `acos`, `to_real` (INT to REAL),
    `trunc`, `round` (REAL to INT), `invert` (POSE), `position` (POSE to VEC) or `orientation` (POSE to ORI).
    """

    op: str
    operand: "Expression"
    type: ValueType


@frozen_dataclass
class Binary:
    """Two operands of one type.

    `op` is `add sub mul div mod min max pow atan2` (INT, REAL; `add sub` also VEC), `eq ne lt le gt ge` (INT
    or REAL operands, for `eq ne` also BOOL; BOOL result), `and or` (BOOL), `compose` (POSE) or `distance`
    (two POSE to REAL).
    """

    op: str
    left: "Expression"
    right: "Expression"
    type: ValueType


@frozen_dataclass
class Component:
    """Component `index` of a POSE (x y z, then rx ry rz of the fixed-XYZ angles), VEC or JOINTS."""

    operand: "Expression"
    index: int
    type: ValueType = ValueType.REAL


@frozen_dataclass
class MakeVector:
    """The vector of three REALs."""

    x: "Expression"
    y: "Expression"
    z: "Expression"
    type: ValueType = ValueType.VEC


@frozen_dataclass
class MakeZyx:
    """The orientation Rz(c)·Ry(b)·Rx(a) of three angles."""

    c: "Expression"
    b: "Expression"
    a: "Expression"
    type: ValueType = ValueType.ORI


@frozen_dataclass
class MakePose:
    """The pose of a VEC and an ORI."""

    position: "Expression"
    orientation: "Expression"
    type: ValueType = ValueType.POSE


@frozen_dataclass
class MakeExternal:
    """A POSE with REAL values of external axes [rad | m] in place of its present ones."""

    pose: "Expression"
    values: tuple["Expression", ...]
    type: ValueType = ValueType.POSE


@frozen_dataclass
class MakeJoints:
    """Joint coordinates from REALs."""

    values: tuple["Expression", ...]
    type: ValueType = ValueType.JOINTS


@frozen_dataclass
class CommandPose:
    """The pose at which the last move ends by command, X_KT (`here`)."""

    type: ValueType = ValueType.POSE


@frozen_dataclass
class InPosture:
    """A POSE that is to be reached in a posture, with turns of the axes, or with any orientation."""

    operand: "Expression"
    request: PostureRequest
    type: ValueType = ValueType.POSE


@frozen_dataclass
class InFrame:
    """A POSE whose numbers are expressed in a specific frame, independent of the frame in force.

    Where a frame moves, as on a positioner, its place is known only when the move is planned. Without a name
    the numbers are expressed in the frame in force.
    """

    operand: "Expression"
    frame: str
    type: ValueType = ValueType.POSE


@frozen_dataclass
class InAxes:
    """A POSE that `Offset` shifts along these axes: a unit quaternion, seen in the work frame.

    They go wherever the location is kept and passed; one in a frame of its own is shifted along that.
    """

    operand: "Expression"
    axes: tuple[float, float, float, float]
    type: ValueType = ValueType.POSE


@frozen_dataclass
class Offset:
    """A POSE shifted by a VEC along its axes."""

    operand: "Expression"
    way: "Expression"
    type: ValueType = ValueType.POSE


@frozen_dataclass
class Keeping:
    """`result`, in which `Kept` stands for `value`: a value needed more than once is computed once."""

    value: "Expression"
    result: "Expression"
    type: ValueType


@frozen_dataclass
class Kept:
    """The value of the innermost `Keeping` in whose result it stands."""

    type: ValueType


@frozen_dataclass
class Element:
    """The POSE of a list of the program whose number is an INT, counted from 1."""

    list: str
    index: "Expression"
    type: ValueType = ValueType.POSE


@frozen_dataclass
class Home:
    """The home position of the arm; only as the target of a PTP move."""

    type: ValueType = ValueType.JOINTS


Expression = (
    Constant
    | Variable
    | SignalValue
    | Unary
    | Binary
    | Component
    | MakeVector
    | MakeZyx
    | MakePose
    | MakeExternal
    | MakeJoints
    | CommandPose
    | InPosture
    | InFrame
    | InAxes
    | Offset
    | Keeping
    | Kept
    | Element
    | Home
)
