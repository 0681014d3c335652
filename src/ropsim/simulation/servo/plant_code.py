"""Drives and arm as source: straight-line code, or loops over the joints of a long arm."""

from collections.abc import Callable, Sequence
from functools import lru_cache

import numpy as np

from ropsim.codegen import Engine, Formula, GivenCode, Scalar, SourceFunction, Tracer, load
from ropsim.controller import LawTraits
from ropsim.core import frozen_dataclass
from ropsim.dynamics import (
    SUPPLY,
    ArmStructure,
    Carried,
    LoopState,
    arm_numbers,
    at_supplies,
    chain_acceleration_code,
    chain_numbers,
    motion_code,
    plant_formulas,
    sides_of,
    structure_of,
    trace_arm,
    trace_drives,
    trace_forward,
    trace_supplies,
    traced_numbers,
)
from ropsim.model import RobotModel
from ropsim.simulation.servo.log import LogLayout
from ropsim.simulation.servo.state import StateLayout
from ropsim.spatial import Array


@frozen_dataclass
class LongPlantCode:
    """Counterpart of `GivenCode` for an arm that is too long for straight-line code.

    Attributes:
        structure: of the arm.
        drives: the functions that are straight-line code all the same.
    """

    structure: ArmStructure
    drives: GivenCode

    @property
    def functions(self) -> tuple[SourceFunction, ...]:
        """Return the functions of the plant; each takes `constants` before its last argument."""
        n, size = self.structure.n, StateLayout.of(self.structure, LawTraits()).integrated
        text = f"""\
def derivative(x, u, constants, dx):
    side = np.empty({size})
    drives(x, u, constants, side)
    for j in range({n}):
        dx[j] = x[{n} + j]
    net, inertia, chain = side[:{n}], side[{n}:{2 * n}], constants[{self.drives.count}:]
    chain_accelerations(x[:{n}], x[{n}:{2 * n}], net, inertia, chain, dx[{n}:{2 * n}])
    for j in range({2 * n}, {size}):
        dx[j] = side[j]
"""
        derivative = SourceFunction("derivative", "void(f8[::1], f8[::1], f8[::1], f8[::1])", text)
        return (*self.drives.functions, *chain_acceleration_code(), derivative)

    def constants(self, numbers: Array) -> Array:
        """Return the constants of the functions for the numbers of an arm of this structure."""
        return np.concatenate([self.drives.constants(numbers), chain_numbers(self.structure, numbers)])


@frozen_dataclass
class ClosedPlantCode:
    """Counterpart of `GivenCode` for an arm with closed chains; see `dynamics.motion_code`.

    Attributes:
        traced: the functions that are straight-line code.
        state: where coordinates and speeds stand in the state.
        rows: number of directions that cuts hold.
        watched: of these, whose determinant tells the side of a dead centre.
    """

    traced: GivenCode
    state: LoopState
    rows: int
    watched: tuple[int, ...]

    @property
    def functions(self) -> tuple[SourceFunction, ...]:
        """Return the functions of the plant, and `settle`; all have `constants` before the last argument."""
        return (*self.traced.functions, *motion_code(self.state, self.rows, self.watched))

    def constants(self, numbers: Array) -> Array:
        """Return the constants of the functions for the numbers of an arm of this structure."""
        return self.traced.constants(numbers)


