"""Robots whose limits all differ, logged on mixed programs: times come out, of a held-out program too."""

import numpy as np
import pytest

from support.twins import calibrated_twin, errors, known_settings, random_site, twin

OF_CHAINS = 0.03
IN_ALL = 0.01
HELD_OUT = 0.03
"""Shares of time."""
MEASURED = 0.001
"""By which the stated error may be less than the true one: what encoders of 0.002° at 125 Hz leave open."""


@pytest.mark.slow
@pytest.mark.parametrize(("seed", "tick"), [(0, 0.0), (0, 0.004)])
def test_times_of_a_twin_with_unknown_limits_come_out(seed: int, tick: float) -> None:
    """Path limits of 0.2 to 2 of the default, joint limits of 0.5 to 1, look-ahead 3 to 20.

    Times of samples are right, or wrong by up to 2 ms.
    """
    random = np.random.default_rng(seed)
    made = random_site(random)
    true = twin(known_settings(made), random)
    found = calibrated_twin(made, true, random, tick)
    own = errors(made, true, found.after)
    assert own.is_chain.any()
    assert own.of_chains <= OF_CHAINS
    assert abs(own.in_all) <= IN_ALL
    assert found.left_out == ()
    assert abs(found.in_all) <= IN_ALL
    assert found.remaining >= float(np.sqrt(np.mean(own.of_each**2))) - MEASURED
    other = errors(random_site(random), true, found.after)
    assert abs(other.in_all) <= HELD_OUT
    assert abs(errors(made, true, known_settings(made)).in_all) > IN_ALL
