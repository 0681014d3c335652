"""Loops and branches that never run, as constant expressions show before the run."""

import re

from ropsim.language.check.doubts import numerals
from ropsim.language.check.scope import fold
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import Value
from ropsim.language.check.statements.silent import words_of
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.program import Binary, Constant, Expression

_WORD = re.compile(r"-?[\w.]+")
_DIGITS = re.compile(r"[\d.]+(?:[eE][+-]?\d+)?")
_AROUND_POINT = re.compile(r"\s*\.\s*|(?<=^-)\s+")
_DO = re.compile(r"\s+do$", re.IGNORECASE)
"""The word that may end a `for`."""


def check_count(body: Body, node: syntax.Repeat, count: Expression | None) -> None:
    """Warn of a `repeat` whose count is known and less than 1, and names no constant, a switch (T341)."""
    number = fold.number_of(count) if count is not None else None
    if node.count is None or number is None or number >= 1:
        return
    if _names_constant(body, body.written(node.count)):
        return
    message = f"the lines of this loop never run, its count is `{number:g}`"
    body.warn(kinds.NEVER_RUN, node, message, "write a count of at least 1, or leave the loop out")


def check_condition(body: Body, node: syntax.Statement, condition: nodes.Node, found: Expression) -> None:
    """Warn of a `while`, `if` or `elseif` whose condition is always false (T341)."""
    if not _is_always(body, condition, found, fold.FALSE):
        return
    word = body.line.head
    lines = "its lines never run" if isinstance(node, syntax.While) else "what it leads to never runs"
    message = f"the condition of `{word}` is always false: {lines}"
    hint = "write a condition that may come true, or put `#` before what is not to run"
    body.warn(kinds.NEVER_RUN, node, message, hint)


def is_always_true(body: Body, condition: nodes.Node, found: Expression) -> bool:
    """Return whether no branch behind one with this condition runs."""
    return _is_always(body, condition, found, fold.TRUE)


def check_other(body: Body, node: syntax.Statement) -> None:
    """Warn of a branch behind one whose condition is always true (T341)."""
    message = f"the condition above is always true: what `{body.line.head}` leads to never runs"
    body.warn(kinds.NEVER_RUN, node, message, "write a condition that may be false, or leave this branch out")


def check_way(body: Body, node: syntax.For, first: Expression, last: Expression, step: Expression) -> None:
    """Warn of a `for` whose last value lies behind the first one, seen along its step (T341)."""
    start, end, way = fold.number_of(first), fold.number_of(last), fold.number_of(step)
    if start is None or end is None or not way or (end - start) * way >= 0:
        return
    if body.line.fault is not None:
        return  # that finding names the intended statement
    limits = _shown(body, node.first), _shown(body, node.last)
    values = f"`{limits[0]} to {limits[1]}`" if all(limits) else "from the first value to the last one it"
    message = f"the lines of this loop never run: {values} counts "
    message += f"{'down' if way > 0 else 'up'}, and its step counts {'up' if way > 0 else 'down'}"
    turned, fix = _turned(body, node), None
    if not turned:
        hint = "turn the sign of the step"
    elif any(_names_constant(body, body.written(limit)) for limit in (node.first, node.last)):
        hint = f"give the constant another value, or write `step {turned}` for the other way"
    elif way > 0:
        hint = f"write `step {turned}`"
        is_plain = all(numerals.is_alone(limit) for limit in (node.first, node.last))
        fix = _with_step(body, node, turned) if is_plain else None
    elif all(limits) and node.step is not None:
        other = f"for {node.name.text} = {limits[1]} to {limits[0]} step {body.written(node.step)}"
        hint = f"write `{other}`, or `step {turned}`"
    else:
        hint = f"write the values the other way round, or `step {turned}`"
    body.warn(kinds.NEVER_RUN, node, message, hint, fix)


def _shown(body: Body, node: nodes.Node) -> str:
    """Return a value as written, if it is one word or a number with a unit; else an empty text.

    It does not depend on the blanks that are written.
    """
    match node:
        case nodes.Number(unit=unit):
            digits = _DIGITS.match(body.written(node))
            return " ".join(filter(None, (digits[0], unit))) if digits else ""
        case nodes.Unary(op="neg", operand=nodes.Number() as number):
            return f"-{_shown(body, number)}"
    written = _AROUND_POINT.sub(lambda found: found[0].strip(), body.written(node))
    return written if _WORD.fullmatch(written) else ""


def _is_always(body: Body, condition: nodes.Node, found: Expression, truth: Constant) -> bool:
    """Return whether a condition has a constant value.

    One that names a constant of the text is a switch, which is there to be off now and then.
    """
    return _is(found, truth) and not _names_constant(body, body.written(condition))


def _is(found: Expression, truth: Constant) -> bool:
    """Return whether a condition has this value for all values of signals and variables."""
    match found:
        case Constant(value=value):
            return value is truth.value
        case Binary(op="and" | "or" as op, left=left, right=right):
            one_is_enough = (op == "or") is truth.value
            return (any if one_is_enough else all)(_is(side, truth) for side in (left, right))
    return False


def _names_constant(body: Body, written: str) -> bool:
    return any(isinstance(body.find(word), Value) for word in words_of(written))


def _with_step(body: Body, node: syntax.For, step: str) -> str:
    """Return the line of a loop with another step."""
    line = body.written(node)
    if node.step is not None:
        return line[: node.step.start - node.start] + step + line[node.step.end - node.start :]
    end = _DO.search(line)
    return f"{line[: end.start()]} step {step}{end[0]}" if end else f"{line} step {step}"


def _turned(body: Body, node: syntax.For) -> str:
    """Return the step with the other sign as written, empty if it is not a single number."""
    match node.step:
        case None:
            return "-1"
        case nodes.Number() as number:
            return f"-{body.written(number)}"
        case nodes.Unary(op="neg", operand=nodes.Number() as number):
            return body.written(number)
    return ""