@frozen_dataclass
class _Traced:
    """The drives of an arm in one traced formula.

    Attributes:
        tracer: the graph.
        layout: of the state.
        x: integrated part of the state.
        u: output of the amplifiers.
        outside: efforts at the axes from outside; empty where nothing exerts them.
        outputs: output of the amplifiers for a command.
        carried: effect of each drive on its joint.
        supplies: rates of the pressures of supplies with accumulators.
    """

    tracer: Tracer
    layout: StateLayout
    x: list[Scalar]
    u: list[Scalar]
    outside: list[Scalar]
    outputs: list[Scalar]
    carried: list[Carried]
    supplies: list[Scalar]

    @classmethod
    def of(cls, tracer: Tracer, structure: ArmStructure, outside_rows: int = 0) -> "_Traced":
        n, chains = structure.n, structure.drives
        layout = StateLayout.of(structure, LawTraits(), 0, outside_rows)
        arm = traced_numbers(tracer, structure)
        x = tracer.variables("x", layout.integrated)
        command, given = tracer.variables("command", n), tracer.variables("u", (1 + outside_rows) * n)
        u, outside = given[:n], given[n:]
        outputs = [chain.amplified(arm.drives[k], command[k]) for k, chain in enumerate(chains)]
        states = [[x[place] for place in layout.drive(k)] for k in range(n)]
        pressures = x[layout.supplies]
        at = at_supplies(structure, arm, pressures)
        carried = trace_drives(structure, at, (x[layout.q], x[layout.qd]), states, u)
        supplies = trace_supplies(structure, arm, states, pressures)
        return cls(tracer, layout, x, u, outside, outputs, carried, supplies)

    @property
    def tau(self) -> list[Scalar]:
        """Return the torques of the drives at the joints."""
        return [one.effort for one in self.carried]

    @property
    def net(self) -> list[Scalar]:
        """Return the efforts at the axes: torques of the drives less friction, and those from outside."""
        sides = sides_of(self.tracer, self.carried)
        net = [tau - side.friction.under(tau) for tau, side in zip(self.tau, sides, strict=True)]
        return [one + more for one, more in zip(net, self.outside, strict=True)] if self.outside else net

    def rates(self, target: str) -> list[tuple[str, Scalar]]:
        """Return the rates of the states of the drives and of the pressures of their supplies."""
        first = self.layout.supplies.start
        of_supplies = [(f"{target}[{first + k}]", rate) for k, rate in enumerate(self.supplies)]
        of_drives = [
            (f"{target}[{place}]", rate)
            for k, one in enumerate(self.carried)
            for place, rate in zip(self.layout.drive(k), one.rates, strict=True)
        ]
        return [*of_drives, *of_supplies]


@lru_cache(maxsize=64)
def plant_code(structure: ArmStructure, outside_rows: int = 0) -> GivenCode | LongPlantCode | ClosedPlantCode:
    """Return `amplify`, `derivative`, `efforts` and `observe` of arm and drives.

    `amplify(command, constants, u)` computes the output of the amplifiers; `derivative(x, u, constants, dx)`
    the rates of the integrated part of the state; `efforts(x, u, constants, tau)` the torques of the drives
    at the joints; `observe(x, u, constants, row)` a row of the log without the reference. An arm with closed
    chains also has `settle(x, constants)`.

    Args:
        structure: of arm and drives.
        outside_rows: 1 where efforts at the axes from outside stand behind the outputs in `u`, else 0.
    """
    tracer = Tracer()
    drives = _Traced.of(tracer, structure, outside_rows)
    others = (
        Formula("amplify", ("command", "u"), [(f"u[{k}]", one) for k, one in enumerate(drives.outputs)]),
        Formula("efforts", ("x", "u", "tau"), [(f"tau[{k}]", one) for k, one in enumerate(drives.tau)]),
        Formula("observe", ("x", "u", "row"), _row(structure, drives)),
    )
    if structure.is_long:
        sides = Formula("drives", ("x", "u", "side"), _sides(drives))
        return LongPlantCode(structure, GivenCode.of(*others, sides))
    if structure.cuts:
        return _closed(tracer, structure, drives, others)
    arm = trace_arm(tracer, structure, traced_numbers(tracer, structure), drives.x[drives.layout.q])
    qd = drives.x[drives.layout.qd]
    rates = [*qd, *trace_forward(arm, qd, drives.tau, sides_of(tracer, drives.carried), drives.outside)]
    results = [*((f"dx[{k}]", rate) for k, rate in enumerate(rates)), *drives.rates("dx")]
    return GivenCode.of(*others, Formula("derivative", ("x", "u", "dx"), results))


