"""Calls: arguments to parameters, by place, by name and by the number of a reference location."""

from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import partial
from typing import NoReturn

from ropsim.core import TextEdit, did_you_mean, edit_distance, near
from ropsim.language.check.calls.foreign_lines import translated
from ropsim.language.check.doubts import facing
from ropsim.language.check.expressions import components, convert, poses, readings, values
from ropsim.language.check.scope.body import Body, RejectedError
from ropsim.language.check.scope.types import POSE, Value, known
from ropsim.language.check.scope.world import Formal, Signature
from ropsim.language.findings import hidden as hidden_kinds
from ropsim.language.findings import names as name_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.line import parse_line
from ropsim.language.syntax.other_languages import HINTS
from ropsim.language.syntax.words import SETTINGS, VERBS
from ropsim.program import Call, Expression
from ropsim.program import Variable as VariableExpression


def call(body: Body, node: syntax.Call) -> Call:
    """Return a call.

    Raises:
        RejectedError: the task is unknown or the arguments do not fit.
    """
    signature = body.world.signatures.get(node.name.text)
    if signature is None:
        unknown_task(body, node)
    _check_case(body, node)
    if not signature.is_known:
        raise RejectedError
    if body.world.is_classic:
        items = spread(node.arguments, signature, lambda name: _is_location(body, name))
    else:
        items = listed(body, node)
    bound = _bind(body, node, signature, items)
    arguments = tuple(_argument(body, signature, formal, bound) for formal in signature.formals)
    return Call(signature.name, arguments, body.statement_span)


def _check_case(body: Body, node: syntax.Call) -> None:
    """Warn of a call where another task has the same name in another case (N217).

    A task of the text may have the name of one of the library: who writes it means it.
    """
    name, own = node.name.text, body.world.own
    is_own = name in own
    alike = body.world.alike.get(name.lower(), ())
    other = next((one for one in alike if one != name and (one in own or not is_own)), None)
    if other is None:
        return
    if is_own or other not in own:
        where = "this text" if is_own else "the library"
        message = f"the tasks `{name}` and `{other}` of {where} differ by upper and lower case only"
        body.warn(hidden_kinds.OTHER_CASE, node.name, message, "rename one of them")
        return
    message = f"`{name}` is a task of the library, and this text has a task `{other}`"
    hint = f"write `{other}` where the task of the text is meant, or give that one another name"
    body.warn(hidden_kinds.OTHER_CASE, node.name, message, hint, fix=other)


def as_call(node: nodes.Function, signature: Signature) -> syntax.Call:
    """Return the call of a task whose result is assigned, `v = T(…)`, as a statement of its own.

    A parenthesis that touches the name is the list of its arguments if their number fits; else it has its
    meaning in a statement.
    """
    items = node.arguments
    is_apart = node.opening > node.name.end
    is_one = len(items) == 1 and items[0].name is None
    if not is_one and (is_apart or len(items) > len(signature.formals)):
        items = (nodes.Item(None, nodes.Tuple(items, (), None, node.opening, node.end)),)
    return syntax.Call(node.name, items, -1 if is_apart else node.end, node.start, node.end)


def with_result(statement: Call, variable: str) -> Call:
    """Return the call with its result going to a variable."""
    return replace(statement, result=variable)


def unknown_task(body: Body, node: syntax.Call) -> NoReturn:
    """Report that a task is not defined, in the words of paper 1.

    Raises:
        RejectedError: always.
    """
    if body.report.muted:  # without a reader the search for near names is skipped
        raise RejectedError
    name, environment = node.name, body.world.environment
    reason = environment.refused.get(name.text)
    if reason is not None:
        message = f"the task `{name.text}` of the knowledge base cannot be called: {reason}"
        body.fail(name_kinds.REFUSED_TASK, name, message, "put the task right in its text")
    hint = _near_task(body, node, (*body.world.signatures, *environment.listed))
    message = f"Task not defined: `{name.text}`"
    line = translated(body, node) if hint == HINTS.get(name.text.lower()) else None
    if line is not None:
        span = partial(body.line.logical.span, body.report.source)
        edit = TextEdit(span(node.start, node.end), line)
        place = span(name.start, name.end)
        body.reject(name_kinds.UNKNOWN_TASK.at(place, message, hint=hint, fix=edit))
    fix = hint.split("`")[1] if hint.startswith("did you mean") else None
    is_foreign = hint == HINTS.get(name.text.lower())
    if fix is not None and ((is_foreign and not _is_bare(node)) or not _can_be_read(body, name, fix)):
        fix = None
    body.fail(name_kinds.UNKNOWN_TASK, name, message, hint, fix=fix)


