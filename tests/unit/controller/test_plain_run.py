"""Plain runs: as many moves at once as cost nothing where one of them is left."""

from ropsim.controller.by_identity import ByIdentity
from ropsim.controller.line_legs import line_legs_of
from ropsim.controller.plain_run import MoveWork, run_of
from ropsim.flow import ModalState, MotionKind
from support.motion import CHAIN, START, interface_pose, lin, ptp, shifted

HERE = interface_pose(START)
MODAL = ModalState(zone=0.01)


def test_a_run_ends_in_front_of_another_kind() -> None:
    lines = line_legs_of(CHAIN)
    assert lines
    moves = [lin(HERE, MODAL), lin(HERE, MODAL), ptp(HERE, MODAL), lin(HERE, MODAL)]
    assert len(run_of(moves, 0, MotionKind.LIN, lines.works)) == 2
    assert run_of(moves, 2, MotionKind.LIN, lines.works) == []


def test_what_is_looked_at_from_each_move_on_does_not_grow_with_the_stretch() -> None:
    lines = line_legs_of(CHAIN)
    assert lines
    known, asked = lines.works, list[ModalState]()

    def counted(modal: ModalState) -> MoveWork | None:
        asked.append(modal)
        return known(modal)

    moves = [lin(shifted(HERE, 0.001 * k, 0.0, 0.0), ModalState(zone=0.01)) for k in range(400)]
    assert 8 < len(run_of(moves, 0, MotionKind.LIN, ByIdentity(counted))) == len(asked) < 100
