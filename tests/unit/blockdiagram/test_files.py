"""Files of controllers: round trips to the byte, every mistake at its line, and nothing ever raises."""

from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ropsim.blockdiagram import (
    Adaptation,
    AntiWindup,
    Axes,
    CascadeGains,
    Diagram,
    Limits,
    OutputKind,
    cascade,
    computed_torque,
    hybrid_force,
    impedance,
    model_reference_adaptive,
    motor_cascade,
    multivariable,
    p_controller,
    pi_controller,
    pid_controller,
    read_diagram,
    state_feedback,
    write_diagram,
)
from ropsim.core import SourceText
from ropsim.model import JointType
from ropsim.views import Style, diagnostics_text
from support.fuzzing.mutation import TEXT, mutated

TWO = Axes((JointType.REVOLUTE, JointType.PRISMATIC), 0.001, OutputKind.EFFORT)
DRIVES = Axes((JointType.REVOLUTE,) * 3, 0.0005)
TURN = Axes((JointType.REVOLUTE,), 0.001, OutputKind.VOLTAGE)


def kinds() -> dict[str, Diagram]:
    """Return a diagram of each kind."""
    limits = Limits((10.0, 200.0), AntiWindup.BACK_CALCULATION, 0.05)
    gains = CascadeGains((20.0, 30.0), (5.0, 6.0), (50.0, 60.0), per_speed=0.1, per_acceleration=(0.2, 0.3))
    adaptation = Adaptation(30.0, 20.0, (5.0, 6.0, 7.0), 1.0)
    return {
        "p": p_controller(TWO, (3.0, 4.0)),
        "pi": pi_controller(TWO, 3.0, (1.0, 2.0), limits),
        "pid": pid_controller(TWO, (3.0, 1.0, 0.1), filter_time=0.01, setpoint_weight=0.7),
        "p_pi": cascade(TWO, gains),
        "motor_p_pi": motor_cascade(TURN, CascadeGains(5.0, 0.5, 10.0), -105.0, (True,)),
        "state_feedback": state_feedback(TWO, [[3.0, 0.5], [0.1, 4.0]], (0.3, 0.4), 2.0),
        "multivariable": multivariable(TURN, [[0.5]], [[1.0, 2.0]], [[3.0]], [[4.0, 5.0]]),
        "computed_torque": computed_torque(DRIVES, 400.0, 40.0, 100.0),
        "impedance": impedance(DRIVES, (300.0, 400.0, 500.0), 30.0),
        "hybrid_force": hybrid_force(DRIVES, (True, False, False), 5.0, (300.0, 30.0), (0.5, 20.0)),
        "model_reference_adaptive": model_reference_adaptive(DRIVES, adaptation),
    }


@pytest.mark.parametrize("name", kinds())
def test_a_written_file_reads_as_the_same_diagram_and_writes_the_same_bytes(name: str) -> None:
    diagram = kinds()[name]
    text = write_diagram(diagram)
    found = read_diagram(SourceText("a.p21", text))
    assert found.findings == ()
    assert found.diagram == diagram
    assert write_diagram(found.diagram) == text


TEXTS = tuple(write_diagram(one) for one in kinds().values())
PI = write_diagram(kinds()["pi"])


def line_of(part: str) -> int:
    return next(k for k, line in enumerate(PI.splitlines(), start=1) if part in line)


@pytest.mark.parametrize(
    ("old", "new", "code", "part"),
    [
        ("(10.,200.)", "(10.,-200.)", "C625", "PID"),
        (",0.001);\nENDSEC", ",0.002);\nENDSEC", "X970", "CONTROLLER"),
        ("(3.,3.)", "(3.,3.,3.)", "C621", "PID"),
        ("(#2,#3),#4", "(#2),#4", "X970", "PID"),
        ("(#2,#3),#4", "(#2,#4),#4", "C623", "PID"),
        ("(#2,#3),#4", "(#2,#3),#3", "C622", "PID"),
        ("'q',2,(.RADIAN.,.METRE.)", "'q',2,(.RADIAN.,.VOLT.)", "C623", "'q'"),
        ("'q',2,(.RADIAN.,.METRE.)", "'q',2,(.RADIAN.,.METER.)", "X969", "'q'"),
        ("'q',2,", "'q_ref',2,", "C622", "'q_ref',2,(.RADIAN.,.METRE.),.REFERENCE"),
        ("'u',2,", "'u',3,", "X970", "'u'"),
        ("(3.,3.)", "(3.,1.E13)", "C625", "PID"),
        (".OUTPUT.,$", ".INNER.,$", "X970", "CONTROLLER"),
        ("'pi',(#2,#3)", "'pi',(#2,#9)", "X962", "PID"),
        ("ROPSIM_CONTROL_V1", "ROPSIM_NIROX_V1", "C620", "ISO"),
        ("PID(", "PIDD(", "C622", "CONTROLLER"),
    ],
)
def test_a_mistake_is_found_where_it_stands(old: str, new: str, code: str, part: str) -> None:
    assert old in PI
    found = read_diagram(SourceText("a.p21", PI.replace(old, new, 1)))
    assert found.diagram is None
    errors = [one for one in found.findings if one.is_error]
    assert errors[0].code == code, errors
    if part:
        assert errors[0].span is not None
        assert errors[0].span.line == line_of(part)


def test_a_loop_within_one_tick_is_named_block_by_block() -> None:
    text = write_diagram(kinds()["p"])
    assert "SUM('error',(#2,#3),#" in text
    looped = text.replace("SUM('error',(#2,#3),", "SUM('error',(#2,#5),")
    found = read_diagram(SourceText("a.p21", looped))
    assert found.diagram is None
    assert [one.code for one in found.findings] == ["C623"]
    other = looped.replace(".INNER.", ".INNER.").replace("(.NEWTON_METRE.,.NEWTON.)", "(.OTHER.)")
    other = other.replace(".EFFORT.,0", ".DRIVE_INPUT.,0")
    (finding,) = read_diagram(SourceText("a.p21", other)).findings
    assert finding.code == "C624"
    assert "`error`" in finding.message
    assert "`p`" in finding.message


@given(st.integers(0, 2**32 - 1))
def test_damaged_files_are_read_or_refused_with_findings(seed: int) -> None:
    random = Random(seed)
    content = mutated(random, random.choice(TEXTS).encode(), TEXT)
    source = SourceText("a.p21", content.decode("utf-8", "replace"))
    found = read_diagram(source)
    assert (found.diagram is None) == any(one.is_error for one in found.findings)
    assert isinstance(diagnostics_text(found.findings[:5], {source.name: source}, Style.PLAIN), str)
    for one in found.findings:
        assert one.span is None or 1 <= one.span.line <= len(source.lines)
    if found.diagram is not None:
        text = write_diagram(found.diagram)
        again = read_diagram(SourceText("b.p21", text))
        assert again.diagram == found.diagram
        assert write_diagram(again.diagram) == text
