"""Whole lines of other robot languages, where they are simple, in the words of this one."""

import re
from collections.abc import Callable, Mapping, Sequence
from functools import partial

from ropsim.language.check.scope.body import Body
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.other_settings import of_letter
from ropsim.program import SignalUse, ValueType

_SPEED, _ZONE = re.compile(r"v(\d+)"), re.compile(r"z(\d+)")
_TIMES = ("", "s", "ms", "min")

Values = Sequence[nodes.Node]


def translated(body: Body, node: syntax.Call) -> str | None:
    """Return a line translated to this language; None for unknown words and for incomplete lines."""
    write = _LINES.get(node.name.text.lower())
    if write is None or not _is_statement(body, node):
        return None
    items = node.arguments
    inside = items[0].value if len(items) == 1 else None
    if isinstance(inside, nodes.Tuple) and inside.start == node.name.end:
        items = inside.items
    plain = [item.value for item in items if item.name is None]
    named = [(item.name.text, item.value) for item in items if item.name is not None]
    if not named:
        return write(body, plain)
    verb = _VERBS.get(node.name.text.lower())
    return _move_with_letters(verb, body, plain, named) if verb else None


def _is_statement(body: Body, node: syntax.Call) -> bool:
    """Return whether a call is all of its line, or all of the statement behind `then`."""
    statement: object = body.line.statement
    while isinstance(statement, syntax.If):
        statement = statement.body
    return statement is node


def _setting(word: str, body: Body, values: Values) -> str | None:
    match values:
        case [nodes.Number() as number]:
            return f"set {word} {body.written(number)}"
    return None


def _pause(bare: str, body: Body, values: Values) -> str | None:
    """Return a wait; `bare` is the unit of a number without one, empty where languages differ."""
    match values:
        case [nodes.Number(unit=unit) as number] if unit in _TIMES and (unit or bare):
            return f"wait {body.written(number)}{'' if unit else f' {bare}'}"
    return None


def _output(body: Body, values: Values) -> str | None:
    match values:
        case [nodes.Name(text=name), nodes.Number(value=0.0 | 1.0, unit="") as level]:
            return _switched(body, name, "on" if level.value else "off")
    return None


def _reset(body: Body, values: Values) -> str | None:
    match values:
        case [nodes.Name(text=name)]:
            return _switched(body, name, "off")
    return None


def _switched(body: Body, name: str, level: str) -> str | None:
    signal = _signal(body, name)
    return f"set {name} {level}" if signal is not None and not signal.is_input else None


def _input(body: Body, values: Values) -> str | None:
    match values:
        case [nodes.Name(text=name)] if _signal(body, name) is not None:
            return f"wait until {name}"
        case [nodes.Name(text=name), nodes.Number(value=0.0 | 1.0, unit="") as level]:
            return f"wait until {'' if level.value else 'not '}{name}" if _signal(body, name) else None
    return None


def _signal(body: Body, name: str) -> SignalUse | None:
    symbol = body.find(name)
    return symbol if isinstance(symbol, SignalUse) and symbol.type is ValueType.BOOL else None


def _move(verb: str, body: Body, values: Values) -> str | None:
    """Return a motion with its speed, zone and tool; a speed says nothing of the joints of `mov`."""
    if len(values) < 2 or not all(isinstance(one, nodes.Name) for one in values[1:]):
        return None
    words = [_word(body, verb, body.written(one)) for one in values[1:]]
    return " ".join((verb, body.written(values[0]), *words)) if all(words) else None


def _move_with_letters(
    verb: str, body: Body, values: Values, named: Sequence[tuple[str, nodes.Node]]
) -> str | None:
    """Return a motion of URScript, `movel(p, a=1.2, v=0.15)`."""
    words = [
        of_letter(verb, name, body.written(one)) if isinstance(one, nodes.Number) else ""
        for name, one in named
    ]
    return " ".join((verb, body.written(values[0]), *words)) if len(values) == 1 and all(words) else None


def _word(body: Body, verb: str, text: str) -> str:
    """Return the translation of a word behind the target of a motion of RAPID; empty if there is none."""
    speed, zone = _SPEED.fullmatch(text), _ZONE.fullmatch(text)
    if speed is not None:
        return f"speed {speed[1]} mm/s" if verb == "lin" else ""
    if zone is not None:
        return f"blend {zone[1]} mm"
    return "fine" if text == "fine" else f"tool {text}" if text in body.world.tools else ""


def _stop(_: Body, values: Values) -> str | None:
    return None if values else "stop"


def _exit(body: Body, values: Values) -> str | None:
    """Return the way out of a loop; outside of one the end of the program, None in a task."""
    if values or (body.task and not body.loops):
        return None
    return "break" if body.loops else "stop"


_VERBS = {
    **dict.fromkeys(("movel", "moves", "slin", "movep"), "lin"),
    **dict.fromkeys(("movej", "ptp", "sptp"), "mov"),
}
"""Motions with one target, and their equivalents here."""

_LINES: Mapping[str, Callable[[Body, Values], str | None]] = {
    **{word: partial(_move, verb) for word, verb in _VERBS.items()},
    "setdo": _output,
    "set_digital_out": _output,
    "set_standard_digital_out": _output,
    "reset": _reset,
    "waitdi": _input,
    "waituntil": _input,
    "waittime": partial(_pause, "s"),
    "sleep": partial(_pause, "s"),
    "delay": partial(_pause, ""),
    "pause": partial(_pause, ""),
    "halt": _stop,
    "exit": _exit,
    "quit": _stop,
    "speed": partial(_setting, "speed"),
    "vel": partial(_setting, "speed"),
    "acc": partial(_setting, "acc"),
    "accel": partial(_setting, "acc"),
    "blend": partial(_setting, "blend"),
    "zone": partial(_setting, "blend"),
}