def _near_task(body: Body, node: syntax.Call, tasks: Iterable[str]) -> str:
    """Return the probable intended task; a word of another robot language is translated, not guessed."""
    name, word = node.name, node.name.text.lower()
    if word in HINTS and word not in map(str.lower, tasks):
        return HINTS[word]
    others = (task for task in tasks if task != name.text)
    fitting = [task for task in near(name.text, others) if _may_take(body, node, task)][:1]
    verbs = [verb for verb in near(name.text, VERBS, limit=1) if _can_be_read(body, name, verb)]
    settings = [f"set {one}" for one in near(name.text, SETTINGS, limit=1)]
    settings = [one for one in settings if _can_be_read(body, name, one)]
    nearest = min(
        (*fitting, *verbs, *settings),
        key=lambda one: edit_distance(word, one.lower().removeprefix("set ")),
        default="",
    )
    if nearest:
        return f"did you mean `{nearest}`?"
    return "define it with `task`, or assign a variable with `=`"


def _is_bare(node: syntax.Call) -> bool:
    """Return whether a single value follows a word, with or without parentheses."""
    if len(node.arguments) != 1 or node.arguments[0].name is not None:
        return False
    inside = _only(node.arguments)
    if inside is None or not inside.items:
        return True
    first = inside.items[0].value
    return not (
        isinstance(first, nodes.Name | nodes.Function)
        or _is_place(first)
        or any(item.name is not None for item in inside.items)
    )


def _may_take(body: Body, node: syntax.Call, task: str) -> bool:
    """Return whether a task may take as many arguments as a call has."""
    signature = body.world.signatures.get(task)
    if signature is None or not signature.is_known:
        return True
    needed, most = _counts(signature)
    inside = _only(node.arguments)
    counts = {len(node.arguments), len(inside.items) if inside is not None else len(node.arguments)}
    return any(needed <= count <= most for count in counts)


def _can_be_read(body: Body, name: nodes.Name, word: str) -> bool:
    """Return whether the line with another word for a name is a statement."""
    text = body.line.logical.text
    return parse_line(text[: name.start] + word + text[name.end :])[1] is None


_COORDINATES = (3, 5, 6)
"""Parts of a parenthesis that is a location."""


def listed(body: Body, node: syntax.Call) -> tuple[nodes.Item, ...]:
    """Return the arguments of a call in a modern text: a parenthesis that touches the name is their list.

    Raises:
        RejectedError: behind a blank stands a parenthesis that is no value, or something behind the list.
    """
    if 0 <= node.closing < node.end:
        opening = replace(node.name, end=node.name.end + 1)
        message = "nothing follows the list of the arguments, a parenthesis that touches the name of a task"
        hint = f"behind a blank it is one value: `{node.name.text} (…) …`"
        body.fail(kinds.ARGUMENTS, opening, message, hint, fix=f"{node.name.text} (")
    inside = _only(node.arguments)
    if inside is None or not _is_apart(node):
        return node.arguments if inside is None else inside.items
    if len(inside.items) in _COORDINATES and not any(item.name for item in inside.items):
        return node.arguments
    opening = replace(node.name, end=inside.start + 1)
    message = "a parenthesis behind a blank is one value, and this one is none"
    hint = "without the blank it is the list of the arguments"
    body.fail(kinds.ARGUMENTS, opening, message, hint, fix=f"{node.name.text}(")


def _only(arguments: tuple[nodes.Item, ...]) -> nodes.Tuple | None:
    """Return the parenthesis that is all of the arguments, None where it is not."""
    if len(arguments) != 1 or arguments[0].name is not None:
        return None
    value = arguments[0].value
    return value if isinstance(value, nodes.Tuple) and not value.turns else None


def _is_apart(node: syntax.Call) -> bool:
    """Return whether a blank stands between the name of a task and its first argument."""
    return node.arguments[0].value.start > node.name.end


def spread(
    arguments: tuple[nodes.Item, ...], signature: Signature, is_location: Callable[[nodes.Name], bool]
) -> tuple[nodes.Item, ...]:
    """Return the arguments of a call in a classic text, with a parenthesis around them all taken away.

    One parenthesis with three, five or six numbers is one location where the task starts with a location,
    as in `call grip (x, y, z)`; any other single parenthesis is an argument list.
    """
    only = _only(arguments)
    if only is None:
        return arguments
    starts_with_location = bool(signature.formals) and known(signature.formals[0].type) == POSE
    first = only.items[0] if only.items else None
    is_list = (
        not starts_with_location
        or len(only.items) not in _COORDINATES
        or any(i.name is not None for i in only.items)
        or (first is not None and isinstance(first.value, nodes.Name) and is_location(first.value))
        or (first is not None and _is_place(first.value))
    )
    return only.items if is_list else arguments


def _is_place(node: nodes.Node) -> bool:
    """Return whether an expression is a location for certain, and so no number of one."""
    if isinstance(node, nodes.Binary):
        return node.op in ("above", "offset", "rel")
    if isinstance(node, nodes.Literal):
        return node.word == "here"
    return isinstance(node, nodes.Tuple | nodes.Rebase | nodes.External | nodes.Free)


