"""Under which conditions figures of accuracy hold, beside those of a test after ISO 9283.

ISO 9283:1998 moves a robot with its rated load in a plane of a cube within its work space, at 100, 50 and
10 % of the rated speed: thirty cycles at five poses for pose accuracy and repeatability, ten of a test path
for those of a path. A run has the moves of a program instead, once or as often as that repeats them: its
figures are computed by the formulas of the standard and do not carry its names.
"""

import math

from ropsim.core import frozen_dataclass

CYCLES = 10
"""Of a path in a test after the standard."""
LOAD = "tool and parts that the program carries"
LEFT_OUT = ("noise of the arm", "calibration", "warming", "play and elasticity that the model does not have")
"""What a simulated run does not contain."""


@frozen_dataclass
class AccuracyConditions:
    """The conditions of a run or a station.

    Attributes:
        cycles: passes of the path that is repeated most, 0 without a path of the tool.
        least_speed: least path speed that is given for a move [m/s]; NaN where none is known.
        most_speed: the largest of these [m/s].
        load: at the flange.
        paths: on which paths.
        left_out: what the figures do not contain.
        is_standard_test: whether they are those of a test after ISO 9283: never in a run of a program.
    """

    cycles: int = 0
    least_speed: float = math.nan
    most_speed: float = math.nan
    load: str = LOAD
    paths: str = "those of the program, not the test path in the cube of the standard"
    left_out: tuple[str, ...] = LEFT_OUT
    is_standard_test: bool = False
