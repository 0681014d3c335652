import pytest

from ropsim.flow import (
    Comparison,
    GripAction,
    GripInstruction,
    Guard,
    Instruction,
    MessageInstruction,
    ModalState,
    MotionKind,
    MoveInstruction,
    OutputInstruction,
    PostureRequest,
    Side,
    SyncInstruction,
    TargetOrientation,
    Trigger,
    WaitInstruction,
)
from ropsim.icr import (
    Finished,
    Machine,
    MachineOptions,
    Program,
    StillWorld,
    Target,
    UnverifiedError,
    assemble,
    run,
    verify,
)
from ropsim.spatial import Pose

HEAD = """ICR 1.0 t
SOURCE "t.task"
{cap}IO DI part BOOL
IO AI count INT
IO AI force REAL
IO DO lamp BOOL
FRAMEDEF f 1.0 0.0 0.0 1.0 0.0 0.0 0.0
FRAMEDEF g 0.0 2.0 0.0 1.0 0.0 0.0 0.0
TOOLDEF jaws 0.0 0.0 0.1 1.0 0.0 0.0 0.0
TOOLDEF unknown
"""
TARGET = "PUSH POSE 0.1 0.2 0.3 1.0 0.0 0.0 0.0"


def program(main: str, rest: str = "") -> Program:
    """Return the verified program of the instructions of `main`, separated by `/`; capabilities are added."""
    body = "".join(f"  {line.strip()}\n" for line in main.split("/"))
    offers = {
        "MOVE.LIN": "LIN",
        "MOVE.PTP\n": "PTP",
        "MOVE.CIRC": "CIRC",
        "MOVE.SPL": "SPLINE",
        "TRIG": "TRIG",
        "POSTURE": "CONFIG",
        "TURNS": "CONFIG",
        "ORI.FREE": "FREE",
        "GUARD": "GUARD",
        "TRACK": "TRACK",
        "MET": "GUARD",
        "ATTAINED": "POSE",
        "HOME": "PTP",
        "ZONE": "ZONE",
        "MSG": "MSG",
        "GRIP": "GRIP",
        "EXT": "EXT",
    }
    offers |= {
        "IN part": "IO",
        "IN count": "IO",
        "IN lamp": "IO",
        "OUT": "IO",
        " TIME": "CLOCK",
        "MOVE.PTP.J": "JNT",
    }
    names = sorted({offer for word, offer in offers.items() if word in body + rest})
    axes = "REQUIRE AXES 2\n" if "JOINTS" in body else ""
    cap = axes + (f"REQUIRE CAP {' '.join(names)}\n" if names else "")
    made = assemble(HEAD.format(cap=cap) + f"PROC main\n{body}END\n{rest}")
    assert verify(made) == ()
    return made


def flow(main: str, rest: str = "", **inputs: bool | float) -> list[Instruction | Finished]:
    """Return everything that the machine hands out, the end last."""
    world = StillWorld(inputs)
    machine = Machine(program(main, rest), world)
    handed: list[Instruction | Finished] = []
    while not isinstance(step := machine.advance(), Finished):
        world.carry_out(step)
        handed.append(step)
    return [*handed, step]


def trap(main: str, rest: str = "", **inputs: bool | float) -> str:
    end = flow(main, rest, **inputs)[-1]
    assert isinstance(end, Finished)
    return end.trap.code if end.trap else ""


def test_a_move_carries_target_frame_tool_and_a_snapshot_of_the_modal_state() -> None:
    first, second, end = flow(
        f"FRAME f/TOOL jaws/PUSH REAL 0.25/SPD.LIN/{TARGET}/LINE 4/MOVE.LIN/"
        f"PUSH REAL 0.5/SPD.LIN/{TARGET}/MOVE.LIN/HALT"
    )
    assert isinstance(first, MoveInstruction)
    assert isinstance(second, MoveInstruction)
    assert (first.kind, first.target) == (
        MotionKind.LIN,
        Pose.from_tuple((0.1, 0.2, 0.3, 1.0, 0.0, 0.0, 0.0)),
    )
    assert (first.modal.frame, first.modal.X_BK.as_tuple()[0]) == ("f", 1.0)
    assert first.modal.X_MT is not None
    assert (first.modal.tool, first.modal.X_MT.as_tuple()[2]) == ("jaws", 0.1)
    assert (first.modal.path_speed, second.modal.path_speed) == (0.25, 0.5)
    assert str(first.origin.span) == "t.task:4:1"
    assert end == Finished(None, 11)


def test_every_modal_instruction_sets_its_own_field() -> None:
    settings = ["SPD.PTP", "SPD.LIN", "SPD.ORI", "ACC.PTP", "ACC.LIN", "ACC.ORI", "JERK", "ZONE.DIST"]
    pushes = "/".join(f"PUSH REAL 0.{k}/{name}" for k, name in enumerate(settings, start=1))
    (move, _) = flow(f"{pushes}/HOME/HALT")
    assert isinstance(move, MoveInstruction)
    modal = move.modal
    speeds = (modal.ptp_speed, modal.path_speed, modal.orientation_speed)
    accelerations = (modal.ptp_acceleration, modal.path_acceleration, modal.orientation_acceleration)
    assert speeds + accelerations == (0.1, 0.2, 0.3, 0.4, 0.5, 0.6)
    assert (modal.path_jerk, modal.zone) == (0.7, 0.8)


def test_saved_modal_states_come_back_also_through_calls() -> None:
    rest = "PROC fast\n  MODAL.SAVE\n  PUSH REAL 0.9\n  SPD.PTP\n  HOME\n  MODAL.RESTORE\n  RET\nEND\n"
    moves = flow("PUSH REAL 0.5/SPD.PTP/ZONE.FINE/CALL fast/HOME/HALT", rest)[:-1]
    assert [move.modal.ptp_speed for move in moves if isinstance(move, MoveInstruction)] == [0.9, 0.5]


