"""Errors of sensors against closed forms: steps, range, noise, hold, delay."""

from dataclasses import dataclass, field, replace
from zlib import crc32

import numpy as np
import pytest

from ropsim import robots
from ropsim.controller import CellSensors, noise
from ropsim.model import (
    DistanceSensor,
    ForceSensor,
    ForceTorqueSensor,
    Payload,
    Sensor,
    SensorErrors,
    Signal,
    WrenchAxis,
    WrenchFrame,
)
from ropsim.planning import ArmState, SensedBefore
from ropsim.spatial import Array, Pose, cross, frozen

HZ = 1000
ARM = robots.load("puma560")
SPEED = 0.05
"""Speed at which the tool of `Falling` goes down [m/s]."""
SAMPLES = 4000
EXACT = 1e-12


@dataclass
class Falling:
    """A tool that goes down evenly towards a plane, pressed by a wrench that is proportional to the time.

    Attributes:
        tick: control tick, 0 and before at 1 m.
        asked: ticks at which the surroundings were asked for.
    """

    tick: int = 0
    seed: int = 0
    asked: list[int] = field(default_factory=list)

    @property
    def height(self) -> float:
        return 1.0 - SPEED * max(self.tick, 0) / HZ

    def arm(self, station: str = "") -> ArmState:
        del station
        turned = Pose(np.array([0.3, 0.0, self.height]), np.array([0.0, 1.0, 0.0, 0.0]))
        zeros = np.zeros(6)
        wrench = frozen(np.arange(1.0, 7.0) * max(self.tick, 0) / HZ)
        X_WM = Pose(np.array([0.3, 0.0, self.height + 0.1]), np.array([0.0, 1.0, 0.0, 0.0]))
        return ArmState(
            "robot", self.tick / HZ, ARM, Payload(), zeros, zeros, zeros, turned, wrench, X_WM=X_WM
        )

    def distance(self, X_WS: Pose, most: float, station: str = "") -> float:
        del station
        self.asked.append(self.tick)
        found = float(X_WS.position[2])
        return found if found <= most else np.inf

    def load(self, station: str = "") -> Array:
        del station
        return np.array([0.0, 0.0, 9.81, 0.0, 0.0, 0.0])

    def before(self, station: str, period: float, delay: float) -> SensedBefore:
        del station
        tick = self.tick - round(delay * HZ)
        tick -= tick % max(1, round(period * HZ))
        earlier = Falling(tick, self.seed, self.asked)
        return SensedBefore(earlier, tick, (self.tick - tick) / HZ, self.seed)


def readings(sensor: Sensor, ticks: range, seed: int = 0, name: str = "s") -> np.ndarray:
    sensors = CellSensors({name: Signal(name, is_input=True, analog=True, sensor=sensor)})
    return np.array([float(sensors.read(name, t / HZ, Falling(t, seed)).value) for t in ticks])


def heights(ticks: np.ndarray) -> np.ndarray:
    return np.asarray(1.0 - SPEED * np.maximum(ticks, 0) / HZ)


def distance(**errors: float) -> DistanceSensor:
    return DistanceSensor("", 2.0, errors=SensorErrors(**errors))


def test_a_reading_in_steps_is_the_nearest_whole_step() -> None:
    found = readings(distance(step=1e-4), range(500))
    assert np.abs(found / 1e-4 - np.round(found / 1e-4)).max() < 1e-9
    assert np.abs(found - heights(np.arange(500))).max() <= 0.5e-4 + EXACT


def test_a_delayed_reading_is_the_exact_one_of_that_time() -> None:
    found = readings(distance(delay=0.02), range(500))
    assert found == pytest.approx(heights(np.arange(500) - 20), abs=EXACT)


@pytest.mark.parametrize(("rate", "delay"), [(100.0, 0.0), (125.0, 0.003), (333.0, 0.01)])
def test_between_two_samples_the_reading_holds(rate: float, delay: float) -> None:
    ticks, period = np.arange(600), round(HZ / rate)
    taken = (ticks - round(delay * HZ)) // period * period
    found = readings(distance(period=1.0 / rate, delay=delay), range(600))
    assert found == pytest.approx(heights(taken), abs=EXACT)
    assert len(np.unique(found)) < 600 / period + 2


def test_the_age_of_a_sample_is_told() -> None:
    signal = Signal("s", is_input=True, analog=True, sensor=distance(period=0.01, delay=0.003))
    assert CellSensors({"s": signal}).read("s", 0.029, Falling(29)).age == pytest.approx(0.009)