def _bind(
    body: Body, node: syntax.Call, signature: Signature, items: tuple[nodes.Item, ...]
) -> dict[str, nodes.Node]:
    """Return the arguments by parameter."""
    names = [formal.name for formal in signature.formals]
    bound: dict[str, nodes.Node] = {}
    for index, item in enumerate(items):
        if item.name is None:
            if index >= len(names):
                _wrong_count(body, node, signature, len(items))
            name = names[index]
        else:
            name = item.name.text
            if name not in names:
                hint = did_you_mean(name, names) or _parameters(signature)
                body.fail(
                    kinds.ARGUMENTS, item.name, f"task `{signature.name}` has no parameter `{name}`", hint
                )
        if name in bound and item.name is None:
            _refuse_order(body, node, items)
        if name in bound:
            body.fail(kinds.ARGUMENTS, item.name or item.value, f"parameter `{name}` is given twice")
        bound[name] = item.value
    if any(f.default is None and f.name not in bound for f in signature.formals):
        _wrong_count(body, node, signature, len(items))
    return bound


def _refuse_order(body: Body, node: syntax.Call, items: tuple[nodes.Item, ...]) -> NoReturn:
    """Report an argument by place behind one by name whose place it takes.

    Raises:
        RejectedError: always.
    """
    text = body.line.logical.text
    placed = [text[one.value.start : one.value.end] for one in items if one.name is None]
    named = [text[one.name.start : one.value.end] for one in items if one.name is not None]
    written = ", ".join((*placed, *named))
    hint, fix = "write the arguments by place first, those by name behind them", None
    if written.count("(") == written.count(")"):
        hint, fix = f"{hint}: `{node.name.text} {written}`", f"{node.name.text} {written}"
    place = replace(node.name, end=node.end)
    body.fail(kinds.ARGUMENTS, place, "an argument by place stands behind one by name", hint, fix=fix)


def _wrong_count(body: Body, node: syntax.Call, signature: Signature, found: int) -> NoReturn:
    needed, most = _counts(signature)
    allowed = str(most) if needed == most else f"{needed} to {most}"
    message = (
        f"task `{signature.name}` takes {allowed} argument{'' if allowed == '1' else 's'}, found {found}"
    )
    body.fail(kinds.ARGUMENTS, node, message, _other_blank(node, signature) or _parameters(signature))


def _counts(signature: Signature) -> tuple[int, int]:
    """Return how many arguments a task takes at least and at most."""
    return sum(formal.default is None for formal in signature.formals), len(signature.formals)


def _other_blank(node: syntax.Call, signature: Signature) -> str:
    """Return the effect of a blank before the parenthesis, if it makes the arguments fit."""
    if (inside := _only(node.arguments)) is None:
        return ""
    needed, most = _counts(signature)
    if _is_apart(node):
        if not needed <= len(inside.items) <= most:
            return ""
        return f"without the blank, `{node.name.text}(…)`, the parenthesis is the list of arguments"
    takes_one = needed <= 1 <= most and known(signature.formals[0].type) == POSE
    if takes_one and len(inside.items) in _COORDINATES and not any(item.name for item in inside.items):
        return f"with a blank between, `{node.name.text} (…)`, the parenthesis is one location"
    return ""


def _parameters(signature: Signature) -> str:
    return "its parameters: " + (_listed(signature) or "none")


def _listed(signature: Signature) -> str:
    return ", ".join(f"`{formal.name}: {known(formal.type)}`" for formal in signature.formals)


def _argument(body: Body, signature: Signature, formal: Formal, bound: dict[str, nodes.Node]) -> Expression:
    node = bound.get(formal.name)
    if node is None:
        assert formal.default is not None
        return formal.default
    what = f"argument `{formal.name}` of `{signature.name}`"
    if known(formal.type) == POSE and isinstance(node, nodes.Number) and node.is_whole and not node.unit:
        return _reference(body, node)
    value = values.check(body, node)
    facing.check_target(body, node)
    expression = convert.to(body, value, formal.type, node, what)
    readings.check_argument(body, signature.name, formal, expression, node)
    return poses.kept(value, expression)


def _reference(body: Body, node: nodes.Number) -> Expression:
    """Return the caller's reference location of a number."""
    number, count = int(node.value), len(body.references)
    if 1 <= number <= count:
        return VariableExpression(body.references[number - 1], POSE.value)
    where = f"task `{body.task}` has {count}" if body.task else "control statements have none"
    message = f"there is no reference location {number}: {where}"
    body.fail(name_kinds.NO_REFERENCE, node, message, "name a location, or write it as `(x, y, z)`")


def _is_location(body: Body, name: nodes.Name) -> bool:
    symbol = body.find(name.text)
    if isinstance(symbol, Value):
        return components.is_location(symbol)
    return known(getattr(symbol, "type", None) or POSE) == POSE if symbol is not None else False
