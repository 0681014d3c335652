"""Values that other languages write differently, and their equivalents here."""

import re
from collections.abc import Sequence
from typing import NoReturn

from ropsim.language.check.scope.body import Body
from ropsim.language.findings import names as kinds
from ropsim.language.report import OffsetRange
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.other_languages import LEVELS
from ropsim.language.syntax.other_settings import data, shared
from ropsim.program import SignalUse, ValueType

_SHIFTS = {"offs": "offset", "reltool": "rel", "pose_add": "offset"}
"""Functions of a location and three lengths, and the operators that they are here."""
_COMPOSED = ("pose_trans",)
_POSES = ("crobt", "cpos", "get_actual_tcp_pose", "get_target_tcp_pose")
"""Functions that return the pose or joints of the arm."""
_STEPS = {
    "offset": "a location is shifted by `offset`: `p offset (0, 0, 60)`",
    "rel": "a step in the axes of the tool is written `rel`: `p rel (0, 0, 60)`",
}
_RATE = re.compile(r"(?<![\w.])(\d+(?:\.\d+)?)[ \t]*(mm|cm|m|deg|rad)[ \t]*/[ \t]*$", re.ASCII)
_SECONDS = ("s", "sec", "secs", "second", "seconds")
_MINUTES = ("min", "minute", "minutes")


def refuse_function(body: Body, node: nodes.Function) -> None:
    """Report a function of another language.

    Raises:
        RejectedError: it is one.
    """
    word = node.name.text.lower()
    message = f"there is no function `{node.name.text}`"
    if word in _POSES:
        body.fail(
            kinds.UNKNOWN_FUNCTION, node, message, "where the arm is, is `here`: write `here`", fix="here"
        )
    operator = _SHIFTS.get(word, "rel" if word in _COMPOSED else "")
    if not operator:
        return
    values = [one.value for one in node.arguments]
    fix = _composed(body, values) if word in _COMPOSED else _shifted(body, operator, values)
    if fix:
        body.fail(kinds.UNKNOWN_FUNCTION, node, message, f"write `{fix}`", fix=fix)
    body.fail(kinds.UNKNOWN_FUNCTION, node.name, message, _STEPS[operator])


def _shifted(body: Body, operator: str, values: Sequence[nodes.Node]) -> str:
    """Return a location and three lengths as written here; empty if incomplete."""
    written = [body.written(one) for one in values]
    if len(written) != 4 or not all(map(_is_balanced, written)):
        return ""
    return f"{written[0]} {operator} ({', '.join(written[1:])})"


def _composed(body: Body, values: Sequence[nodes.Node]) -> str:
    """Return two poses, the second one in the first, as written here; empty for other values."""
    written = [body.written(one) for one in values]
    if len(written) != 2 or not all(map(_is_balanced, written)) or _is_frame(body, values[1]):
        return ""
    first, second = written
    if _is_frame(body, values[0]):
        return f"{second} in {first}"
    is_whole = isinstance(values[1], nodes.Name | nodes.Tuple | nodes.Literal)
    return f"{first} rel {second if is_whole else f'({second})'}"


def _is_frame(body: Body, node: nodes.Node) -> bool:
    return isinstance(node, nodes.Name) and (node.text == "base" or node.text in body.world.frames)