def test_noise_has_its_mean_its_deviation_and_no_memory() -> None:
    """Bounds of four standard deviations of the estimates, for numbers that are nearly normal."""
    off = (readings(distance(noise=1e-4), range(SAMPLES)) - heights(np.arange(SAMPLES))) / 1e-4
    assert abs(off.mean()) < 4.0 / np.sqrt(SAMPLES)
    assert abs(off.std() - 1.0) < 4.0 / np.sqrt(2 * SAMPLES)
    assert abs(np.mean(off[1:] * off[:-1])) < 4.0 / np.sqrt(SAMPLES)
    assert np.abs(off).max() <= 6.0


def test_noise_is_that_of_seed_and_channel() -> None:
    one = readings(distance(noise=1e-4), range(50))
    assert (one == readings(distance(noise=1e-4), range(50))).all()
    assert (one != readings(distance(noise=1e-4), range(50), seed=1)).all()
    assert (one != readings(distance(noise=1e-4), range(50), name="other")).all()


def test_noise_goes_with_the_sample_and_not_with_the_reading() -> None:
    held = readings(distance(noise=1e-4, period=0.01), range(200))
    assert len(np.unique(held)) == 20
    backwards = readings(distance(noise=1e-4, period=0.01), range(199, -1, -1))
    assert (held == backwards[::-1]).all()


def test_noise_is_that_of_joint_sensors() -> None:
    found = readings(distance(noise=1.0), range(1))
    assert found[0] - 1.0 == pytest.approx(noise(0, crc32(b"s"), 0), abs=1e-12)


def test_where_nothing_is_in_range_a_distance_sensor_has_no_noise() -> None:
    sensor = DistanceSensor("", 0.2, errors=SensorErrors(noise=0.01))
    assert (readings(sensor, range(50)) == 0.2).all()
    switch = Signal("s", is_input=True, sensor=sensor)
    assert not any(CellSensors({"s": switch}).read("s", t / HZ, Falling(t)).value for t in range(50))


def test_a_sensor_is_at_the_end_of_its_range_to_both_sides() -> None:
    errors = SensorErrors(most=2.0)
    z = readings(ForceTorqueSensor("", WrenchAxis.Z, errors=errors), range(0, 2000, 50))
    x = readings(ForceTorqueSensor("", WrenchAxis.X, errors=errors), range(0, 4000, 50))
    assert z.max() == 2.0
    assert x.min() == -2.0


@pytest.mark.parametrize("errors", [{"noise": 0.3}, {"step": 0.6}, {"step": 0.07, "noise": 0.3}])
def test_a_distance_is_read_within_its_range(errors: dict[str, float]) -> None:
    """From 0.94 m on all is in range; noise goes beyond both ends, and no whole step ends there."""
    sensor = DistanceSensor("", 0.95, 0.05, SensorErrors(**errors))
    found = readings(sensor, range(1200, 20_000, 50))
    assert found.max() == 0.95
    assert found.min() == (-0.05 if "noise" in errors else 0.0)


def test_an_exact_sensor_is_asked_once_and_now() -> None:
    cell = Falling(40)
    signal = Signal("s", is_input=True, analog=True, sensor=DistanceSensor("", 2.0))
    assert CellSensors({"s": signal}).read("s", 0.04, cell).value == heights(np.array(40))
    assert cell.asked == [40]


@pytest.mark.parametrize("frame", WrenchFrame)
@pytest.mark.parametrize("axis", WrenchAxis)
def test_a_force_torque_sensor_reads_what_the_tool_exerts(axis: WrenchAxis, frame: WrenchFrame) -> None:
    """The tool is turned by half a turn about x, and 0.1 m beyond the interface along its z axis."""
    tick = 700
    force, moment = np.array([1.0, 2.0, 3.0]) * 0.7, np.array([4.0, 5.0, 6.0]) * 0.7
    turn = np.diag([1.0, -1.0, -1.0])
    lever = np.array([0.0, 0.0, 0.1]) if frame is WrenchFrame.TOOL else np.zeros(3)
    expected = np.concatenate([-turn @ force, -turn @ (moment + cross(lever, force))])
    sensor = ForceTorqueSensor("", axis, frame)
    assert readings(sensor, range(tick, tick + 1))[0] == pytest.approx(expected[axis.number], abs=1e-12)


def test_a_sensor_without_compensation_also_reads_what_it_carries() -> None:
    sensor = ForceTorqueSensor("", WrenchAxis.Z)
    carrying = replace(sensor, compensated=False)
    found = readings(carrying, range(5)) - readings(sensor, range(5))
    assert found == pytest.approx(-9.81)  # upwards, against the z axis of the tool


def test_a_springy_tip_has_the_errors_of_its_force() -> None:
    sensor = ForceSensor("", 1e4, 0.02, SensorErrors(step=5.0, most=100.0))
    found = readings(sensor, range(19_800, 20_600, 20))
    assert set(np.unique(found)) <= set(np.arange(0.0, 101.0, 5.0))
    assert found.max() == 100.0
