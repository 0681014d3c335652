"""The standard controller of an arm: its law and gains follow from its model by stated bandwidths.

An arm with electric motors gets computed torque: the law knows masses, tool and part, so that its loops are
the same in every posture and with every load. An arm on hydraulic cylinders or motors gets the law of flow,
load and damping, which knows levers and oil besides. Arms with drives of both kinds get loops of their own,
joint by joint, and so do long chains. An arm without drives follows its reference exactly.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ropsim.dynamics import chain_of, check_model, elastic_axes, structure_of
from ropsim.kinematics import without_linear_loops
from ropsim.model import (
    ControllerKind,
    ControllerModel,
    Drive,
    Gains,
    InputKind,
    Linkage,
    Mechanism,
    NoGains,
    OriginKind,
    ParameterOrigin,
    Rates,
)
from ropsim.robots.default_path_limits import default_path_limits
from ropsim.robots.loops.cascaded_loops import cascade_statement, standard_gains
from ropsim.robots.loops.hydraulic_gains import (
    flow_gains,
    flow_statement,
    parallel_pi_gains,
    pi_statement,
)
from ropsim.robots.loops.hydraulic_loops import (
    LONGEST_SETTLING,
    WINDOW,
    hydraulic_axes,
    hydraulic_crossover,
    hydraulic_statement,
    with_hydraulic_axes,
)
from ropsim.robots.loops.torque_loops import standard_torque_gains, torque_statement

IN_POSITION = 0.2e-3
"""Window of a fine stop [rad | m]."""

SETTLE_TIMEOUT = 1.0
"""Longest wait for a fine stop [s]."""


def standard_controller(robot: Mechanism, rates: Rates) -> ControllerModel:
    """Return the standard controller of an arm: the ideal one where it has no drives.

    Its limits of tool paths are those of `default_path_limits`. They follow from the model: joint limits of a
    cell file do not change them, so that a calibrated cell keeps its path limits.

    Raises:
        JointCountError: links or drives are missing.
        MechanismError: the mechanism cannot be.
    """
    if not robot.drives:
        return _controller(robot, rates, ControllerKind.IDEAL, NoGains(), ())
    check_model(robot)
    return controller_under(robot, rates, possible_laws(robot)[0])


def possible_laws(robot: Mechanism) -> tuple[ControllerKind, ...]:
    """Return the laws that an arm with drives may have, the standard one first."""
    return tuple(kind for kind, law in _LAWS.items() if law.suits(robot))


def controller_under(robot: Mechanism, rates: Rates, law: ControllerKind) -> ControllerModel:
    """Return the controller of an arm with drives under one of its possible laws, with gains from its model.

    Raises:
        JointCountError: links or drives are missing.
        MechanismError: the mechanism cannot be.
    """
    return _LAWS[law].made(robot, rates)


def _torque_controller(robot: Mechanism, rates: Rates) -> ControllerModel:
    gains, origin = standard_torque_gains(robot, rates), _origin(torque_statement(robot, rates))
    return _controller(robot, rates, ControllerKind.COMPUTED_TORQUE, gains, (origin,))


def _flow_controller(robot: Mechanism, rates: Rates) -> ControllerModel:
    gains = flow_gains(robot, rates)
    return _controller(
        robot, rates, ControllerKind.FLOW_LOAD_DAMPING, gains, (_origin(flow_statement(gains)),)
    )


def _pi_controller(robot: Mechanism, rates: Rates) -> ControllerModel:
    gains = parallel_pi_gains(robot, rates)
    return _controller(robot, rates, ControllerKind.PARALLEL_PI, gains, (_origin(pi_statement(gains)),))


def cascaded_controller(robot: Mechanism, rates: Rates) -> ControllerModel:
    """Return the controller of an arm with drives by loops of fixed gains, which people may state.

    Raises:
        NoControllerError: X861, the arm has no drives.
    """
    gains, hydraulic = standard_gains(robot, rates), len(hydraulic_axes(robot))
    statements = [] if hydraulic == robot.n else [cascade_statement(robot, rates)]
    if hydraulic:
        crossover = hydraulic_crossover(robot, rates)
        gains = with_hydraulic_axes(gains, robot, crossover)
        statements.append(hydraulic_statement(crossover))
    origin = _origin("; ".join(statements))
    return _controller(robot, rates, ControllerKind.CASCADED_P_PI, gains, (origin,))


def swings(robot: Mechanism) -> bool:
    """Return whether an arm swings on elastic gears or on its oil: at full speed joints overshoot it then."""
    return bool(robot.drives) and bool(elastic_axes(robot).any() or hydraulic_axes(robot))


def acts_directly(robot: Mechanism) -> bool:
    """Return whether all drives of an arm pass an effort on to its joints at once, and add no inertia."""
    return bool(robot.drives) and all(map(_is_direct, robot.drives))


def _controller(
    robot: Mechanism,
    rates: Rates,
    kind: ControllerKind,
    gains: Gains,
    origins: tuple[ParameterOrigin, ...],
) -> ControllerModel:
    windows, hydraulic = np.full(robot.n, IN_POSITION), hydraulic_axes(robot)
    windows[hydraulic] = WINDOW
    path, path_origins = default_path_limits(robot)
    return ControllerModel(
        kind=kind,
        rates=rates,
        gains=gains,
        path=path,
        in_position=windows,
        settle_timeout=LONGEST_SETTLING if hydraulic else SETTLE_TIMEOUT,
        origins=(*origins, *path_origins),
    )


def _is_hydraulic(robot: Mechanism) -> bool:
    """Return whether all axes of an open chain are hydraulic, without elastic gears."""
    return len(hydraulic_axes(robot)) == robot.n and not (robot.cuts or elastic_axes(robot).any())


def _is_long(robot: Mechanism) -> bool:
    return structure_of(robot).is_long


def _is_modelled(robot: Mechanism) -> bool:
    """Return whether torques of the model can be commanded: to electric motors, of a short chain.

    Straight-line code of a long chain takes long to compile. Elastic gears of closed chains other than
    parallelograms have no feed-forward.
    """
    levers = any(isinstance(drive.transmission, Linkage) for drive in robot.drives)
    sways = elastic_axes(robot).any() and bool(without_linear_loops(robot).cuts)
    return not (levers or hydraulic_axes(robot) or _is_long(robot) or sways)


def _origin(statement: str) -> ParameterOrigin:
    return ParameterOrigin("controller gains", OriginKind.DERIVED, statement)


def _is_direct(drive: Drive) -> bool:
    chain = chain_of(drive)
    states = (*chain.motor.states, *chain.transmission.states)
    takes_effort = chain.amplifier.kind is InputKind.EFFORT and not states
    return takes_effort and drive.motor.rotor_inertia == 0.0


class _Law(NamedTuple):
    """A law of arms with drives.

    Attributes:
        suits: whether an arm may have it.
        made: the controller with gains from the model.
    """

    suits: Callable[[Mechanism], bool]
    made: Callable[[Mechanism, Rates], ControllerModel]


_LAWS = {
    ControllerKind.FLOW_LOAD_DAMPING: _Law(
        lambda robot: _is_hydraulic(robot) and not _is_long(robot), _flow_controller
    ),
    ControllerKind.COMPUTED_TORQUE: _Law(_is_modelled, _torque_controller),
    ControllerKind.CASCADED_P_PI: _Law(
        lambda robot: not (_is_modelled(robot) and acts_directly(robot)), cascaded_controller
    ),
    ControllerKind.PARALLEL_PI: _Law(_is_hydraulic, _pi_controller),
}
"""Without the ideal one, which no arm with drives has; the first that suits an arm is its standard one."""
