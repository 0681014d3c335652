"""Speeds, accelerations, blends and tools: settings of one move, of a block, or until further notice."""

from collections.abc import Callable

from ropsim.language.check import convert, fold, plausible, units, values
from ropsim.language.check.body import Body
from ropsim.language.check.types import LENGTH, Type, Value, article, known
from ropsim.language.findings import types as kinds
from ropsim.language.syntax.statements import Motion, Setting
from ropsim.program import Expression, Settings, ValueType

_REAL = ValueType.REAL
_FIELDS: dict[tuple[str, units.Dimension], Callable[[Expression], Settings]] = {
    ("speed", units.SPEED): lambda e: Settings(path_speed=e),
    ("speed", units.SHARE): lambda e: Settings(ptp_speed=e),
    ("speed", units.ANGULAR_SPEED): lambda e: Settings(orientation_speed=e),
    ("acc", units.ACCELERATION): lambda e: Settings(path_acceleration=e),
    ("acc", units.SHARE): lambda e: Settings(ptp_acceleration=e),
}
_BARE = {"speed": units.SPEED, "acc": units.ACCELERATION}
_ALLOWED = {"speed": "a speed (mm/s, deg/s) or a share (%)", "acc": "an acceleration (mm/s2) or a share (%)"}


def gather(body: Body, settings: tuple[Setting, ...]) -> Settings:
    """Return the record of several settings, without `frame`.

    Raises:
        RejectedError: a value has the wrong dimension or is out of range.
    """
    result = Settings()
    for setting in settings:
        if setting.word != "frame":
            one = _one(body, setting)
            for name in one.__dataclass_fields__:
                if getattr(one, name) is not None and getattr(result, name) is not None:
                    body.fail(kinds.ARGUMENTS, setting, f"`{setting.word}` is given twice")
            result = _joined(result, one)
    return result


def check_effect(body: Body, motion: Motion, settings: Settings) -> None:
    """Warn about modifiers that the motion does not use."""
    if motion.word == "mov":
        idle = {"speed": settings.path_speed or settings.orientation_speed, "acc": settings.path_acceleration}
        hint = "give it in %"
    else:
        idle = {"speed": settings.ptp_speed, "acc": settings.ptp_acceleration}
        hint = "give it in mm/s or mm/s2"
    for modifier in motion.modifiers:
        if idle.get(modifier.word) is not None:
            message = f"`{motion.word}` does not use this `{modifier.word}`; it goes without it"
            body.warn(kinds.NO_EFFECT, modifier, message, hint)


def _joined(a: Settings, b: Settings) -> Settings:
    return Settings(
        a.tool or b.tool,
        a.path_speed or b.path_speed,
        a.ptp_speed or b.ptp_speed,
        a.orientation_speed or b.orientation_speed,
        a.path_acceleration or b.path_acceleration,
        a.ptp_acceleration or b.ptp_acceleration,
        a.zone or b.zone,
    )


def _one(body: Body, setting: Setting) -> Settings:
    if setting.word == "tool":
        assert setting.name is not None
        return Settings(tool=body.tool(setting.name))
    if setting.word == "fine":
        return Settings(zone=fold.real(0.0))
    assert setting.value is not None
    if setting.word == "blend":
        zone = values.expect(body, setting.value, LENGTH, "the distance of `blend`")
        _check_range(body, setting, zone, units.LENGTH)
        return Settings(zone=zone)
    value = values.check(body, setting.value)
    dimension = _dimension(body, setting, value)
    expression = convert.to(
        body, value, Type(_REAL, dimension), setting.value, f"the value of `{setting.word}`"
    )
    _check_range(body, setting, expression, dimension)
    plausible.check_rate(body, setting.word, value, expression, dimension, setting.value)
    return _FIELDS[setting.word, dimension](expression)


def _dimension(body: Body, setting: Setting, value: Value) -> units.Dimension:
    assert setting.value is not None
    kind = known(value.type)
    if value.is_bare or not isinstance(kind, Type):
        return _BARE[setting.word]
    if kind.value is not _REAL or (setting.word, kind.dimension) not in _FIELDS:
        message = f"`{setting.word}` needs {_ALLOWED[setting.word]}, found {article(kind)}"
        hint = "write a unit behind the number"
        if kind.dimension != units.NUMBER:
            hint = "its unit is of another sort: write one of those in parentheses"
        body.fail(kinds.WRONG_DIMENSION, setting.value, message, hint)
    return kind.dimension


def _check_range(body: Body, setting: Setting, value: Expression, dimension: units.Dimension) -> None:
    number = fold.number_of(value)
    if number is None:
        return
    found = f"found {number * 100:g} %" if dimension == units.SHARE else f"found {number:g} {_SI[dimension]}"
    if setting.word == "blend":
        if number < 0.0:
            body.fail(kinds.OUT_OF_RANGE, setting, f"`blend` must not be negative, {found}")
    elif number <= 0.0:
        body.fail(kinds.OUT_OF_RANGE, setting, f"`{setting.word}` must be greater than zero, {found}")
    elif dimension == units.SHARE and number > 1.0:
        message = f"`{setting.word}` is {number * 100:g} %, at most 100 % is allowed"
        body.fail(kinds.OUT_OF_RANGE, setting, message, "the share counts from the limits of the joints")


_SI = {
    units.LENGTH: "m",
    units.SPEED: "m/s",
    units.ACCELERATION: "m/s²",
    units.ANGULAR_SPEED: "rad/s",
    units.ANGULAR_ACCELERATION: "rad/s²",
}