def test_a_changed_modal_state_outlives_the_procedure_that_changed_it() -> None:
    moves = flow("CALL slow/HOME/HALT", "PROC slow\n  PUSH REAL 0.1\n  SPD.PTP\n  RET\nEND\n")[:-1]
    assert [move.modal.ptp_speed for move in moves if isinstance(move, MoveInstruction)] == [0.1]


def test_a_modal_state_that_comes_back_in_a_loop_is_the_same_object() -> None:
    rest = "PROC fast\n  MODAL.SAVE\n  PUSH REAL 0.9\n  SPD.PTP\n  HOME\n  MODAL.RESTORE\n  RET\nEND\n"
    moves = flow("PUSH REAL 0.5/SPD.PTP/CALL fast/CALL fast/PUSH REAL 0.9/SPD.LIN/CALL fast/HALT", rest)[:-1]
    first, second, third = [move.modal for move in moves if isinstance(move, MoveInstruction)]
    assert first is second
    assert (first.path_speed, third.path_speed) == (None, 0.9)


def pose(x: float, *rest: object) -> str:
    return " ".join(map(str, ("PUSH POSE", x, 0.0, 0.3, 0.0, 1.0, 0.0, 0.0, *rest)))


def places(move: object) -> tuple[list[float], float]:
    """Return x of the via points and of the target."""
    assert isinstance(move, MoveInstruction)
    assert isinstance(move.target, Pose)
    return [one.as_tuple()[0] for one in move.via], move.target.as_tuple()[0]


def test_an_arc_leads_through_one_pose_and_a_curve_through_any_number() -> None:
    arc, part, curve, _ = flow(
        f"{pose(0.1)}/{pose(0.2)}/MOVE.CIRC/{pose(0.3)}/{pose(0.4)}/PUSH REAL 7.5/MOVE.CIRC.A/"
        f"{pose(0.5)}/{pose(0.6)}/{pose(0.7)}/MOVE.SPL 3/HALT"
    )
    assert (places(arc), places(part), places(curve)) == (([0.1], 0.2), ([0.3], 0.4), ([0.5, 0.6], 0.7))
    assert isinstance(arc, MoveInstruction)
    assert isinstance(part, MoveInstruction)
    assert isinstance(curve, MoveInstruction)
    assert (arc.kind, arc.angle) == (MotionKind.CIRC, None)
    assert (part.kind, part.angle) == (MotionKind.CIRC, 7.5)
    assert curve.kind == MotionKind.SPLINE


def test_after_an_arc_or_a_curve_the_pose_commanded_last_is_its_target() -> None:
    for words in ("MOVE.CIRC", "MOVE.SPL 2"):
        *_, move, _ = flow(f"{pose(0.1)}/{pose(0.2)}/{words}/CURPOSE/MOVE.LIN/HALT")
        assert places(move) == ([], 0.2)


def test_where_an_arc_of_an_angle_ends_is_not_known() -> None:
    assert trap(f"{pose(0.1)}/{pose(0.2)}/PUSH REAL 1.0/MOVE.CIRC.A/CURPOSE/POP/HALT") == "I465"


@pytest.mark.parametrize("angle", [0.0, -1.0])
def test_an_angle_that_is_computed_must_be_greater_than_zero(angle: float) -> None:
    text = f"PUSH REAL {angle}/PUSH REAL 0.0/ADD.R/MOVE.CIRC.A"
    assert trap(f"{pose(0.1)}/{pose(0.2)}/{text}/HALT") == "I461"


def test_the_points_of_a_path_lie_in_the_frame_of_its_target() -> None:
    both = f"{pose(0.1)}/INFRAME g/{pose(0.2)}/INFRAME g"
    (arc, _) = flow(f"FRAME f/{both}/MOVE.CIRC/HALT")
    assert isinstance(arc, MoveInstruction)
    assert (arc.modal.frame, places(arc)) == ("g", ([0.1], 0.2))
    assert trap(f"FRAME f/{pose(0.1)}/{pose(0.2)}/INFRAME g/MOVE.CIRC/HALT") == "I465"
    assert trap(f"FRAME f/{pose(0.1)}/INFRAME g/{pose(0.2)}/MOVE.SPL 2/HALT") == "I465"


def test_a_via_point_has_the_external_values_of_the_target_or_none() -> None:
    for via in (pose(0.1), pose(0.1, "EXT", 0.8)):
        (arc, _) = flow(f"{via}/{pose(0.2, 'EXT', 0.8)}/MOVE.CIRC/HALT")
        assert isinstance(arc, MoveInstruction)
        assert arc.external == (0.8,)
    assert trap(f"{pose(0.1, 'EXT', 0.8)}/{pose(0.2)}/MOVE.CIRC/HALT") == "I461"
    assert trap(f"{pose(0.1, 'EXT', 0.8)}/{pose(0.2, 'EXT', 0.9)}/MOVE.SPL 2/HALT") == "I461"


def test_a_posture_and_turns_go_wherever_the_pose_goes() -> None:
    left = f"{pose(0.1)}/POSTURE left-up/PUSH INT 0/PUSH INT -1/TURNS 2"
    wanted = PostureRequest(("left", "up"), (0, -1))
    step = "PUSH POSE 0.0 0.0 0.1 1.0 0.0 0.0 0.0"
    for text in (
        left,
        f"{left}/{step}/COMPOSE",
        f"{step}/{left}/COMPOSE",
        f"{left}/PUSH REAL 0.5/SETC 2",
        f"{left}/INFRAME g",
        f"{left}/PUSH REAL 0.5/MKEXT 1",
        f"{pose(0.1, 'EXT', 0.5)}/PUSH INT 0/PUSH INT -1/TURNS 2/INFRAME g/POSTURE left-up",
        f"{left}/MOVE.LIN/CURPOSE",
        f"{pose(0.3)}/{left}/MOVE.CIRC/CURPOSE",
    ):
        *_, move, _ = flow(f"{text}/MOVE.PTP/HALT")
        assert isinstance(move, MoveInstruction)
        assert move.posture == wanted, text


