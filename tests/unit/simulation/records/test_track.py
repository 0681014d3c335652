from ropsim.simulation.testing import Track


def test_a_value_set_at_a_tick_holds_from_the_period_after_it() -> None:
    track = Track()
    track.set(0, 5.0)
    track.set(4, 7.0)
    track.set(4, 8.0)
    track.set(9, 8.0)
    assert [track.value(tick) for tick in (0, 4, 5, 100)] == [5.0, 5.0, 8.0, 8.0]
    assert track.ticks == [0, 4]


def test_a_track_that_was_never_set_reads_zero() -> None:
    assert Track().value(1) == 0.0


def test_a_value_that_is_taken_back_at_the_same_tick_is_no_change() -> None:
    track = Track([0], [1.0])
    track.set(5, 2.0)
    track.set(5, 1.0)
    assert (track.ticks, track.values) == ([0], [1.0])


def test_changes_are_told_up_to_a_tick_that_one_included() -> None:
    ticks, values = Track([0, 4, 9], [1.0, 2.0, 3.0]).until(4)
    assert (ticks.tolist(), values.tolist()) == ([0.0, 4.0], [1.0, 2.0])
