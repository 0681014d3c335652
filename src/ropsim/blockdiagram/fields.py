"""How the fields of blocks stand in a file: a table from entities of the schema to records."""

from enum import Enum, StrEnum
from typing import TypeAlias

from ropsim.blockdiagram import blocks as b
from ropsim.core import frozen_dataclass


class FieldKind(Enum):
    """Type of a field in a file, where it is not an enumeration."""

    REAL = "number"
    REALS = "numbers"
    OPTIONAL_REALS = "numbers or nothing"
    MATRIX = "matrix"
    INTEGER = "whole number"
    INTEGERS = "whole numbers"


Kind: TypeAlias = FieldKind | type[StrEnum]


@frozen_dataclass
class BlockForm:
    """A kind of block in a file.

    Attributes:
        entity: of the schema.
        block: record.
        fields: names and types of its own fields, in the order of the schema.
    """

    entity: str
    block: type[b.Block]
    fields: tuple[tuple[str, Kind], ...] = ()


_REAL, _REALS, _OPTIONAL = FieldKind.REAL, FieldKind.REALS, FieldKind.OPTIONAL_REALS
_MATRIX, _INTEGER = FieldKind.MATRIX, FieldKind.INTEGER
_TIME = ("sample_time", _REAL)

BLOCK_FORMS = (
    BlockForm("gain", b.Gain, (("factors", _REALS),)),
    BlockForm("matrix_gain", b.MatrixGain, (("matrix", _MATRIX),)),
    BlockForm("sum", b.Sum, (("signs", FieldKind.INTEGERS),)),
    BlockForm("product", b.Product),
    BlockForm("constant_source", b.Constant, (("values", _REALS),)),
    BlockForm(
        "state_space",
        b.StateSpace,
        (("a", _MATRIX), ("b", _MATRIX), ("c", _MATRIX), ("d", _MATRIX), ("x0", _OPTIONAL), _TIME),
    ),
    BlockForm(
        "transfer_function",
        b.TransferFunction,
        (("numerator", _REALS), ("denominator", _REALS), ("method", b.Method), _TIME),
    ),
    BlockForm("integrator", b.Integrator, (("factors", _REALS), ("initial", _REALS), _TIME)),
    BlockForm(
        "pid",
        b.Pid,
        (
            *((name, _REALS) for name in ("kp", "ki", "kd", "derivative_filter")),
            *(("setpoint_weight", _REALS), ("derivative_weight", _REALS)),
            *(("lower", _OPTIONAL), ("upper", _OPTIONAL)),
            *(("anti_windup", b.AntiWindup), ("tracking_time", _OPTIONAL), _TIME),
        ),
    ),
    BlockForm("saturation", b.Saturation, (("lower", _REALS), ("upper", _REALS))),
    BlockForm("rate_limiter", b.RateLimiter, (("falling", _REALS), ("rising", _REALS), _TIME)),
    BlockForm("dead_band", b.DeadBand, (("lower", _REALS), ("upper", _REALS))),
    BlockForm("delay", b.Delay, (("ticks", _INTEGER),)),
    BlockForm("lookup_1d", b.Lookup, (("points", _REALS), ("values", _REALS))),
    BlockForm("notch", b.Notch, (("frequency", _REAL), ("damping", _REAL), ("depth", _REAL), _TIME)),
    BlockForm("moving_filter", b.MovingFilter, (("ticks", _INTEGER),)),
    BlockForm("switch", b.Switch, (("threshold", _REAL),)),
    BlockForm("model_feed_forward", b.ModelFeedForward, (("kind", b.ModelKind),)),
    BlockForm("drive_command", b.DriveCommand),
)
"""Every kind of block: another one is a record, an entity of the schema, an entry here, and its code."""

FORM_OF = {one.block: one for one in BLOCK_FORMS}
FORM_OF_ENTITY = {one.entity: one for one in BLOCK_FORMS}
