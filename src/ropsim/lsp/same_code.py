"""Whether a changed text does what it did: by its code, or by all that a dry run hands out."""

import re
from dataclasses import fields, replace

from ropsim import icr, language
from ropsim.flow import Instruction, Origin
from ropsim.language import Environment

#: ICR instructions after which the comparison of two dry runs ends.
BUDGET = 100_000

_LINES = re.compile(r"^\s*LINE \d+$\n", re.MULTILINE)


def has_same_code(before: str, after: str, environment: Environment) -> bool:
    """Return whether two texts compile to the same code, whatever the lines it comes from."""
    old, new = _code(before, environment), _code(after, environment)
    return old is not None and old == new


def does_the_same(before: str, after: str, environment: Environment) -> bool:
    """Return whether dry runs of two texts hand out the same instructions, whoever calls for them."""
    old, new = language.compile(before, environment).icr, language.compile(after, environment).icr
    return old is not None and new is not None and _handed_out(old) == _handed_out(new)


def _code(text: str, environment: Environment) -> str | None:
    code = language.compile(text, environment).icr
    return _LINES.sub("", icr.disassemble(code)) if code is not None else None


def _handed_out(code: icr.Program) -> list[Instruction]:
    return [_without_origin(one) for one in icr.run(code, budget=BUDGET).instructions]


def _without_origin(one: Instruction) -> Instruction:
    return replace(one, origin=Origin()) if any(part.name == "origin" for part in fields(one)) else one
