"""The table of built-in entities: each name is an object of the chain, and another one is one entry."""

from dataclasses import dataclass, fields, replace

import numpy as np
import pytest

from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.flow import ModalState, MoveInstruction
from ropsim.model import Entity, NamedEntity
from ropsim.planning import BUILT_IN, MotionChain, PathPlanner, PlannedPath, Refusal, standard_chain
from ropsim.spatial import Array
from support.cells import with_station
from support.motion import CELL, CHAIN, START, interface_pose, lin, planned_stretch, references, shifted

FIELDS = {
    Entity.PATH_PLANNER: {"planner"},
    Entity.INTERPOLATOR: {"time_law", "robot", "planner"},
    Entity.INVERSE_TRANSFORM: {"inverse"},
    Entity.JOINT_INTERPOLATOR: {"fine"},
    Entity.PATH_CORRECTOR: {"corrector"},
}
NAMES = [(entity, name) for entity, names in BUILT_IN.items() for name in names]
THERE = interface_pose(START)
CORNER = [
    lin(shifted(THERE, -0.1, 0.0, 0.0), ModalState(zone=0.02)),
    lin(shifted(THERE, -0.1, 0.1, 0.0)),
]


def changed(chain: MotionChain) -> set[str]:
    """Return the fields of a chain that are other objects than those of the standard chain."""
    names = {one.name for one in fields(CHAIN)}
    return {name for name in names if getattr(chain, name) is not getattr(CHAIN, name)}


@pytest.mark.parametrize(("entity", "name"), NAMES)
def test_the_first_name_changes_no_object_and_each_other_one_those_of_its_entity(
    entity: Entity, name: str
) -> None:
    found = changed(BUILT_IN[entity][name](CHAIN))
    assert found == (set() if name == next(iter(BUILT_IN[entity])) else FIELDS[entity])


def test_the_sensors_have_no_names() -> None:
    assert set(BUILT_IN) == set(Entity)
    assert [entity for entity in Entity if not BUILT_IN[entity]] == [Entity.SENSOR_INTERFACE]


def test_all_six_chosen_together_are_all_in_the_chain() -> None:
    last = tuple(NamedEntity(one, list(BUILT_IN[one])[-1]) for one in Entity if BUILT_IN[one])
    cell = with_station(CELL, controller=replace(CELL.first.controller, built_in=last))
    chain = standard_chain(cell, cell.first)
    assert set().union(*FIELDS.values()) <= changed(chain)
    planned = chain.planner.plan(CORNER[0], START)
    assert isinstance(planned, PlannedPath)
    assert planned.stops  # the time law with its other robot has left it


@dataclass(frozen=True)
class StoppingAt:
    """A planner of a user that lets the arm stop at the end of some moves."""

    inner: PathPlanner
    visits: tuple[int, ...]

    def plan(self, move: MoveInstruction, q_start: Array) -> PlannedPath | Refusal:
        """Return the plan of the inner one."""
        planned = self.inner.plan(move, q_start)
        assert isinstance(planned, PlannedPath)
        return replace(planned, stops=move.origin.visit in self.visits)


def least_speed(chain: MotionChain) -> float:
    """Return the least speed of the joints in the middle of the corner [rad/s]."""
    plan = planned_stretch([*CORNER[:1], replace_visit(CORNER[1])], chain=chain)
    assert [one for one in plan.findings if one.is_error] == []
    speed = np.abs(references(plan)[1]).max(axis=1)
    return float(speed[20:-20].min())


def replace_visit(move: MoveInstruction) -> MoveInstruction:
    """Return a move that is another one than the first."""
    return replace(move, origin=replace(move.origin, visit=move.origin.visit + 1))


def test_a_path_that_says_so_ends_in_a_stop_and_others_keep_their_zone() -> None:
    first = CORNER[0].origin.visit
    for visits, stops in (((first,), True), ((first + 1,), False)):
        speed = least_speed(replace(CHAIN, planner=StoppingAt(CHAIN.planner, visits)))
        assert (speed < 1e-3) == stops
    assert least_speed(BUILT_IN[Entity.PATH_PLANNER]["exact stops"](CHAIN)) < 1e-3


def test_the_joints_of_the_trapezoidal_law_come_to_their_accelerations_within_ten_microseconds() -> None:
    chain = BUILT_IN[Entity.INTERPOLATOR]["trapezoidal"](CHAIN)
    for joint in chain.robot.joints:
        assert joint.max_acceleration / joint.max_jerk == pytest.approx(1e-5)
    assert getattr(chain.planner, "robot", None) is chain.robot


def test_another_entity_is_one_entry_that_cell_file_and_chain_know(monkeypatch: pytest.MonkeyPatch) -> None:
    def at_first(chain: MotionChain) -> MotionChain:
        return replace(chain, planner=StoppingAt(chain.planner, ()))

    text = '[robot]\nmodel = "puma560"\n[controller.entities]\npath_planner = "flying"\n'
    text += 'interpolator = "trapezoidal"\n'
    before, findings = read_cell(SourceText("", text), "")
    assert [one.code for one in findings] == ["X930"]
    assert before is None or before.first.controller.built_in == ()
    monkeypatch.setitem(BUILT_IN[Entity.PATH_PLANNER], "flying", at_first)
    cell, findings = read_cell(SourceText("", text), "")
    assert not findings
    assert cell is not None
    assert isinstance(standard_chain(cell, cell.first).planner, StoppingAt)
