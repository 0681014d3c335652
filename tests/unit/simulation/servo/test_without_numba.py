"""An installation without numba still simulates, with the same source as plain Python."""

import subprocess
import sys

import numpy as np

from ropsim.model import Payload
from ropsim.simulation import Servo
from support.servo_cases import GOAL, START, puma, quintic

TWO_ENGINES = 1e-12  # elementary functions of two libraries over 5 ms

SCRIPT = """
import sys
sys.modules["numba"] = None  # as if it were not installed
sys.path[:0] = {path!r}
from support.servo_cases import GOAL, START, puma, quintic
from ropsim.model import Payload
from ropsim.simulation import Servo
servo = Servo.build(*puma())
state = servo.initial_state(START)
state = servo.run(state, quintic(START, GOAL, 5), Payload(), servo.recorder(state))
print(*(float(value).hex() for value in state.values))
"""


def test_without_numba_the_servo_gives_the_same_motion() -> None:
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT.format(path=sys.path)], capture_output=True, text=True, check=True
    )
    slow = [float.fromhex(word) for word in done.stdout.split()]
    servo = Servo.build(*puma())
    state = servo.initial_state(START)
    state = servo.run(state, quintic(START, GOAL, 5), Payload(), servo.recorder(state))
    np.testing.assert_allclose(slow, state.values, rtol=TWO_ENGINES, atol=TWO_ENGINES)
