"""Stretches: which moves are known together, and why the arm has to stand at their end."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import cycle

import pytest

from ropsim.flow import (
    AwaitInstruction,
    Comparison,
    GripAction,
    GripInstruction,
    Guard,
    MessageInstruction,
    ModalState,
    MoveInstruction,
    OutputInstruction,
    PathTracking,
    SyncInstruction,
    WaitInstruction,
)
from ropsim.icr import Finished
from ropsim.simulation.testing import (
    MOST_AHEAD,
    MOST_MOVES,
    ProgramSequence,
    Step,
    Steps,
    gather,
    why_it_ends,
)
from support.motion import FINE, lin, ptp

ZONE = ModalState(zone=0.01)
END = Finished(None, 0)
HELLO = MessageInstruction("hello", FINE)
FIRST, SECOND, THIRD = ptp(None, ZONE), lin(None, ZONE), ptp((0.0,) * 6, ZONE)

STANDING: dict[str, tuple[Step, str]] = {
    "the end": (END, "the program ends"),
    "a gripper that closes": (GripInstruction(GripAction.CLOSE, "", FINE), "the gripper closes next"),
    "a gripper that opens": (GripInstruction(GripAction.OPEN, "", FINE), "the gripper opens next"),
    "an output": (OutputInstruction("lamp", 1.0, FINE), "output `lamp` is set next"),
    "a wait": (WaitInstruction(0.5, FINE), "the program waits next"),
    "a wait for a signal": (AwaitInstruction(FINE, channel="go"), "the program waits for `go` next"),
    "an end that needs the arm": (SyncInstruction(FINE, before="HALT"), "the program ends"),
    "an order to stop": (SyncInstruction(FINE, before="STOP"), "the program ends"),
    "a signal": (SyncInstruction(FINE, before="IN"), "the program looks at a signal next"),
    "the time": (SyncInstruction(FINE, before="TIME"), "the program looks at the time next"),
    "the pose": (SyncInstruction(FINE, before="ATTAINED"), "asks for the pose of the arm next"),
    "how a move ended": (SyncInstruction(FINE, before="MET"), "asks next how the move has ended"),
    "an order to wait": (SyncInstruction(FINE), "the program waits here until the arm stands"),
}


def stretch_of(*steps: Step) -> tuple[ProgramSequence, list[Step]]:
    """Return the stretch that begins with the first of these steps, and the steps that it has not taken."""
    left = list(steps)
    first = left.pop(0)
    assert isinstance(first, MoveInstruction)
    return gather(first, Steps(lambda: left.pop(0))), left


def test_a_move_without_a_zone_is_a_stretch_by_itself() -> None:
    stretch, left = stretch_of(ptp(None), FIRST, END)
    assert (stretch.moves, stretch.next) == ((ptp(None),), FIRST)
    assert left == [END]


LINE = lin(None)
TRACKED = replace(LINE, tracking=PathTracking("seam", 0.01))
GUARDED = replace(LINE, guard=Guard("part", Comparison.IS, True))


@pytest.mark.parametrize(
    ("first", "steps", "ahead"),
    [
        (ptp(None), (LINE, SECOND, LINE, ptp(None), LINE, END), (LINE, SECOND, LINE)),
        (ptp(None), (LINE, HELLO, LINE, END), (LINE, LINE)),
        (ptp(None), (LINE, OutputInstruction("lamp", 1.0, FINE), LINE, END), (LINE,)),
        (ptp(None), (LINE, TRACKED, LINE, END), (LINE,)),
        (ptp(None), (GUARDED, LINE, END), (GUARDED,)),
        (replace(ptp(None), guard=GUARDED.guard), (LINE, END), ()),
        (FIRST, (LINE, LINE, END), (LINE,)),
        (LINE, (LINE, END), ()),
        (TRACKED, (LINE, LINE, END), ()),
    ],
)
def test_paths_of_the_tool_behind_the_stop_are_known_ahead(
    first: Step, steps: tuple[Step, ...], ahead: tuple[Step, ...]
) -> None:
    """As far as they keep the posture of a PTP move, and the arm need not stand for the program to go on."""
    assert isinstance(first, MoveInstruction)
    left = iter(steps)
    known = Steps(lambda: next(left))
    stretch = gather(first, known)
    assert stretch.ahead == ahead
    taken = len(stretch.moves) - 1
    assert [known.take() for _ in steps[taken:]] == list(steps[taken:])


def test_a_program_without_an_end_is_looked_at_so_far() -> None:
    assert len(gather(ptp(None), Steps(lambda: LINE)).ahead) == MOST_AHEAD
    assert gather(ptp(None), Steps(lambda: HELLO)).ahead == ()


def test_what_is_told_between_paths_leaves_as_many_of_them_known_ahead() -> None:
    told_between: Iterator[Step] = cycle((HELLO, HELLO, LINE))
    assert len(gather(ptp(None), Steps(lambda: next(told_between))).ahead) == MOST_AHEAD


def test_moves_with_a_zone_go_on_up_to_the_first_without() -> None:
    stretch, left = stretch_of(FIRST, SECOND, lin(None), THIRD, END)
    assert stretch.moves == (FIRST, SECOND, lin(None))
    assert stretch.next == THIRD
    assert left == [END]


def test_a_move_that_a_condition_may_end_is_the_last_of_its_stretch() -> None:
    guarded = replace(SECOND, guard=Guard("part", Comparison.IS, True))
    stretch, left = stretch_of(FIRST, guarded, THIRD, END)
    assert stretch.moves == (FIRST, guarded)
    assert stretch.next == THIRD
    assert left == [END]


def test_moves_to_points_on_the_way_go_on_without_a_zone_of_their_own() -> None:
    passing = lin(None, ModalState(passes=True))
    stretch, _ = stretch_of(passing, lin(None), END)
    assert stretch.moves == (passing, lin(None))


@pytest.mark.parametrize("what", STANDING)
def test_a_stretch_ends_before_what_needs_the_arm_to_stand(what: str) -> None:
    step, why = STANDING[what]
    stretch, left = stretch_of(FIRST, SECOND, step, THIRD)
    assert stretch.moves == (FIRST, SECOND)
    assert stretch.next == step
    assert left == [THIRD]
    assert why in why_it_ends(stretch)


def test_messages_do_not_stop_the_arm_and_belong_to_the_move_behind_them() -> None:
    stretch, _ = stretch_of(FIRST, HELLO, SECOND, HELLO, HELLO, ptp(None), END)
    assert stretch.moves == (FIRST, SECOND, ptp(None))
    assert stretch.messages == ((1, HELLO), (2, HELLO), (2, HELLO))


def test_a_message_behind_a_fine_move_is_said_when_the_arm_stands() -> None:
    stretch, _ = stretch_of(ptp(None), HELLO, FIRST)
    assert stretch.messages == ()
    assert stretch.next == HELLO


def test_the_interpreter_is_asked_for_no_more_than_the_step_behind_the_stretch() -> None:
    def program() -> Iterator[Step]:
        yield SECOND
        yield END
        raise AssertionError("asked too far")

    steps = program()
    assert len(gather(FIRST, Steps(lambda: next(steps))).moves) == 2


def test_a_program_without_end_is_planned_in_parts() -> None:
    endless = cycle((SECOND,))
    stretch = gather(SECOND, Steps(lambda: next(endless)))
    assert len(stretch.moves) == MOST_MOVES
    assert stretch.next == SECOND
    assert why_it_ends(stretch) == f"{MOST_MOVES} moves are planned together at most"
