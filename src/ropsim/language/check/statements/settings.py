"""Speeds, accelerations, blends and tools: settings of one move, of a block, or until further notice."""

from functools import lru_cache
from typing import Any

from ropsim.language.check.doubts import metres, numerals, plausible
from ropsim.language.check.expressions import convert, values
from ropsim.language.check.scope import fold, units
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import LENGTH, Type, Value, article, known, real
from ropsim.language.findings import types as kinds
from ropsim.language.syntax.nodes import Number
from ropsim.language.syntax.statements import Motion, Setting
from ropsim.program import Expression, Settings, ValueType

_REAL = ValueType.REAL
_FIELDS = {
    ("speed", units.SPEED): "path_speed",
    ("speed", units.SHARE): "ptp_speed",
    ("speed", units.ANGULAR_SPEED): "orientation_speed",
    ("acc", units.ACCELERATION): "path_acceleration",
    ("acc", units.SHARE): "ptp_acceleration",
}
"""Which value of a move a setting is, by its word and dimension."""
_BARE = {"speed": real(units.SPEED), "acc": real(units.ACCELERATION)}
_WHAT = {"speed": "the value of `speed`", "acc": "the value of `acc`"}
_ELSEWHERE = ("frame", "angle")
"""Words of settings that are no value of a move."""
_NOTHING = Settings()
_LEAST, _MOST = 5.0, 100.0
"""A bare number between these is taken for a share where one is meant [%]."""
_OF_TOOL = {"speed": "speed 200 mm/s", "acc": "acc 1000 mm/s2"}
_ALLOWED = {"speed": "a speed or a share", "acc": "an acceleration or a share"}
_UNITS = {"speed": "`mm/s`, `deg/s` or `%`", "acc": "`mm/s2` or `%`"}


def gather(
    body: Body, settings: tuple[Setting, ...], doubt: plausible.Doubt = plausible.check_rate
) -> Settings:
    """Return the record of several settings, without `frame` and `angle`.

    Args:
        body: where they stand.
        settings: of a motion, a block, or until further notice.
        doubt: warns of speeds and accelerations.

    Raises:
        RejectedError: a value has the wrong dimension or is out of range.
    """
    if not settings:
        return _NOTHING
    chosen: dict[str, Any] = {}
    elsewhere: set[str] = set()
    for setting in settings:
        name, value = (setting.word, None) if setting.word in _ELSEWHERE else _one(body, setting, doubt)
        if name in chosen or name in elsewhere:
            words = [one.word for one in settings]
            message = f"`{setting.word}` is given twice"
            if words.count(setting.word) == 1 and name == "zone":
                message = "`fine` and `blend` exclude each other"
            body.fail(kinds.ARGUMENTS, setting, message, "leave one of them out")
        if value is None:
            elsewhere.add(name)
        else:
            chosen[name] = value
    return Settings(**chosen)


def of_motion(body: Body, motion: Motion) -> Settings:
    """Return the record of the modifiers of a motion, and warn about modifiers that it does not use (T309).

    Raises:
        RejectedError: a value has the wrong dimension or is out of range.
    """
    if not motion.modifiers:
        return _NOTHING
    if motion.word == "mov":
        found = gather(body, motion.modifiers, plausible.believe)
        idle = {"speed": found.path_speed or found.orientation_speed, "acc": found.path_acceleration}
        of_other = _share
    else:
        found = gather(body, motion.modifiers, plausible.check_path_rate)
        idle = {"speed": found.ptp_speed, "acc": found.ptp_acceleration}
        of_other = _of_path
    for modifier in motion.modifiers:
        if idle.get(modifier.word) is not None:
            message = f"`{motion.word}` does not use this `{modifier.word}`; it goes without it"
            hint, fix = of_other(modifier)
            body.warn(kinds.NO_EFFECT, modifier, message, hint, fix)
    return found


def _share(setting: Setting) -> tuple[str, str | None]:
    """Return hint and fix for a speed or acceleration that is no share where one is meant."""
    number = setting.value.value if isinstance(setting.value, Number) and not setting.value.unit else None
    if number is None or not (number <= 1.0 or _LEAST <= number <= _MOST):
        return f"give it in %: `{setting.word} 30 %`", None
    text = f"{setting.word} {number * 100 if number <= 1.0 else number:g} %"
    return f"write `{text}`", text


