"""Logged traces."""

from random import Random

from ropsim import robots
from ropsim.calibration import read_trace
from ropsim.calibration.trace.rests import rests_of
from support.fuzzing.mutation import BYTES, TEXT, mutated
from support.fuzzing.target import Target

_JOINTS = robots.load("two_link").axis_joints
_ROWS = "\n".join(f"{k * 0.01:.2f},{k * k * 0.01:.3f},{-k * 0.5:.3f}" for k in range(40))
_SEEDS = (
    f"time [s],j1 [deg],j2 [rad]\n{_ROWS}\n".encode(),
    f"{_ROWS}\n".encode(),
    ("\ufeffZeit [s];A1;A2\r\n" + _ROWS.replace(",", ";").replace(".", ",").replace("\n", "\r\n")).encode(),
)


def _trace(content: bytes) -> str:
    trace, findings = read_trace(content, _JOINTS, "t.csv")
    if trace is None:
        return findings[0].code
    assert rests_of(trace).count >= 1
    return "read"


def _made(random: Random) -> bytes:
    return mutated(random, random.choice(_SEEDS), random.choice((BYTES, TEXT)))


TARGETS = (Target("trace", _made, _trace),)
