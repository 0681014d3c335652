"""Every kind of drive of a device has what moves it."""

from typing import get_args

from ropsim.model import DeviceDrive
from ropsim.simulation.testing import DRIVINGS


def test_every_kind_of_drive_is_moved_by_something() -> None:
    assert set(DRIVINGS) == set(get_args(DeviceDrive))