def test_a_free_orientation_goes_wherever_the_pose_goes() -> None:
    free = f"{pose(0.1)}/ORI.FREE"
    step = "PUSH POSE 0.0 0.0 0.1 1.0 0.0 0.0 0.0"
    for text in (
        free,
        f"{free}/{step}/COMPOSE",
        f"{step}/{free}/COMPOSE",
        f"{free}/PUSH REAL 0.5/SETC 2",
        f"{free}/INFRAME g",
        f"{free}/ORI.FREE",
        f"{pose(0.1)}/INFRAME g/ORI.FREE",
    ):
        *_, move, _ = flow(f"{text}/MOVE.LIN/HALT")
        assert isinstance(move, MoveInstruction)
        assert move.has_free_orientation, text
    *_, move, _ = flow(f"{pose(0.1)}/POSTURE left/ORI.FREE/PUSH INT 1/TURNS 1/MOVE.PTP/HALT")
    assert isinstance(move, MoveInstruction)
    assert move.posture == PostureRequest(("left",), (1,), TargetOrientation.FREE)


def test_where_the_tool_is_after_a_move_with_free_orientation_is_read_from_the_arm() -> None:
    (move, sync, *_) = flow(f"{pose(0.1)}/ORI.FREE/MOVE.PTP/CURPOSE/MOVE.LIN/HALT")
    assert isinstance(move, MoveInstruction)
    assert isinstance(sync, SyncInstruction)
    assert sync.before == "CURPOSE"


def test_of_a_path_all_points_are_free_or_its_target_alone() -> None:
    for via in (pose(0.1), f"{pose(0.1)}/ORI.FREE"):
        (arc, _) = flow(f"{via}/{pose(0.2)}/ORI.FREE/MOVE.CIRC/HALT")
        assert isinstance(arc, MoveInstruction)
        assert arc.has_free_orientation
    assert trap(f"{pose(0.1)}/ORI.FREE/{pose(0.2)}/MOVE.CIRC/HALT") == "I461"


def test_of_two_postures_that_of_the_left_pose_counts_and_an_inverse_has_none() -> None:
    both = f"{pose(0.1)}/POSTURE left/{pose(0.2)}/POSTURE right"
    (move, inverse, _) = flow(f"{both}/COMPOSE/DUP/MOVE.PTP/INV/MOVE.PTP/HALT")
    assert isinstance(move, MoveInstruction)
    assert isinstance(inverse, MoveInstruction)
    assert (move.posture, inverse.posture) == (PostureRequest(("left",)), None)


def test_a_pose_shows_what_it_asks_of_the_arm() -> None:
    text = f"{pose(0.1)}/POSTURE left-up/PUSH INT -1/TURNS 1/PUSH REAL 0.8/MKEXT 1/INFRAME g/FMT/MSG/HALT"
    (message, _) = flow(text)
    assert isinstance(message, MessageInstruction)
    assert message.text.endswith(" external (0.8) config (left, up) turns (-1) in g")


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ("REAL -0.0", "0"),
        ("REAL -1.2e-15", "-1.2e-15"),  # a number of the user: nobody knows its size
        ("VEC -1.2e-15 -0.0 1e-6", "(0, 0, 1e-06)"),
        ("VEC 120.0000000004 -3.5 1234.56789", "(120, -3.5, 1234.57)"),
        ("POSE -1.2e-15 0.3000000001 1e-9 1.0 0.0 -1e-16 0.0", "(0, 0.3, 1e-09, 0, 0, 0)"),
        ("JOINTS 1e-13 -1e-13", "(0, 0)"),
    ],
)
def test_a_value_is_shown_without_the_noise_of_its_computation(value: str, text: str) -> None:
    (message, _) = flow(f"PUSH {value}/FMT/MSG/HALT")
    assert isinstance(message, MessageInstruction)
    assert message.text == text


def test_a_via_point_has_the_posture_of_the_target_or_none() -> None:
    left, right = (f"{pose(x)}/POSTURE {word}" for x, word in ((0.1, "left"), (0.2, "right")))
    assert trap(f"{left}/{right}/MOVE.CIRC/HALT") == "I461"
    assert trap(f"{left}/{pose(0.2)}/MOVE.CIRC/HALT") == "I461"
    assert trap(f"{pose(0.1)}/{right}/MOVE.CIRC/HALT") == ""


TRIGGERS = (
    "PUSH BOOL TRUE/PUSH REAL 0.003/TRIG.DIST after lamp/PUSH BOOL FALSE/PUSH REAL 0.2/TRIG.TIME before lamp"
)


@pytest.mark.parametrize(
    "move", ["HOME", f"{TARGET}/MOVE.PTP", f"{TARGET}/MOVE.LIN", f"{TARGET}/DUP/MOVE.CIRC"]
)
def test_triggers_belong_to_the_next_move_only(move: str) -> None:
    first, second, _ = flow(f"{TRIGGERS}/{move}/{move}/HALT")
    assert isinstance(first, MoveInstruction)
    assert isinstance(second, MoveInstruction)
    assert first.triggers == (
        Trigger("lamp", True, Side.AFTER_START, distance=0.003),
        Trigger("lamp", False, Side.BEFORE_END, time=0.2),
    )
    assert second.triggers == ()


def test_what_a_trigger_sets_is_read_after_its_move() -> None:
    before, after = "IN lamp/FMT/MSG", "IN lamp/FMT/MSG"
    text = f"{before}/PUSH BOOL TRUE/PUSH REAL 0.003/TRIG.DIST after lamp/HOME/{after}/HALT"
    shown = [one.text for one in flow(text) if isinstance(one, MessageInstruction)]
    assert shown == ["false", "true"]


def test_the_place_of_a_trigger_that_is_computed_is_not_negative() -> None:
    place = "PUSH REAL 0.0/PUSH REAL 0.1/SUB.R"
    assert trap(f"PUSH BOOL TRUE/{place}/TRIG.DIST after lamp/HOME/HALT") == "I461"


