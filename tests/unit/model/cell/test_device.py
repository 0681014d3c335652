"""What a device says of itself by the kind of its drive."""

import pytest

from ropsim import robots
from ropsim.model import BeltDrive, Device, DeviceDrive, IndexDrive, SwitchDrive
from ropsim.spatial import Pose

BELT = BeltDrive(0.5, 2.0, "run", 3.0)
SWITCH = SwitchDrive("go", 0.2, 0.5, 0.5, 2.0)
INDEX = IndexDrive("turn", 1.0, 0.5, 2.0)


@pytest.mark.parametrize(("drive", "q"), [(BELT, 0.0), (SWITCH, 0.2), (INDEX, 0.0)])
def test_a_switched_axis_starts_at_its_position_of_off_and_others_at_0(drive: DeviceDrive, q: float) -> None:
    assert Device("d", robots.slide(()), drive, Pose()).q_start == q


@pytest.mark.parametrize(("drive", "is_belt"), [(BELT, True), (SWITCH, False), (INDEX, False)])
def test_only_a_belt_carries_along_its_base(drive: DeviceDrive, *, is_belt: bool) -> None:
    assert Device("d", robots.slide(()), drive, Pose()).is_belt is is_belt
