"""The model of an arm in a law: equations of motion, transmissions, numbers of the drives, by name."""

import re
from collections.abc import Callable, Sequence
from dataclasses import fields
from functools import lru_cache

import numpy as np
import numpy.typing as npt

from ropsim.codegen import Scalar, SourceFunction, Tracer, cos, emit, sin, sqrt
from ropsim.dynamics import (
    ArmStructure,
    DriveChain,
    arm_numbers,
    check_model,
    inverse_dynamics,
    mass_matrix,
    split_numbers,
    structure_of,
    trace_loaded_inertias,
    trace_loaded_inverse,
    with_rigid_gears,
)
from ropsim.model import BallScrew, Drive, Linkage, Mechanism, Payload
from ropsim.spatial import Array, frozen, record

_LOAD = 10
_PLACED = ("ratio", "slope", "place")
OPEN = 1e30
"""Stands for the limit of an amplifier without a limit."""


@record
class LawModel:
    """The arm as a law believes it to be; make it with `law_model`.

    A compiled law names what it uses of it. The arrays `model` and `drive` may be arguments of `law`:

    - `drive` (d, n): the numbers of the drives, a row each, `drive[area_a, j]`; `drive_names` has the names,
      which are those of the records in `ropsim.model`, and `sense`, the sign of the transmission.
    - `model` (m,): all numbers of the arm, for the functions that the law may call.

    These functions take arrays of n numbers, such as rows of `ref`, `meas` and `work`, and write their last
    arguments:

    - `inverse(model, q, qd, qdd, load, tau)`: the torques of the drives at the joints that a motion takes,
      with tool and part, inertia and friction of the drives [N·m | N]; gears count as rigid.
    - `inertias(model, q, load, inertia)`: the inertia that each axis moves while the others stand, with tool
      and part and its drive [kg·m² | kg].
    - `transmission(model, q, ratio, slope, place)`: G, which is the speed of the motor or rod over that of
      the joint, dG/dq, and where the motor stands [rad], or by how much the rod of a cylinder is out [m].

    A law in Python has the methods `inverse`, `inertias`, `transmission` and `drive`.

    Attributes:
        robot: the arm.
        drive_names: names of the rows of `drives`.
        drives: numbers of the drives, 0 where a drive does not have one, shape (d, n).
        numbers: of the arm with rigid gears, shape (m,).
    """

    robot: Mechanism
    drive_names: tuple[str, ...]
    drives: Array
    numbers: Array

    @property
    def rows(self) -> Array:
        """Return `drives` and `numbers` as rows of n numbers, the last one filled up with zeros."""
        n = self.robot.n
        filled = np.concatenate((self.numbers, np.zeros(-len(self.numbers) % n)))
        return np.vstack((self.drives, filled.reshape(-1, n)))

    def functions(self, source: str) -> tuple[SourceFunction, ...]:
        """Return those of the functions that a source calls."""
        made: dict[str, Callable[[ArmStructure], SourceFunction]] = {
            "inverse": _inverse,
            "inertias": _inertias,
            "transmission": _transmission,
        }
        structure = structure_of(with_rigid_gears(self.robot))
        return tuple(make(structure) for name, make in made.items() if re.search(rf"\b{name}\(", source))

    def drive(self, name: str) -> Array:
        """Return a number of the drives, shape (n,), such as `area_a`; 0 for drives without it.

        Raises:
            KeyError: no drive has a number of this name.
        """
        if name not in self.drive_names:
            raise KeyError(name)
        values: Array = self.drives[self.drive_names.index(name)]
        return values

    def inverse(
        self, q: npt.ArrayLike, qd: npt.ArrayLike, qdd: npt.ArrayLike, payload: Payload | None = None
    ) -> Array:
        """Return the torques of the drives at the joints that a motion takes; see `inverse_dynamics`."""
        return inverse_dynamics(with_rigid_gears(self.robot), q, qd, qdd, payload=payload)

    def inertias(self, q: npt.ArrayLike, payload: Payload | None = None) -> Array:
        """Return the inertia that each axis moves while the others stand, shape (n,)."""
        return np.diagonal(mass_matrix(with_rigid_gears(self.robot), q, payload)).copy()

    def transmission(self, q: npt.ArrayLike) -> Array:
        """Return G, dG/dq, and where motor or rod stands, shape (3, n).

        Args:
            q: coordinates of the joints [rad | m], shape (n,).
        """
        places = np.asarray(q, np.float64).tolist()
        return np.array([_transmitted(one, q) for one, q in zip(self.robot.drives, places, strict=True)]).T