def test_a_snapshot_keeps_the_triggers_of_the_next_move() -> None:
    text = f"{TRIGGERS}/IN part/POP/HOME/HALT"
    machine = Machine(program(text), StillWorld())
    assert isinstance(machine.advance(), SyncInstruction)
    state = machine.snapshot()
    resumed = Machine.resume(program(text), StillWorld(), state).advance()
    assert isinstance(resumed, MoveInstruction)
    assert len(resumed.triggers) == 2


@pytest.mark.parametrize(
    ("text", "guard"),
    [
        ("PUSH BOOL FALSE/PUSH REAL 2.5/GUARD is part", Guard("part", Comparison.IS, False, 2.5)),
        ("PUSH BOOL TRUE/PUSH REAL 0.0/GUARD is part", Guard("part", Comparison.IS, True)),
        ("PUSH REAL 15.0/PUSH REAL -1.0/GUARD above force", Guard("force", Comparison.ABOVE, 15.0)),
        ("PUSH INT 3/PUSH REAL 0.0/GUARD below count", Guard("count", Comparison.BELOW, 3.0)),
    ],
)
def test_a_guard_belongs_to_the_next_move_only(text: str, guard: Guard) -> None:
    first, second, _ = flow(f"{text}/{TARGET}/MOVE.LIN/HOME/HALT")
    assert isinstance(first, MoveInstruction)
    assert isinstance(second, MoveInstruction)
    assert (first.guard, second.guard) == (guard, None)
    assert first.guard is not None
    assert type(first.guard.value) is type(guard.value)


@pytest.mark.parametrize(
    ("guard", "inputs", "met"),
    [
        ("PUSH BOOL TRUE/PUSH REAL 0.0/GUARD is part", {"part": True}, True),
        ("PUSH BOOL TRUE/PUSH REAL 0.0/GUARD is part", {"part": False}, False),
        ("PUSH BOOL FALSE/PUSH REAL 0.0/GUARD is part", {"part": False}, True),
        ("PUSH REAL 15.0/PUSH REAL 0.0/GUARD above force", {"force": 15.0}, False),
        ("PUSH REAL 15.0/PUSH REAL 0.0/GUARD above force", {"force": 15.5}, True),
        ("PUSH REAL 15.0/PUSH REAL 0.0/GUARD below force", {"force": 15.0}, False),
        ("PUSH REAL 15.0/PUSH REAL 0.0/GUARD below force", {"force": 14.5}, True),
    ],
)
def test_a_program_is_told_whether_the_condition_came_true(
    guard: str, inputs: dict[str, bool | float], met: bool
) -> None:
    (*_, message, _) = flow(f"{guard}/{TARGET}/MOVE.LIN/MET/FMT/MSG/HALT", "", **inputs)
    assert isinstance(message, MessageInstruction)
    assert message.text == ("true" if met else "false")


@pytest.mark.parametrize("asked", ["ATTAINED", "CURPOSE"])
def test_where_a_guarded_move_ends_is_read_when_it_has_ended(asked: str) -> None:
    guarded = f"PUSH BOOL TRUE/PUSH REAL 0.0/GUARD is part/{TARGET}/MOVE.LIN"
    *_, sync, last, _ = flow(f"{guarded}/{asked}/MOVE.LIN/HALT")
    assert isinstance(sync, SyncInstruction)
    assert (sync.before, places(last)) == (asked, ([], 0.1))


def test_the_attained_pose_is_seen_in_the_frame_in_force_for_the_tool_in_force() -> None:
    *_, last, _ = flow(f"FRAME f/{TARGET}/MOVE.LIN/FRAME -/ATTAINED/MOVE.LIN/HALT")
    assert places(last) == ([], 1.1)
    assert trap(f"{TARGET}/MOVE.LIN/TOOL jaws/ATTAINED/POP/HALT") == "I465"
    assert trap("HOME/ATTAINED/POP/HALT") == "I465"
    assert trap("ATTAINED/POP/HALT") == "I465"


def test_a_snapshot_keeps_the_guard_of_the_next_move() -> None:
    text = f"PUSH BOOL TRUE/PUSH REAL 0.0/GUARD is part/IN part/POP/{TARGET}/MOVE.LIN/HALT"
    machine = Machine(program(text), StillWorld())
    assert isinstance(machine.advance(), SyncInstruction)
    resumed = Machine.resume(program(text), StillWorld(), machine.snapshot()).advance()
    assert isinstance(resumed, MoveInstruction)
    assert resumed.guard == Guard("part", Comparison.IS, value=True)


def test_a_via_zone_passes_by_until_another_zone_is_said() -> None:
    steps = ["HOME", "ZONE.VIA", "HOME", "PUSH REAL 0.02", "ZONE.DIST", "HOME", "ZONE.VIA", "HOME"]
    moves = flow("/".join([*steps, "ZONE.FINE", "HOME", "HALT"]))[:-1]
    zones = [(one.modal.zone, one.modal.passes) for one in moves if isinstance(one, MoveInstruction)]
    assert zones == [(0.0, False), (0.0, True), (0.02, False), (0.02, True), (0.0, False)]


def test_the_other_robot_instructions_become_their_records() -> None:
    text = "PUSH JOINTS 0.1 0.2/MOVE.PTP.J/HOME/GRIP close jaws/"
    text += 'PUSH BOOL TRUE/OUT lamp/PUSH REAL 0.2/WAIT.T/PUSH STR "a"/MSG/SYNC/HALT'
    joints, home, grip, output, wait, message, sync, _ = flow(text)
    assert isinstance(joints, MoveInstruction)
    assert isinstance(home, MoveInstruction)
    assert (joints.target, home.target, home.kind) == ((0.1, 0.2), None, MotionKind.PTP)
    assert isinstance(grip, GripInstruction)
    assert (grip.action, grip.tool) == (GripAction.CLOSE, "jaws")
    assert isinstance(output, OutputInstruction)
    assert (output.channel, output.value) == ("lamp", True)
    assert isinstance(wait, WaitInstruction)
    assert wait.duration == 0.2
    assert isinstance(message, MessageInstruction)
    assert message.text == "a"
    assert isinstance(sync, SyncInstruction)


