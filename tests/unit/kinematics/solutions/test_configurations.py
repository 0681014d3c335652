import numpy as np

from ropsim import robots
from ropsim.kinematics import configurations

PUMA = robots.load("puma560")


def test_configurations_fill_the_ranges_of_the_joints() -> None:
    Q = configurations(PUMA, 512)
    share = (Q - PUMA.lower_limits) / (PUMA.upper_limits - PUMA.lower_limits)
    wide = share[:, np.degrees(PUMA.upper_limits - PUMA.lower_limits) < 360.0]
    assert wide.shape[1] >= 4
    for column in wide.T:
        assert np.diff(np.sort(column), prepend=0.0, append=1.0).max() < 0.05  # joint 4: φ⁻⁴ is near 9/13
