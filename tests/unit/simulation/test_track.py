import numpy as np

from ropsim.simulation.track import Track


def test_a_value_set_at_a_tick_holds_from_the_period_after_it() -> None:
    track = Track()
    track.set(0, 5.0)
    track.set(4, 7.0)
    track.set(4, 8.0)
    track.set(9, 8.0)
    assert track.at(np.array([0.0, 4.0, 5.0, 100.0])).tolist() == [5.0, 5.0, 8.0, 8.0]
    assert track.ticks == [0, 4]


def test_a_track_that_was_never_set_reads_zero() -> None:
    assert Track().at(np.array([1.0, 2.0])).tolist() == [0.0, 0.0]