def test_visits_count_how_often_one_instruction_was_carried_out() -> None:
    loop = "PUSH INT 0/L0:/HOME/PUSH INT 1/ADD.I/DUP/PUSH INT 3/LT.I/JT L0/POP/HOME/HALT"
    moves = flow(loop)[:-1]
    assert [move.origin.visit for move in moves if isinstance(move, MoveInstruction)] == [1, 2, 3, 1]


def test_origins_name_the_active_procedures_and_the_ordinals_of_their_activations() -> None:
    rest = "PROC a\n  CALL b\n  RET\nEND\nPROC b\n  HOME\n  RET\nEND\n"
    moves = flow("CALL a/CALL b/CALL a/HOME/HALT", rest)[:-1]
    chains = [
        (move.origin.calls, move.origin.call_serials) for move in moves if isinstance(move, MoveInstruction)
    ]
    assert chains == [
        (("main", "a", "b"), (0, 1, 2)),
        (("main", "b"), (0, 3)),
        (("main", "a", "b"), (0, 4, 5)),
        (("main",), (0,)),
    ]


def test_bare_interface_and_tool_left_to_the_cell_differ() -> None:
    modals = [
        one.modal
        for one in flow("HOME/TOOL -/HOME/TOOL unknown/HOME/FRAME -/HOME/HALT")[:-1]
        if not isinstance(one, Finished)
    ]
    assert [(modal.tool, modal.X_MT) for modal in modals] == [
        ("", None),
        ("", Pose()),
        ("unknown", None),
        ("unknown", None),
    ]


class Recorder:
    """A world that notes when it is asked."""

    def __init__(self) -> None:
        self.asked: list[str] = []

    def read(self, channel: str) -> bool | int | float:
        self.asked.append(f"read {channel}")
        return 1

    def wait(self, channel: str, value: bool, timeout: float | None) -> bool:
        self.asked.append(f"wait {channel} {value} {timeout}")
        return True

    def time(self) -> float:
        self.asked.append("time")
        return 2.5

    def met(self) -> bool:
        self.asked.append("met")
        return True

    def attained(self, modal: ModalState) -> Pose:
        self.asked.append(f"attained {modal.tool}")
        return Pose()

    def commanded(self, modal: ModalState) -> Pose:
        self.asked.append(f"commanded {modal.tool}")
        return Pose()

    def reached(self, target: Target, then: ModalState, now: ModalState) -> Pose | None:
        del then, now
        self.asked.append(f"reached {target}")
        return Pose() if target == FOLDED else None


@pytest.mark.parametrize(
    ("code", "asked"),
    [
        ("IN part/POP", "read part"),
        ("TIME/POP", "time"),
        ("PUSH BOOL TRUE/PUSH REAL 1.5/WAIT.IN part/POP", "wait part True 1.5"),
        ("PUSH BOOL FALSE/PUSH REAL 0.0/WAIT.IN part/POP", "wait part False None"),
        ("MET/POP", "met"),
        ("ATTAINED/POP", "attained "),
    ],
)
def test_the_world_is_asked_only_after_a_synchronisation(code: str, asked: str) -> None:
    world = Recorder()
    machine = Machine(program(f"HOME/{code}/HALT"), world)
    assert isinstance(machine.advance(), MoveInstruction)
    assert isinstance(machine.advance(), SyncInstruction)
    assert world.asked == []
    assert machine.advance() == Finished(None, 2 + len(code.split("/")))
    assert world.asked == [asked]


def asked_between(code: str) -> tuple[list[str], list[str]]:
    """Return what code asks of the world, and before which instructions it waits until all is done."""
    world, waits = Recorder(), []
    machine = Machine(program(f"{code}/HALT"), world)
    while not isinstance(one := machine.advance(), Finished):
        waits += [one.before] if isinstance(one, SyncInstruction) else []
    assert one.trap is None
    return world.asked, waits


FOLDED = (0.25, 0.5)


@pytest.mark.parametrize(
    ("code", "asked", "waits"),
    [
        ("CURPOSE/POP", ["commanded "], ["CURPOSE"]),
        ("HOME/CURPOSE/POP", ["reached None", "commanded "], ["CURPOSE"]),
        ("PUSH JOINTS 0.25 0.5/MOVE.PTP.J/CURPOSE/POP", [f"reached {FOLDED}"], []),
        (f"{pose(0.1)}/MOVE.LIN/CURPOSE/POP", [], []),
        (f"{pose(0.1)}/{pose(0.2)}/PUSH REAL 1.0/MOVE.CIRC.A/CURPOSE/POP", ["commanded "], ["CURPOSE"]),
        ("CURPOSE/POP/CURPOSE/POP", ["commanded "], ["CURPOSE"]),
    ],
)
def test_the_command_pose_waits_for_the_arm_only_where_the_last_move_does_not_tell_it(
    code: str, asked: list[str], waits: list[str]
) -> None:
    assert asked_between(code) == (asked, waits)


def test_an_output_reads_back_as_it_was_set() -> None:
    text = "PUSH BOOL TRUE/OUT lamp/IN lamp/JT L0/TRAP 100/L0:/HALT"
    assert trap(text.replace("IN lamp", "IN part/POP/IN lamp")) == ""


def test_stop_waits_for_the_motion_and_ends_with_its_category() -> None:
    _, sync, end = flow("HOME/STOP 1")
    assert isinstance(sync, SyncInstruction)
    assert end == Finished(None, 2, 1)


def test_the_end_stays_the_end() -> None:
    machine = Machine(program("HALT"), StillWorld())
    assert machine.advance() == machine.advance() == Finished(None, 1)


