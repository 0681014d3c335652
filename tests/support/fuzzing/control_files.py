"""Files of joint controllers, damaged: mostly in numbers, references and entities."""

from functools import lru_cache
from random import Random

from ropsim.blockdiagram import (
    Adaptation,
    Axes,
    CascadeGains,
    OutputKind,
    cascade,
    computed_torque,
    model_reference_adaptive,
    multivariable,
    read_diagram,
    write_diagram,
)
from ropsim.core import SourceText
from ropsim.model import JointType
from ropsim.views import Style, diagnostics_text
from support.fuzzing.mutation import damaged_exchange
from support.fuzzing.target import Target

_ENTITIES = (b"SIGNAL", b"GAIN", b"PID", b"SUM", b"STATE_SPACE", b"LINK", b"CONTROLLER", b"BLOCK", b"DELAY")
_SHOWN = 5  # findings that are written out


@lru_cache(maxsize=1)
def _texts() -> tuple[bytes, ...]:
    two = Axes((JointType.REVOLUTE, JointType.PRISMATIC), 0.001, OutputKind.EFFORT)
    made = (
        cascade(two, CascadeGains(20.0, (5.0, 6.0), 50.0, per_speed=0.1)),
        computed_torque(Axes((JointType.REVOLUTE,) * 3, 0.001), 400.0, 40.0, 100.0),
        model_reference_adaptive(two, Adaptation(30.0, 20.0, 5.0, 1.0)),
        multivariable(Axes((JointType.REVOLUTE,), 0.001), [[0.5]], [[1.0, 2.0]], [[3.0]], [[4.0, 5.0]]),
    )
    return tuple(write_diagram(one).encode() for one in made)


def _made(random: Random) -> bytes:
    return damaged_exchange(random, random.choice(_texts()), _ENTITIES, 40)


def _take(content: bytes) -> str:
    """Read a file; what was read is written to a file that reads the same."""
    source = SourceText("a.p21", content.decode("utf-8", "replace"))
    found = read_diagram(source)
    assert isinstance(diagnostics_text(found.findings[:_SHOWN], {source.name: source}, Style.PLAIN), str)
    wrong = [one.code for one in found.findings if one.is_error]
    assert (found.diagram is None) == bool(wrong)
    for one in found.findings:
        assert one.span is None or 1 <= one.span.line <= len(source.lines)
    if found.diagram is None:
        return wrong[0]
    text = write_diagram(found.diagram)
    again = read_diagram(SourceText("b.p21", text))
    assert again.diagram == found.diagram
    assert write_diagram(again.diagram) == text
    return "read"


TARGETS = (Target("control", _made, _take),)
