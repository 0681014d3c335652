"""To which levels a program sets a channel, read from its neutral code."""

import pytest

from ropsim.icr import assemble
from ropsim.simulation.testing import BOTH, levels_set

STRAIGHT = ("PUSH BOOL FALSE", "OUT lamp", "HALT")
JUMPED_TO = ("IN key", "DUP", "JT out", "POP", "PUSH BOOL FALSE", "out:", "OUT lamp", "HALT")
"""Where it is jumped to, `key` is what goes out, and not the constant above it."""


@pytest.mark.parametrize(("lines", "levels"), [(STRAIGHT, {False}), (JUMPED_TO, BOTH)])
def test_a_constant_is_the_level_only_where_nothing_jumps_behind_it(
    lines: tuple[str, ...], levels: set[bool]
) -> None:
    code = "\n".join(lines)
    program = assemble(f"ICR 1.0 t\nIO DI key BOOL\nIO DO lamp BOOL\nPROC main\n{code}\nEND\n")
    assert levels_set(program, "lamp") == levels