def test_command_pose_is_seen_from_the_frame_and_tool_in_force() -> None:
    instructions = flow(
        f"FRAME f/TOOL jaws/{TARGET}/MOVE.PTP/CURPOSE/MOVE.LIN/FRAME g/TOOL -/CURPOSE/MOVE.LIN/HALT"
    )
    moves = [one for one in instructions if isinstance(one, MoveInstruction)]
    poses = [move.target.as_tuple()[:3] for move in moves if isinstance(move.target, Pose)]
    assert poses[0] == poses[1] == (0.1, 0.2, 0.3)
    assert poses[2] == pytest.approx((1.1, -1.8, 0.2), abs=1e-15)


@pytest.mark.parametrize(
    ("code", "expected"),
    [
        ("PUSH INT 1/PUSH INT 0/DIV.I/POP", "I460"),
        ("PUSH REAL 1.0/PUSH REAL 0.0/MOD.R/POP", "I460"),
        ("PUSH REAL -1.0/SQRT/POP", "I461"),
        ("PUSH REAL 1e308/DUP/ADD.R/POP", "I461"),
        ("PUSH REAL 1e200/DUP/MUL.R/POP", "I461"),
        ("PUSH REAL 2.0/ASIN/POP", "I461"),
        ("PUSH REAL 0.0/PUSH REAL -1.0/POW/POP", "I461"),
        ("PUSH REAL 1e30/TRUNC/POP", "I461"),
        ("PUSH INT 9223372036854775807/PUSH INT 1/ADD.I/POP", "I461"),
        ("PUSH INT -9223372036854775808/PUSH INT 1/SUB.I/POP", "I461"),
        ("PUSH INT -9223372036854775808/NEG.I/POP", "I461"),
        ("PUSH REAL 0.0/DUP/DUP/DUP/MKORI.Q/POP", "I461"),
        ("PUSH VEC 1e308 0.0 0.0/DUP/ADD.V/POP", "I461"),
        ("PUSH REAL 0.5/PUSH REAL 0.5/SUB.R/SPD.LIN", "I461"),
        ("PUSH REAL 1.0/PUSH REAL 0.5/ADD.R/ACC.PTP", "I461"),
        ("PUSH REAL 0.5/NEG.R/WAIT.T", "I461"),
        ('PUSH STR "ab"/L0:/DUP/CAT/JMP L0', "I461"),
        ("PUSH BOOL TRUE/PUSH REAL 0.0/WAIT.IN part/POP", "I462"),
        ("TRAP 1", "I462"),
        ("TRAP 2", "I461"),
        ("TRAP 100", "I464"),
        ("CURPOSE/POP", "I465"),
        ("HOME/CURPOSE/POP", "I465"),
        (f"{TARGET}/MOVE.PTP/TOOL unknown/CURPOSE/POP", "I465"),
        ("L0:/NOP/JMP L0", "I463"),
    ],
)
def test_a_fault_is_a_typed_trap(code: str, expected: str) -> None:
    ends = code.startswith("TRAP") or "JMP" in code
    made = program(f"LINE 12/{code}" + ("" if ends else "/HALT"))
    end = run(made, budget=10_000).trap
    assert end is not None
    assert (end.code, str(end.span)) == (expected, "t.task:12:1")


def test_a_trap_shows_the_active_procedures() -> None:
    rest = "PROC a\n  LINE 9\n  PUSH INT 1\n  PUSH INT 0\n  DIV.I\n  POP\n  RET\nEND\n"
    end = flow("CALL a/HALT", rest)[-1]
    assert isinstance(end, Finished)
    assert end.trap is not None
    assert end.trap.notes == ("active procedures: main -> a",)
    assert str(end.trap.span) == "t.task:9:1"


def test_a_reading_that_is_not_finite_is_a_trap() -> None:
    assert trap("IN count/POP/HALT", count=float("inf")) == "I461"
    assert trap("IN count/POP/HALT", count=float("nan")) == "I461"


def test_the_budget_ends_a_loop_exactly() -> None:
    machine = Machine(program("L0:/NOP/JMP L0"), StillWorld(), MachineOptions(budget=1001))
    end = machine.advance()
    assert isinstance(end, Finished)
    assert end.steps == 1001


def test_a_trace_is_bounded_where_a_program_moves_for_ever() -> None:
    found = run(program("L0:/SYNC/JMP L0")).trap
    assert found is not None
    assert found.code == "I463"


def test_a_still_world_lets_time_pass_by_waiting() -> None:
    text = (
        "PUSH REAL 0.5/WAIT.T/PUSH BOOL TRUE/PUSH REAL 1.5/WAIT.IN part/JT L0/"
        "TIME/FMT/MSG/L0:/PUSH BOOL FALSE/PUSH REAL 0.0/WAIT.IN part/FMT/MSG/HALT"
    )
    assert run(program(text)).messages == ("2", "true")


def test_run_refuses_what_the_verifier_refuses() -> None:
    with pytest.raises(UnverifiedError) as caught:
        run(assemble("ICR 1.0 t\nPROC main\n  POP\n  HALT\nEND\n"))
    assert [one.code for one in caught.value.diagnostics] == ["I416"]


def test_a_machine_that_falls_off_the_end_of_an_unverified_program_says_so() -> None:
    machine = Machine(assemble("ICR 1.0 t\nPROC main\n  NOP\n  NOP\nEND\n"), StillWorld())
    with pytest.raises(UnverifiedError) as caught:
        machine.advance()
    assert [one.code for one in caught.value.diagnostics] == ["I420"]


def test_a_trap_behind_jumps_and_calls_stands_where_it_came() -> None:
    text = "PUSH INT 3/STORE n/L0:/LOAD n/PUSH INT 1/SUB.I/STORE n/LOAD n/PUSH INT 0/GT.I/JT L0/CALL p/HALT"
    rest = "PROC p\n  NOP\n  PUSH INT 1\n  LOAD n\n  DIV.I\n  POP\n  RET\nEND\n"
    source = "\n".join(("ICR 1.0 t", "VAR n INT", "PROC main", *text.split("/"), "END", rest))
    found = run(assemble(source))
    assert found.trap is not None
    assert found.trap.code == "I460"
    assert found.trap.span is not None
    assert found.trap.span.line == source.split("\n").index("  DIV.I") + 1
    assert found.steps == 2 + 3 * 8 + 1 + 4


