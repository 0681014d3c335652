"""The table of the kinds of blocks: another one is a file and an entry here, and an entity of the schema."""

from ropsim.blockdiagram import block_faults as faults
from ropsim.blockdiagram import blocks as b
from ropsim.blockdiagram.discrete import Filter, notch_filter, transfer_filter
from ropsim.blockdiagram.fields import BlockForm, FieldKind, Trait

_REAL, _REALS, _OPTIONAL = FieldKind.REAL, FieldKind.REALS, FieldKind.OPTIONAL_REALS
_MATRIX, _INTEGER = FieldKind.MATRIX, FieldKind.INTEGER
_TIME = ("sample_time", _REAL)
_LIMITS = (("lower", _REALS), ("upper", _REALS))
_EACH = Trait.ELEMENTWISE
_SAME = Trait.ELEMENTWISE | Trait.KEEPS_UNITS
_ANY = 1000
"""Most inputs of a block."""


def _later(block: b.Block) -> bool:
    del block
    return False


def _feeds_through(block: b.StateSpace) -> bool:
    return any(any(row) for row in block.d)


BLOCK_FORMS = (
    BlockForm("gain", b.Gain, (("factors", _REALS),), traits=_EACH),
    BlockForm("matrix_gain", b.MatrixGain, (("matrix", _MATRIX),), inputs=(1, _ANY)),
    BlockForm(
        "sum",
        b.Sum,
        (("signs", FieldKind.INTEGERS),),
        traits=_SAME,
        inputs=(1, _ANY),
        faults=faults.sum_faults,
    ),
    BlockForm("product", b.Product, traits=_EACH, inputs=(2, _ANY)),
    BlockForm("constant_source", b.Constant, (("values", _REALS),), inputs=(0, 0)),
    BlockForm(
        "state_space",
        b.StateSpace,
        (("a", _MATRIX), ("b", _MATRIX), ("c", _MATRIX), ("d", _MATRIX), ("x0", _OPTIONAL), _TIME),
        inputs=(1, _ANY),
        whole=("x0",),
        at_once=_feeds_through,
    ),
    BlockForm(
        "transfer_function",
        b.TransferFunction,
        (("numerator", _REALS), ("denominator", _REALS), ("method", b.Method), _TIME),
        traits=_EACH,
        whole=("numerator", "denominator"),
        faults=faults.transfer_function_faults,
        filter=transfer_filter,
    ),
    BlockForm(
        "integrator",
        b.Integrator,
        (("factors", _REALS), ("initial", _REALS), _TIME),
        traits=_EACH,
        at_once=_later,
    ),
    BlockForm(
        "pid",
        b.Pid,
        (
            *((name, _REALS) for name in ("kp", "ki", "kd", "derivative_filter")),
            *(("setpoint_weight", _REALS), ("derivative_weight", _REALS)),
            *(("lower", _OPTIONAL), ("upper", _OPTIONAL)),
            *(("anti_windup", b.AntiWindup), ("tracking_time", _OPTIONAL), _TIME),
        ),
        traits=_EACH,
        inputs=(2, 3),
        faults=faults.pid_faults,
    ),
    BlockForm("saturation", b.Saturation, _LIMITS, traits=_SAME, faults=faults.limit_faults),
    BlockForm(
        "rate_limiter",
        b.RateLimiter,
        (("falling", _REALS), ("rising", _REALS), _TIME),
        traits=_SAME,
        faults=faults.rate_faults,
    ),
    BlockForm("dead_band", b.DeadBand, _LIMITS, traits=_SAME, faults=faults.limit_faults),
    BlockForm(
        "delay",
        b.Delay,
        (("ticks", _INTEGER),),
        traits=_SAME,
        faults=faults.tick_faults,
        at_once=_later,
    ),
    BlockForm(
        "lookup_1d",
        b.Lookup,
        (("points", _REALS), ("values", _REALS)),
        traits=_EACH,
        whole=("points", "values"),
        faults=faults.point_faults,
    ),
    BlockForm(
        "notch",
        b.Notch,
        (("frequency", _REAL), ("damping", _REAL), ("depth", _REAL), _TIME),
        traits=_SAME,
        faults=faults.notch_faults,
        filter=notch_filter,
    ),
    BlockForm(
        "moving_filter",
        b.MovingFilter,
        (("ticks", _INTEGER),),
        traits=_SAME,
        faults=faults.tick_faults,
    ),
    BlockForm("switch", b.Switch, (("threshold", _REAL),), inputs=(3, 3)),
    BlockForm("model_feed_forward", b.ModelFeedForward, (("kind", b.ModelKind),), inputs=(1, 4)),
    BlockForm("drive_command", b.DriveCommand, inputs=(2, 2)),
)
"""Every kind of block: reading, writing, checks and wiring know them from here."""

FORM_OF = {one.block: one for one in BLOCK_FORMS}
FORM_OF_ENTITY = {one.entity: one for one in BLOCK_FORMS}


def filter_of(block: b.Block) -> Filter | None:
    """Return a block without faults as a filter of each element in discrete time; None where it is none."""
    form = FORM_OF[type(block)]
    return form.filter(block) if form.filter else None


def passes_at_once(block: b.Block) -> bool:
    """Return whether an output of a block without faults depends on its inputs at the same tick."""
    made = filter_of(block)
    return FORM_OF[type(block)].at_once(block) if made is None else made.b[0] != 0.0