def _of_path(setting: Setting) -> tuple[str, None]:
    """Return hint and fix for a share where a speed or acceleration of the tool is meant."""
    return f"give it in mm/s or mm/s2: `{_OF_TOOL[setting.word]}`", None


def _one(body: Body, setting: Setting, doubt: plausible.Doubt) -> tuple[str, Expression | str]:
    """Return which value of a move a setting is, and the value."""
    if setting.word == "tool":
        assert setting.name is not None
        return "tool", body.tool(setting.name)
    if setting.word == "fine":
        return "zone", fold.real(0.0)
    assert setting.value is not None
    if isinstance(setting.value, Number) and setting.value.unit:
        known = _measured(setting.word, setting.value.value, setting.value.unit)
        if known is not None:
            return known
    if setting.word == "blend":
        zone = values.expect(body, setting.value, LENGTH, "the distance of `blend`")
        _check_range(body, setting, zone, units.LENGTH)
        metres.check_length(body, setting.word, setting.value, setting.value)
        return "zone", zone
    value = values.check(body, setting.value)
    wanted = _wanted(body, setting, value)
    dimension = wanted.dimension
    expression = convert.to(body, value, wanted, setting.value, _WHAT[setting.word])
    _check_range(body, setting, expression, dimension)
    doubt(body, setting.word, value, expression, dimension, setting.value)
    return _FIELDS[setting.word, dimension], expression


@lru_cache(maxsize=1024)
def _measured(word: str, number: float, unit: str) -> tuple[str, Expression] | None:
    """Return the same of a number in its unit; None where there is something to say about it."""
    dimension, factor = units.UNITS[unit]
    name, value = _FIELDS.get((word, dimension)), number * factor
    most = 1.0 if dimension == units.SHARE else plausible.FASTEST
    return (name, fold.real(value)) if name is not None and 0.0 < value <= most else None


def _wanted(body: Body, setting: Setting, value: Value) -> Type:
    """Return the type that the value of a setting is taken for.

    Raises:
        RejectedError: the setting is unknown.
    """
    assert setting.value is not None
    kind = known(value.type)
    if value.is_bare or not isinstance(kind, Type):
        return _BARE[setting.word]
    if kind.value is not _REAL or (setting.word, kind.dimension) not in _FIELDS:
        message = f"`{setting.word}` needs {_ALLOWED[setting.word]}, found {article(kind)}"
        hint = f"give the value in {_UNITS[setting.word]}"
        body.fail(kinds.WRONG_DIMENSION, setting.value, message, hint)
    return kind


def _check_range(body: Body, setting: Setting, value: Expression, dimension: units.Dimension) -> None:
    number = fold.number_of(value)
    if number is None:
        return
    if setting.word == "blend":
        if number < 0.0:
            message = f"`blend` must not be negative, found {_quoted(body, setting, number, dimension)}"
            body.fail(kinds.OUT_OF_RANGE, setting, message)
    elif number <= 0.0:
        found = _quoted(body, setting, number, dimension)
        message = f"`{setting.word}` must be greater than zero, found {found}"
        body.fail(kinds.OUT_OF_RANGE, setting, message)
    elif dimension == units.SHARE and number > 1.0:
        found = _quoted(body, setting, number, dimension)
        message = f"`{setting.word}` is {found}, at most 100 % is allowed"
        body.fail(kinds.OUT_OF_RANGE, setting, message, "the share counts from the limits of the joints")


def _quoted(body: Body, setting: Setting, number: float, dimension: units.Dimension) -> str:
    place = setting.value or setting
    if dimension == units.SHARE:
        return numerals.quoted(body, place, number * 100.0, "%")
    return numerals.quoted(body, place, number, _SI[dimension])


_SI = {
    units.LENGTH: "m",
    units.SPEED: "m/s",
    units.ACCELERATION: "m/s²",
    units.ANGULAR_SPEED: "rad/s",
    units.ANGULAR_ACCELERATION: "rad/s²",
}