def _closed(
    tracer: Tracer, structure: ArmStructure, drives: _Traced, others: Sequence[Formula]
) -> ClosedPlantCode:
    x, state = drives.x, drives.layout.loops
    arm = trace_arm(
        tracer, structure, traced_numbers(tracer, structure), [x[place] for place in state.places]
    )
    speeds = [x[place] for place in state.speed_places]
    sides = sides_of(tracer, drives.carried)
    rates = dict(drives.rates(""))
    plant = plant_formulas(
        arm,
        structure.cuts,
        speeds,
        (drives.net, [side.inertia for side in sides]),
        [rates[f"[{place}]"] for place in state.rates],
    )
    return ClosedPlantCode(GivenCode.of(*others, *plant), state, structure.rows, structure.watched)


def observe(robot: RobotModel, x: Array, u: Array, row: Array) -> None:
    """Enter everything but the reference into a row of the log.

    Args:
        robot: arm with drives.
        x: integrated part of the state vector.
        u: output of the amplifiers.
        row: of the log; written in place.
    """
    _evaluated(robot, "observe", x, u, row)


def efforts(robot: RobotModel, x: Array, u: Array, tau: Array) -> None:
    """Enter the torques of the drives at the joints into `tau`; arguments as in `observe`."""
    _evaluated(robot, "efforts", x, u, tau)


def plant_sides(robot: RobotModel) -> Callable[[Array, Array], Array]:
    """Return what the drives of an arm do at the joints, as a function of x and u.

    It takes the integrated part of the state vector and the output of the amplifiers, and returns efforts
    less friction [N·m | N], inertias [kg·m² | kg] and rates of their states, in the shape of x.

    Args:
        robot: arm with drives.
    """
    code = _sides_code(structure_of(robot))
    constants = code.constants(arm_numbers(robot))
    evaluate = load("drives", code.functions, Engine.PYTHON)

    def sides(x: Array, u: Array) -> Array:
        result = np.empty(len(x))
        evaluate(x, u, constants, result)
        return result

    return sides


@lru_cache(maxsize=64)
def _sides_code(structure: ArmStructure) -> GivenCode:
    return GivenCode.of(Formula("drives", ("x", "u", "side"), _sides(_Traced.of(Tracer(), structure))))


def _evaluated(robot: RobotModel, name: str, x: Array, u: Array, result: Array) -> None:
    """Evaluate a function of the plant once: plain Python is faster than compiling it."""
    code = plant_code(structure_of(robot))
    (source,) = (function for function in code.functions if function.name == name)
    load(name, (source,), Engine.PYTHON)(x, u, _constants(robot), result)


@lru_cache(maxsize=64)
def _constants(robot: RobotModel) -> Array:
    return plant_code(structure_of(robot)).constants(arm_numbers(robot))


def _sides(drives: _Traced) -> list[tuple[str, Scalar]]:
    """Return the efforts on the joints, the inertia of the drives there, and their rates."""
    sides = sides_of(drives.tracer, drives.carried)
    n = len(sides)
    net = [(f"side[{k}]", effort) for k, effort in enumerate(drives.net)]
    inertia = [(f"side[{n + k}]", side.inertia) for k, side in enumerate(sides)]
    return [*net, *inertia, *drives.rates("side")]


def _row(structure: ArmStructure, drives: _Traced) -> list[tuple[str, Scalar]]:
    """Return the entries of `observe`: everything except the reference."""
    layout, x = drives.layout, drives.x
    known = {"q": x[layout.q], "qd": x[layout.qd], "tau": drives.tau}
    states = {field.name: field for field in layout.drives}
    results = []
    for field in LogLayout.of(structure.drives).fields:
        for place, axis in enumerate(field.axes, field.first):
            if field.name in known:
                results.append((f"row[{place}]", known[field.name][axis]))
            elif field.name in states:
                state = states[field.name]
                results.append((f"row[{place}]", x[state.first + state.axes.index(axis)]))
            elif field.name == SUPPLY.name:
                (supply,) = (k for k, axes in enumerate(layout.supplied) if axis in axes)
                results.append((f"row[{place}]", x[layout.supplies.start + supply]))
            elif field.name == structure.drives[axis].amplifier.output.name:
                results.append((f"row[{place}]", drives.carried[axis].given))
    return results
