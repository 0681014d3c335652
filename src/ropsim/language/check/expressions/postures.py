"""Postures and turns of a location, or that it is free: `; config (left, up), turns (0, -1), free`."""

import re

from ropsim.flow import PostureRequest, TargetOrientation
from ropsim.language.check.expressions import convert, values
from ropsim.language.check.scope import fold
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import INT
from ropsim.language.findings import names as name_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes

_POSTURE = re.compile("[a-z][a-z0-9_]*")
MOST_AXES = 32
"""Axes of an arm in neutral code."""
LARGEST = 100
"""Turns beyond this are a mistake of writing."""


def request(body: Body, node: nodes.Posture) -> PostureRequest:
    """Return the posture that a location requests from the arm.

    Raises:
        RejectedError: a word is none of its postures, or the turns do not fit its axes.
    """
    free = TargetOrientation.FREE if node.is_free else TargetOrientation.GIVEN
    return PostureRequest(_words(body, node), _turns(body, node), free)


def _words(body: Body, node: nodes.Posture) -> tuple[str, ...]:
    known = body.world.environment.postures
    seen: dict[int, str] = {}
    for place, word in enumerate(node.words):
        part = place
        if known is None and not _POSTURE.fullmatch(word.text):  # postures of all arms are in small letters
            body.unknown(name_kinds.UNKNOWN_POSTURE, word, "posture", [word.text.lower()])
        if known is not None:
            part = next((k for k, allowed in enumerate(known) if word.text in allowed), -1)
        if part < 0:
            if not known:
                hint = "leave `config` out, or give the target in joint coordinates"
                body.fail(kinds.WRONG_TYPE, word, "the postures of this arm have no names", hint)
            body.unknown(name_kinds.UNKNOWN_POSTURE, word, "posture", [one for part in known for one in part])
        if part in seen or word.text in seen.values():
            message = f"`{seen.get(part, word.text)}` and `{word.text}` are of one part of the arm"
            body.fail(kinds.WRONG_TYPE, word, message, "leave one of them out")
        seen[part] = word.text
    return tuple(word.text for word in node.words)


def _turns(body: Body, node: nodes.Posture) -> tuple[int, ...]:
    environment = body.world.environment
    own = environment.axes[: len(environment.axes) - len(environment.external)]
    if len(node.turns) > (len(own) or MOST_AXES):
        axes = f"the arm has {len(own)} axes" if own else f"an arm has at most {MOST_AXES} axes"
        message = f"`turns` has {len(node.turns)} numbers, {axes}"
        body.fail(kinds.OUT_OF_RANGE, node, message, "write one for each axis, from the first one on")
    found = []
    for place, number in enumerate(node.turns):
        expression = values.expect(body, number, INT, f"the turn of axis {place + 1}")
        constant = fold.number_of(convert.constant(body, expression, number, "a turn of an axis"))
        turn = int(constant or 0)
        if abs(turn) > LARGEST:
            body.fail(kinds.OUT_OF_RANGE, number, f"at most {LARGEST} turns are allowed, found {turn}")
        if turn and place < len(own) and own[place] == "length":
            body.fail(kinds.OUT_OF_RANGE, number, f"axis {place + 1} does not turn, allowed is 0")
        found.append(turn)
    return tuple(found)
