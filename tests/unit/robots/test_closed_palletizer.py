"""A palletizer whose parallelograms are cut has the path limits of the one that has them as couplings."""

from ropsim.kinematics import without_linear_loops
from ropsim.robots import path_limits_of_joints
from support.closed_arms import COUPLED_PALLETIZER, five_bar, palletizer


def test_parallelograms_count_as_couplings_and_other_chains_are_left_out() -> None:
    assert path_limits_of_joints(palletizer()) == path_limits_of_joints(COUPLED_PALLETIZER)
    assert path_limits_of_joints(five_bar()) is None


def test_parallelograms_become_couplings_with_whole_factors() -> None:
    linear = without_linear_loops(palletizer())
    assert linear.cuts == ()
    assert {one.dependent for one in linear.couplings} == {
        one.dependent for one in COUPLED_PALLETIZER.couplings
    }
    assert all(abs(factor) == 1.0 for one in linear.couplings for _, factor in one.terms)