@lru_cache(maxsize=64)
def law_model(robot: Mechanism) -> LawModel:
    """Return what a law knows of an arm with drives.

    Raises:
        JointCountError: links or drives are missing.
        MechanismError: the mechanism cannot be.
    """
    check_model(robot)
    numbers = np.array(arm_numbers(with_rigid_gears(robot)))
    numbers[numbers == np.inf] = OPEN
    of_drives = [_numbers(drive) for drive in robot.drives]
    names = tuple(dict.fromkeys(name for one in of_drives for name in one))
    rows = np.array([[one.get(name, 0.0) for one in of_drives] for name in names])
    return LawModel(robot, names, frozen(np.minimum(rows, OPEN)), frozen(numbers))


def _numbers(drive: Drive) -> dict[str, float]:
    """Return the numbers of a drive by name; where two blocks have one name, that of the motor counts."""
    gear = drive.transmission
    found = {"sense": drive.sense}
    for block in (drive.motor, gear, drive.friction, drive.amplifier):
        for name in (one.name for one in fields(block)):
            value = getattr(block, name)
            if isinstance(value, int | float):
                found.setdefault(name, float(value))
    if isinstance(gear, BallScrew):
        found["ratio"] = gear.ratio
    if isinstance(gear, Linkage):
        found |= {"product": gear.product, "squares": gear.squares, "angle": gear.angle}
    return found


def _transmitted(drive: Drive, q: float) -> tuple[float, float, float]:
    gear = drive.transmission
    if isinstance(gear, Linkage):
        return gear.ratio_at(q), gear.slope_at(q), gear.out_at(q)
    return gear.ratio, 0.0, gear.ratio * q


def _inverse(structure: ArmStructure) -> SourceFunction:
    """Return `inverse(model, q, qd, qdd, load, tau)` of an arm with rigid gears."""
    return inverse_function("inverse", ("q", "qd", "qdd"), structure)


@lru_cache(maxsize=32)
def inverse_function(name: str, motion: tuple[str, ...], structure: ArmStructure) -> SourceFunction:
    """Return `name(model, *motion, load, tau)`, which writes the torques of the drives of a motion to `tau`.

    Args:
        name: of the function.
        motion: arrays of coordinates, speeds and accelerations; a fourth one has the speeds of friction.
        structure: of an arm with rigid gears.
    """
    tracer, n = Tracer(), structure.n
    q, qd, qdd, *others = (tracer.variables(one, n) for one in motion)
    load, arm = tracer.variables("load", _LOAD), split_numbers(structure, _given(tracer, structure))
    tau = trace_loaded_inverse(tracer, structure, arm, (q, qd, qdd), load, (others[0] if others else qd, qdd))
    results = [(f"tau[{k}]", one) for k, one in enumerate(tau)]
    return emit(name, ("model", *motion, "load", "tau"), results)


@lru_cache(maxsize=16)
def _inertias(structure: ArmStructure) -> SourceFunction:
    """Return `inertias(model, q, load, inertia)` of an arm with rigid gears."""
    tracer = Tracer()
    arm = split_numbers(structure, _given(tracer, structure))
    q, load = tracer.variables("q", structure.n), tracer.variables("load", _LOAD)
    found = trace_loaded_inertias(tracer, structure, arm, q, load)
    results = [(f"inertia[{k}]", one) for k, one in enumerate(found)]
    return emit("inertias", ("model", "q", "load", "inertia"), results)


def _given(tracer: Tracer, structure: ArmStructure) -> list[Scalar]:
    """Return the numbers of the arm; zeros are constants."""
    zero = tracer.constant(0.0)
    return [tracer.variable(f"model[{k}]") if there else zero for k, there in enumerate(structure.present)]


@lru_cache(maxsize=16)
def _transmission(structure: ArmStructure) -> SourceFunction:
    """Return `transmission(model, q, ratio, slope, place)`."""
    tracer, n = Tracer(), structure.n
    numbers = split_numbers(structure, tracer.variables("model", len(structure.present)))
    q, results = tracer.variables("q", n), list[tuple[str, Scalar]]()
    for k, (chain, of_drive) in enumerate(zip(structure.drives, numbers.drives, strict=True)):
        found = _traced(tracer, chain, of_drive, q[k])
        results += [(f"{name}[{k}]", value) for name, value in zip(_PLACED, found, strict=True)]
    return emit("transmission", ("model", "q", *_PLACED), results)


def _traced(tracer: Tracer, chain: DriveChain, numbers: Sequence[Scalar], q: Scalar) -> tuple[Scalar, ...]:
    """Return G, dG/dq and the place of motor or rod; of a linkage as in `model.Linkage`."""
    first = len(chain.amplifier.numbers) + len(chain.motor.numbers)
    gear = dict(zip(chain.transmission.numbers, numbers[first:], strict=False))
    if "product" not in gear:
        return gear["ratio"], tracer.constant(0.0), gear["ratio"] * q
    turn, product = q + gear["angle"], gear["product"]
    lever, length = product * cos(turn), sqrt(gear["squares"] - 2.0 * product * cos(turn))
    ratio = product * sin(turn) / length
    return ratio, (lever - ratio * ratio) / length, length - gear["retracted_length"]
