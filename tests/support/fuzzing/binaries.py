"""Binary ICR programs, damaged, mostly with a right checksum: else nothing behind it would be looked at."""

import hashlib
from pathlib import Path
from random import Random

from ropsim import icr
from ropsim.core import Diagnostic
from ropsim.icr.binary.layout import CHECKSUM
from support.fuzzing.mutation import BYTES, mutated
from support.fuzzing.target import Target

_ROOT = Path(__file__).parents[3]
_BUDGET = 20_000
_TEXTS = [path.read_text("ascii") for path in sorted(_ROOT.glob("tests/golden/icr/*.icr"))]
_PROGRAMS = tuple(icr.encoded(icr.assemble(text))[:-CHECKSUM] for text in _TEXTS)


def signed(content: bytes) -> bytes:
    """Return bytes with their checksum."""
    return content + hashlib.sha256(content).digest()


def _made(random: Random) -> bytes:
    content = random.choice(_PROGRAMS)
    if random.random() < 0.1:
        return mutated(random, signed(content), BYTES)
    return signed(mutated(random, content, BYTES))


def _take(content: bytes) -> str:
    program, found = icr.read_binary(content, "a.icb")
    if program is None:
        return _code(found)
    found = icr.verify(program)
    if found:
        icr.disassemble(program)
        return _code(found)
    assert icr.encoded(program) == content
    text = icr.disassemble(program)
    assert icr.assemble(text) == program
    assert icr.encoded(icr.assemble(text)) == content
    icr.run(program, budget=_BUDGET)
    return "read"


def _code(found: tuple[Diagnostic, ...]) -> str:
    assert found
    assert all(one.message for one in found)
    return found[0].code


TARGETS = (Target("icb", _made, _take),)