def test_a_trace_sorts_its_instructions() -> None:
    trace = run(program('HOME/GRIP open -/PUSH BOOL FALSE/OUT lamp/PUSH STR "x"/MSG/SYNC/HALT'))
    assert (len(trace.moves), len(trace.grips), len(trace.io), trace.messages) == (1, 1, 1, ("x",))
    assert len(trace.instructions) == 4
    assert (trace.trap, trace.steps) == (None, 8)


RICH = """L0:/PUSH INT 1/IN count/ADD.I/POP/MODAL.SAVE/PUSH REAL 0.5/SPD.PTP/HOME/CALL a/MODAL.RESTORE/
TIME/PUSH REAL 6.0/LT.R/JT L0/PUSH BOOL TRUE/OUT lamp/IN lamp/FMT/MSG/HALT"""
RICH_REST = f"PROC a\n  {TARGET}\n  MOVE.PTP\n  CURPOSE\n  MOVE.LIN\n  PUSH REAL 1.0\n  WAIT.T\n  RET\nEND\n"


class Ticking(StillWorld):
    """A world whose answers depend on a clock outside the machine."""

    def __init__(self, clock: float = 0.0) -> None:
        super().__init__()
        self.clock = clock

    def read(self, channel: str) -> bool | int | float:
        return int(self.clock) + len(channel)

    def time(self) -> float:
        return self.clock


def test_a_resumed_machine_goes_on_in_exactly_the_same_way() -> None:
    made = program(RICH.replace("\n", ""), RICH_REST)
    world = Ticking()
    machine = Machine(made, world)
    straight: list[Instruction | Finished] = []
    states = []
    while not straight or not isinstance(straight[-1], Finished):
        states.append((machine.snapshot(), world.clock))
        straight.append(machine.advance())
        world.clock += 0.25
    states.append((machine.snapshot(), world.clock))
    assert len(straight) > 20
    for number, (state, clock) in enumerate(states):
        world = Ticking(clock)
        resumed = Machine.resume(made, world, state)
        assert resumed.snapshot() == state
        for expected in straight[number:]:
            assert resumed.advance() == expected
            world.clock += 0.25


def test_a_snapshot_does_not_change_when_the_machine_goes_on() -> None:
    machine = Machine(program(RICH.replace("\n", ""), RICH_REST), Ticking())
    state = machine.snapshot()
    before = repr(state)
    for _ in range(5):
        machine.advance()
    assert repr(state) == before
    assert hash(state) == hash(state)


def moves(main: str) -> list[MoveInstruction]:
    return [one for one in flow(main) if isinstance(one, MoveInstruction)]


def external(main: str) -> list[tuple[float, ...]]:
    """Return the values of external axes that each move is given."""
    return [one.external for one in moves(f"{main}/HALT")]


def test_a_move_carries_the_external_values_of_its_pose() -> None:
    (plain, made) = moves(f"{TARGET}/MOVE.LIN/{TARGET} EXT 0.8 -1.5/MOVE.PTP/HALT")
    assert (plain.external, made.external) == ((), (0.8, -1.5))
    assert plain.target == made.target


def test_external_values_are_given_and_given_anew() -> None:
    given = f"{TARGET}/PUSH REAL 0.5/PUSH REAL 0.25/MKEXT 2"
    assert external(f"{given}/MOVE.PTP") == [(0.5, 0.25)]
    assert external(f"{given}/PUSH REAL -1.0/MKEXT 1/MOVE.PTP") == [(-1.0,)]


def test_a_place_that_is_kept_keeps_its_external_values() -> None:
    pose, other = f"{TARGET} EXT 0.5", "PUSH POSE 0.0 0.0 0.1 1.0 0.0 0.0 0.0"
    assert external(f"{pose}/{other}/COMPOSE/MOVE.PTP") == [(0.5,)]
    assert external(f"{other}/{pose}/COMPOSE/MOVE.PTP") == [(0.5,)]
    assert external(f"{pose}/{other} EXT 0.25/COMPOSE/MOVE.PTP") == [(0.5,)]
    for component in range(6):
        assert external(f"{pose}/PUSH REAL 0.125/SETC {component}/MOVE.PTP") == [(0.5,)]


def test_what_is_no_target_any_more_loses_its_external_values() -> None:
    pose = f"{TARGET} EXT 0.5"
    assert external(f"{pose}/INV/MOVE.PTP") == [()]
    assert external(f"{pose}/GETPOS/{pose}/GETORI/MKPOSE/MOVE.PTP") == [()]


def test_the_pose_commanded_last_is_given_back_with_its_external_values() -> None:
    handed = moves(f"FRAME f/TOOL jaws/{TARGET} EXT 0.5/MOVE.PTP/FRAME g/TOOL -/CURPOSE/MOVE.LIN/HALT")
    assert [one.external for one in handed] == [(0.5,), (0.5,)]
    assert external(f"{TARGET} EXT 0.5/MOVE.PTP/{TARGET}/MOVE.PTP/CURPOSE/MOVE.PTP") == [(0.5,), (), ()]


def test_distances_and_angles_do_not_see_external_values() -> None:
    other = "PUSH POSE 0.1 0.2 0.8 0.0 1.0 0.0 0.0"
    for mnemonic in ("DIST", "ANGLE"):
        plain = flow(f"{TARGET}/{other}/{mnemonic}/FMT/MSG/HALT")
        given = flow(f"{TARGET} EXT 0.5/{other} EXT 2.0/{mnemonic}/FMT/MSG/HALT")
        assert [getattr(one, "text", "") for one in plain] == [getattr(one, "text", "") for one in given]


