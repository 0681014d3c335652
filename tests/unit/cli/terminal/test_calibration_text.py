"""The report of a calibration: how certain each limit is, and what would tell the others."""

import numpy as np

from ropsim.calibration import Calibration, Knowledge, MotionSettings, SequenceTimes, TraceTime
from ropsim.calibration.knowledge import LimitKnowledge
from ropsim.cli.terminal.calibration_text import calibration_text
from ropsim.model import JointType, LookAhead
from ropsim.views import Style

TIMES = SequenceTimes(None, None, 1, 1.0, 0.9, 1.001, 1e-4)


def text(spreads: dict[int, float]) -> str:
    """Return the report on two axes; limits with these deviations are uncertain, the others fitted."""
    settings = MotionSettings(np.full((3, 2), 2.0), np.full((3, 2), 1.5), LookAhead())
    kinds = tuple(Knowledge.UNCERTAIN if one in spreads else Knowledge.FITTED for one in range(12))
    known = LimitKnowledge(kinds, settings.all, np.array([spreads.get(one, 0.001) for one in range(12)]))
    made = Calibration(
        "r1",
        ("1", "2"),
        settings,
        settings,
        known,
        Knowledge.NOT_SEEN,
        (TIMES,),
        1,
        (),
        (),
        TraceTime(1.2, 1.0, 0.0),
    )
    return calibration_text(made, (JointType.REVOLUTE,) * 2, Style.PLAIN)


def test_two_standard_deviations_stand_behind_an_uncertain_limit() -> None:
    assert "→ ~115 ±6 %" in text({2: 0.03})
    assert "±" not in text({})


def test_a_limit_that_may_have_any_value_has_none() -> None:
    said = text({10: np.inf})
    assert "→ ~1500" in said
    assert "±" not in said


def test_limits_that_the_trace_leaves_open_are_named_with_what_would_tell_them() -> None:
    said = " ".join(text({3: 0.2, 10: np.inf, 11: 0.01}).split())
    assert "not told acceleration of joint 2, jerk of the path: log" in said
    assert "long and short moves of these joints and lines of all lengths" in said
    assert "tool turns" not in said
    assert "not told" not in text({10: 0.04})
