import math

import pytest

from ropsim.flow import AxisType
from ropsim.views.testing import (
    DEGREES,
    MILLIMETRES,
    coordinate_scale,
    fixed,
    joined_units,
    percent,
    with_unit,
)


def test_angles_are_shown_in_degrees_and_lengths_in_millimetres() -> None:
    assert with_unit(math.pi, DEGREES, 1) == "180.0°"
    assert with_unit(0.0125, MILLIMETRES, 1) == "12.5\u00a0mm"


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_unknown_numbers_are_a_dash(value: float) -> None:
    assert fixed(value, DEGREES, 1) == with_unit(value, DEGREES, 1) == percent(value) == "–"


def test_there_is_no_negative_zero() -> None:
    assert fixed(-1e-9, MILLIMETRES, 2) == "0.00"


def test_columns_of_mixed_joints_name_both_units() -> None:
    types = [AxisType.REVOLUTE, AxisType.PRISMATIC, AxisType.REVOLUTE]
    assert joined_units(map(coordinate_scale, types)) == "° or mm"