def test_a_shown_pose_tells_its_external_values() -> None:
    (message, _) = flow(f"{TARGET} EXT 0.5 -1.0/FMT/MSG/HALT")
    assert isinstance(message, MessageInstruction)
    assert message.text == "(0.1, 0.2, 0.3, 0, 0, 0) external (0.5, -1)"


def test_a_place_keeps_the_frame_that_it_stands_in_and_a_change_on_the_left_wins() -> None:
    plain, changed = TARGET, "PUSH POSE 0.0 0.0 0.1 1.0 0.0 0.0 0.0"
    for left, right, frame in [
        (f"{plain}/INFRAME f", changed, "f"),
        (changed, f"{plain}/INFRAME f", "f"),
        (f"{plain}/INFRAME f", f"{changed}/INFRAME g", "f"),
        (f"{plain}/INFRAME g", f"{changed}/INFRAME f", "g"),
    ]:
        (move,) = moves(f"{left}/{right}/COMPOSE/MOVE.PTP/HALT")
        assert move.modal.frame == frame


@pytest.mark.parametrize("mnemonic", ["DIST", "ANGLE"])
def test_poses_in_different_frames_are_not_compared(mnemonic: str) -> None:
    other = "PUSH POSE 0.1 0.2 0.8 0.0 1.0 0.0 0.0"
    for one, two, code in [("f", "f", ""), ("f", "g", "I465"), ("f", "-", "I465"), ("-", "g", "I465")]:
        assert trap(f"{TARGET}/INFRAME {one}/{other}/INFRAME {two}/{mnemonic}/POP/HALT") == code


TURNED = "PUSH ORI 0.7071067811865476 0.0 0.0 0.7071067811865476/AXES"
"""Along x of these axes is along y of the task frame."""
WAY = "PUSH REAL 0.5/PUSH REAL 0.0/PUSH REAL 0.0/MKVEC/OFFSET"


def shifted(text: str) -> tuple[float, ...]:
    """Return the position [m] of the last move."""
    target = moves(f"{text}/MOVE.PTP/HALT")[-1].target
    assert isinstance(target, Pose)
    return tuple(float(part) for part in target.position)


@pytest.mark.parametrize(
    "text",
    [
        f"{TARGET}/{TURNED}/{WAY}",
        f"{TARGET}/{TURNED}/PUSH POSE 0.0 0.0 0.0 1.0 0.0 0.0 0.0/COMPOSE/{WAY}",
        f"PUSH POSE 0.0 0.0 0.0 1.0 0.0 0.0 0.0/{TARGET}/{TURNED}/COMPOSE/{WAY}",
        f"{TARGET}/{TURNED}/PUSH REAL 0.3/SETC 2/{WAY}",
        f"{TARGET}/{TURNED}/PUSH REAL 0.8/MKEXT 1/POSTURE left/PUSH INT 0/TURNS 1/{WAY}",
        f"{TARGET}/{TURNED}/{TURNED}/{WAY}",
    ],
)
def test_a_pose_keeps_the_axes_along_which_it_is_shifted(text: str) -> None:
    assert shifted(text) == pytest.approx((0.1, 0.7, 0.3))


@pytest.mark.parametrize(
    "text",
    [
        f"{TARGET}/{WAY}",
        f"{TARGET}/{TURNED}/PUSH ORI 1.0 0.0 0.0 0.0/AXES/{WAY}",
        f"{TARGET}/INFRAME g/{TURNED}/{WAY}",
        f"{TARGET}/{TURNED}/INFRAME g/{WAY}",
        f"{TARGET}/{TURNED}/INFRAME -/{WAY}",
        f"{TARGET}/{TURNED}/MOVE.PTP/CURPOSE/{WAY}",
    ],
)
def test_a_pose_without_axes_is_shifted_along_its_task_frame(text: str) -> None:
    assert shifted(text) == pytest.approx((0.6, 0.2, 0.3))


def test_the_place_of_a_shifted_pose_is_finite() -> None:
    far = "PUSH REAL 1e308/PUSH REAL 0.0/PUSH REAL 0.0/MKVEC/OFFSET"
    assert trap(f"{TARGET}/{far}/{far}/POP/HALT") == "I461"


def test_a_command_pose_that_is_not_finite_in_another_frame_is_a_trap() -> None:
    far = "1.7e308 1.7e308 1.7e308 0.5 0.5 0.5 0.5"
    program = assemble(
        f"ICR 1.0 t\nREQUIRE CAP MSG PTP\nFRAMEDEF far {far}\nPROC main\nFRAME far\nPUSH POSE {far}\n"
        "MOVE.PTP\nFRAME -\nCURPOSE\nFMT\nMSG\nHALT\nEND\n"
    )
    trap = run(program).trap
    assert trap is not None
    assert (trap.code, "CURPOSE" in trap.message) == ("I461", True)


COUNTING = """\
ICR 1.0 loop
VAR i INT
PROC main
  PUSH INT 0
  STORE i
L0:
  LOAD i
  PUSH INT 1
  ADD.I
  STORE i
  PUSH INT 6
  LOAD i
  PUSH INT 3
  SUB.I
  DIV.I
  POP
  JMP L0
END
"""


@pytest.mark.parametrize("budget", range(1, 34))
def test_a_budget_ends_a_run_before_the_very_next_instruction(budget: int) -> None:
    """Two instructions, then passes of eleven; the division of the third pass is by zero."""
    machine = Machine(assemble(COUNTING), StillWorld(), MachineOptions(budget))
    ended = machine.advance()
    assert isinstance(ended, Finished)
    assert ended.trap is not None
    place = budget if budget < 2 else 2 + (budget - 2) % 11
    division = 2 + 2 * 11 + 9
    assert (ended.steps, ended.trap.slug, machine.snapshot().pc) == (
        (budget, "instruction-budget-spent", place)
        if budget < division
        else (division, "division-by-zero", 10)
    )