def refuse_name(body: Body, node: nodes.Name) -> None:
    """Report a name that means nothing as a value here, and something else in other languages or places.

    Raises:
        RejectedError: it is one.
    """
    message = f"there is no name `{node.text}`"
    if text := data(node.text):
        setting, _, value = text.partition(" ")
        if share := _share(body, setting):
            body.fail(kinds.UNKNOWN_NAME, node, message, share)
        is_behind = body.line.logical.text[: node.start].rstrip().lower().endswith(setting)
        body.fail(kinds.UNKNOWN_NAME, node, message, f"write `{text}`", fix=value if is_behind else None)
    if node.text.lower() in ("high", "low"):
        level = LEVELS[node.text.lower()]
        body.fail(kinds.UNKNOWN_NAME, node, message, f"write `{level}`", fix=level)
    _refuse_rate(body, node)
    if _is_frame(body, node):
        fix: str | None = f"(0, 0, 0) in {node.text}"
        message, hint = f"`{node.text}` is a frame, no value", f"a location in it is written `{fix}`"
        if body.line.logical.text[node.end : node.end + 1] == ".":
            fix = None
        body.fail(kinds.UNKNOWN_NAME, node, message, hint, fix=fix)
    if node.text in body.world.tools:
        message, hint = f"`{node.text}` is a tool, no value", f"it stands behind `tool`: `tool {node.text}`"
        body.fail(kinds.UNKNOWN_NAME, node, message, hint)


def _share(body: Body, setting: str) -> str:
    """Return the replacement in a motion of the joints, whose speed is a share; empty elsewhere."""
    statement: object = body.line.statement
    while isinstance(statement, syntax.If):
        statement = statement.body
    return shared(statement.word, setting) if isinstance(statement, syntax.Motion) else ""


def _refuse_rate(body: Body, node: nodes.Name) -> None:
    """Report a unit of speed that is written with blanks, with a long word or for minutes."""
    found = _RATE.search(body.line.logical.text[: node.start])
    word = node.text.lower()
    if found is None or word not in (*_SECONDS, *_MINUTES):
        return
    place, said = OffsetRange(found.start(), node.end), body.line.logical.text[found.start() : node.end]
    message = (
        f"there is no unit `{found[2]}/{node.text}`" if word != "s" else f"there is no name `{node.text}`"
    )
    if word in _SECONDS:
        fix = f"{found[1]} {found[2]}/s"
        hint = f"a unit is written without blanks: `{fix}`" if word == "s" else f"write `{fix}`"
        body.fail(kinds.UNKNOWN_NAME, place, message, hint, fix=fix)
    hint = f"speeds are per second: `{said}` is `{float(found[1]) / 60:.6g} {found[2]}/s`"
    body.fail(kinds.UNKNOWN_NAME, place, message, hint)


def refuse_assignment(body: Body, node: syntax.Assign) -> NoReturn:
    """Report an output that is given a value like a variable.

    Raises:
        RejectedError: always.
    """
    name, value = node.name.text, node.value
    message = f"`{name}` cannot be assigned: it is an output, which `set` sets"
    signal = body.find(name)
    is_digital = not isinstance(signal, SignalUse) or signal.type is ValueType.BOOL
    fix = f"set {name} = {body.line.logical.text[value.start : node.end]}"
    if level := _level(body, value):
        fix = f"set {name} {level}" if is_digital else ""
    elif isinstance(value, nodes.Number) and is_digital:
        levels = {0.0: "off", 1.0: "on"}
        fix = f"set {name} {levels[value.value]}" if value.value in levels and not value.unit else ""
    elif isinstance(value, nodes.Number) and value.unit:
        fix = ""
    hint = f"write `{fix}`" if fix else f"write `set {name} on`" if is_digital else f"write `set {name} = 1`"
    body.fail(kinds.NOT_ASSIGNABLE, node, message, hint, fix=fix or None)


def is_unlike(body: Body, value: nodes.Node) -> bool:
    """Return whether a value is the level of an output in another language."""
    return isinstance(value, nodes.Name) and bool(_level(body, value))


def _level(body: Body, value: nodes.Node) -> str:
    """Return the level of a digital output that a value is; empty for none."""
    if isinstance(value, nodes.Literal) and value.word in ("on", "off", "true", "false"):
        return "on" if value.word in ("on", "true") else "off"
    if isinstance(value, nodes.Name) and body.find(value.text) is None:
        return LEVELS.get(value.text.lower(), "")
    return ""


def _is_balanced(text: str) -> bool:
    return text.count("(") == text.count(")")
