"""All runs of a stretch walked in one compiled loop: what each path and time law tells by itself."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from ropsim import robots
from ropsim.flow import ModalState, MoveInstruction
from ropsim.model import Synchronisation
from ropsim.motion import JointPath, JointPoints
from ropsim.planning.testing import (
    PlannedMove,
    Stop,
    Timing,
    Trajectory,
    blend_between,
    limit_grid_of,
    planned_move_of,
    sections_of,
    segments_of,
    timing_of,
    trajectory_table,
)
from ropsim.spatial import Array
from support.cells import chain_of, one_station
from support.motion import PUMA, RULES, START, interface_pose, lin, ptp, shifted

HERE = interface_pose(START)
GOALS = [shifted(HERE, -0.1, 0.1, 0.0), shifted(HERE, -0.1, 0.1, 0.1), shifted(HERE, 0.0, 0.15, 0.1)]
ZONE = ModalState(zone=0.02)


class Unknown:
    """A path that compiled loops do not know."""

    def __init__(self, path: JointPath) -> None:
        self._path, self.length = path, path.length

    def joints(self, s: Array) -> JointPoints:
        return self._path.joints(s)


def course(moves: list[MoveInstruction], mode: Synchronisation) -> Timing:
    chain = chain_of(one_station("walk", PUMA, replace(robots.default_controller(PUMA), ptp=mode)))
    q, legs = START, []
    for move in moves:
        leg = planned_move_of(chain, move, q)
        assert isinstance(leg, PlannedMove)
        legs.append(leg)
        q = leg.q_end
    found = [blend_between(chain, *pair) for pair in pairwise(legs)]
    corners = [None if isinstance(one, Stop) else one for one in found]
    return timing_of(sections_of(segments_of(legs, corners), RULES), len(legs))


def one_by_one(whole: Timing) -> Timing:
    """Return a course whose paths are walked one by one."""
    return replace(
        whole,
        sections=tuple(
            replace(
                run,
                part=replace(
                    run.part,
                    path_segments=tuple(
                        replace(piece, joints=Unknown(piece.joints)) for piece in run.part.path_segments
                    ),
                ),
            )
            for run in whole.sections
        ),
    )


@pytest.mark.parametrize("mode", list(Synchronisation))
def test_all_runs_in_one_loop_are_bit_by_bit_what_their_paths_tell(mode: Synchronisation) -> None:
    first, second, third = GOALS
    whole = course([lin(first, ZONE), lin(second, ZONE), ptp(third, ZONE), ptp(HERE)], mode)
    assert [len(run.path_segments) for run in whole.sections] == [3, 1, 1]
    assert trajectory_table(whole) is not None
    apart = one_by_one(whole)
    assert trajectory_table(apart) is None
    times = np.linspace(0.0, whole.duration, 400)
    together, each = Trajectory.on(whole).at(times), Trajectory.on(apart).at(times)
    for name in ("q", "d1", "d2"):
        assert getattr(together, name).tolist() == getattr(each, name).tolist()


def test_paths_at_places_of_a_run_are_bit_by_bit_what_they_tell_themselves() -> None:
    first, second, third = GOALS
    whole = course([lin(first, ZONE), lin(second, ZONE), ptp(third)], Synchronisation.PHASE)
    together, each = Trajectory.on(whole), Trajectory.on(one_by_one(whole))
    for number, run in enumerate(whole.sections):
        rows = run.law.at(np.linspace(0.0, run.law.duration, 50))
        assert len(set(rows.path_segments.tolist())) == len(run.path_segments)
        for name in ("q", "d1", "d2"):
            one, other = (getattr(motion.on_section(number, rows), name) for motion in (together, each))
            assert one.tolist() == other.tolist()


def test_a_motion_on_the_same_pieces_at_other_times_is_that_of_the_other_course() -> None:
    first, second, third = GOALS
    moves = [lin(first, ZONE), lin(second, ZONE), ptp(third, ZONE), ptp(HERE)]
    whole = course(moves, Synchronisation.PHASE)
    (part, *others) = (run.part for run in whole.sections)
    bands = limit_grid_of(part, np.linspace(0.0, part.law.duration, 20), 0.0)
    slower = timing_of([bands.slower(0.5).replanned(RULES), *others], len(moves))
    times = np.linspace(0.0, slower.duration, 300)
    timed, anew = Trajectory.on(whole).timed(slower), Trajectory.on(slower)
    assert slower.duration > 1.2 * whole.duration
    assert timed.at(times).q.tolist() == anew.at(times).q.tolist()
