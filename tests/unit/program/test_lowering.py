from typing import cast

import pytest

from ropsim import icr
from ropsim.core import Span
from ropsim.flow import GripAction, MotionKind, ToolDirection, WaitInstruction
from ropsim.program import (
    Assign,
    AssignComponent,
    Binary,
    Block,
    Break,
    Call,
    CommandPose,
    Component,
    Constant,
    Continue,
    Contract,
    Expression,
    For,
    Grip,
    Home,
    If,
    Keeping,
    Kept,
    Local,
    LoweringError,
    MakeJoints,
    Message,
    Move,
    Output,
    Program,
    Repeat,
    Return,
    Set,
    Settings,
    SignalUse,
    SignalValue,
    Statement,
    Stop,
    Task,
    Tracking,
    Unary,
    ValueType,
    Variable,
    Wait,
    WaitUntil,
    While,
    With,
    lower,
)
from ropsim.spatial import Pose
from support.golden import GOLDEN, check_golden

SOURCE = "t.task"
BOOL, INT, REAL, STR = ValueType.BOOL, ValueType.INT, ValueType.REAL, ValueType.STR
POSE, JOINTS = ValueType.POSE, ValueType.JOINTS
SIGNALS = (
    SignalUse("part", True, BOOL),
    SignalUse("force", True, REAL),
    SignalUse("lamp", False, BOOL),
    SignalUse("level", False, REAL),
)
LOCALS = (Local("k", INT), Local("x", REAL), Local("ok", BOOL), Local("p", POSE))


def at(line: int) -> Span:
    return Span.on_line(SOURCE, line, 1)


def whole(value: int) -> Constant:
    return Constant(value, INT)


def real(value: float) -> Constant:
    return Constant(value, REAL)


def place(x: float) -> Constant:
    return Constant((x, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0), POSE)


def k() -> Variable:
    return Variable("k", INT)


def say(value: Expression, line: int = 1) -> Message:
    return Message((value,), at(line))


def mov(x: float, settings: Settings | None = None, line: int = 1) -> Move:
    return Move(MotionKind.PTP, place(x), settings or Settings(), at(line))


def compiled(*main: Statement, tasks: tuple[Task, ...] = (), frame: str = "", tool: str = "") -> icr.Program:
    """Return the ICR of these control statements; it is verified."""
    frames = {"cell": (1.0, 2.0, 3.0, 1.0, 0.0, 0.0, 0.0)}
    tools = {"jaws": (0.0, 0.0, 0.1, 1.0, 0.0, 0.0, 0.0)}
    sir = Program("t", main, LOCALS, tasks, frame, frames, tools, tool, SIGNALS)
    program = lower(sir, SOURCE)
    assert icr.verify(program) == ()
    assert icr.assemble(icr.disassemble(program)) == program
    return program


def said(*main: Statement, tasks: tuple[Task, ...] = (), **inputs: bool | float) -> list[str]:
    trace = icr.run(compiled(*main, tasks=tasks), icr.StillWorld(inputs))
    return [*trace.messages, *([trace.trap.code] if trace.trap else [])]


def task(
    name: str, *body: Statement, parameters: tuple[Local, ...] = (), result: ValueType | None = None
) -> Task:
    return Task(name, parameters, (Local("u", INT),), result, body, (), at(50))


def test_an_empty_program_waits_and_halts() -> None:
    program = compiled()
    assert [step.mnemonic for step in program.procedures[0].code] == ["SYNC", "HALT"]


def test_frame_and_tool_come_first_and_only_used_ones_are_declared() -> None:
    program = compiled(mov(0.1), frame="cell", tool="jaws")
    assert [step.mnemonic for step in program.procedures[0].code[:2]] == ["FRAME", "TOOL"]
    assert [frame.name for frame in program.frames] == ["cell"]
    assert [tool.name for tool in program.tools] == ["jaws"]
    assert not compiled(mov(0.1)).frames
    assert not compiled(mov(0.1)).tools


def test_only_reached_tasks_are_lowered_in_the_order_of_their_first_call() -> None:
    tasks = (task("b"), task("idle", mov(1.0)), task("a", Call("c", (), at(4))), task("c"))
    program = compiled(Call("a", (), at(1)), Call("b", (), at(2)), tasks=tasks)
    assert [procedure.name for procedure in program.procedures] == ["main", "a", "c", "b"]


def test_a_task_named_main_gets_another_procedure_name() -> None:
    program = compiled(Call("main", (), at(1)), tasks=(task("main", mov(1.0)),))
    assert [procedure.name for procedure in program.procedures] == ["main", "main_"]


def test_every_instruction_knows_its_source_line() -> None:
    trace = icr.run(compiled(mov(0.1, line=3), Repeat(whole(2), (mov(0.2, line=5),), None, at(4))))
    assert [str(move.origin.span) for move in trace.moves] == ["t.task:3:1", "t.task:5:1", "t.task:5:1"]


def test_lines_of_another_text_are_not_recorded() -> None:
    foreign = Move(MotionKind.PTP, Home(), Settings(), Span.on_line("library.task", 3, 1))
    assert set(compiled(foreign).procedures[0].lines) == {0}


def test_settings_of_a_move_hold_for_that_move_only() -> None:
    fast = Settings("jaws", real(0.2), real(0.5), real(1.0), real(2.0), real(0.3), real(0.01))
    moves = icr.run(compiled(mov(0.1, fast), mov(0.2))).moves
    modal = moves[0].modal
    assert (modal.tool, modal.path_speed, modal.ptp_speed) == ("jaws", 0.2, 0.5)
    assert (modal.orientation_speed, modal.path_acceleration, modal.ptp_acceleration) == (1.0, 2.0, 0.3)
    assert (modal.zone, moves[1].modal.zone, moves[1].modal.tool) == (0.01, 0.0, "")


def test_a_move_without_settings_saves_nothing() -> None:
    assert "MODAL.SAVE" not in {step.mnemonic for step in compiled(mov(0.1)).procedures[0].code}


def test_a_constant_zone_of_zero_is_fine() -> None:
    program = compiled(mov(0.1, Settings(zone=real(0.0))))
    assert "ZONE.FINE" in {step.mnemonic for step in program.procedures[0].code}


def test_targets_may_be_joints_home_and_the_command_pose() -> None:
    joints = Move(MotionKind.PTP, MakeJoints((real(0.1), whole(2))), Settings(), at(2))
    home = Move(MotionKind.PTP, Home(), Settings(), at(1))
    here = Move(MotionKind.LIN, Binary("compose", CommandPose(), place(0.5), POSE), Settings(), at(4))
    program = compiled(joints, home, mov(0.25), here)
    moves = icr.run(program).moves
    assert program.axes == 2
    assert [move.target for move in moves[:2]] == [(0.1, 2.0), None]
    assert moves[3].kind is MotionKind.LIN


def test_a_move_through_points_passes_them_by_and_stops_as_it_says() -> None:
    settings = Settings(ptp_speed=real(0.5), zone=real(0.0))
    through = Move(MotionKind.PTP, place(0.3), settings, at(1), (place(0.1), Home(), place(0.2)))
    last = mov(0.5)
    moves = icr.run(compiled(Set(Settings(zone=real(0.02)), at(1)), through, last)).moves
    assert [one.modal.passes for one in moves] == [True, True, True, False, False]
    assert [one.modal.zone for one in moves] == [0.02, 0.02, 0.02, 0.0, 0.02]
    assert [one.modal.ptp_speed for one in moves] == [0.5] * 4 + [1.0]
    places = [one.target.as_tuple()[0] if isinstance(one.target, Pose) else None for one in moves]
    assert places == [0.1, None, 0.2, 0.3, 0.5]


def test_the_points_of_a_move_are_evaluated_before_it_begins() -> None:
    here = Binary("compose", CommandPose(), place(0.5), POSE)
    through = Move(MotionKind.LIN, here, Settings(), at(2), (place(2.0),))
    *_, last = icr.run(compiled(mov(0.25), through)).moves
    assert isinstance(last.target, Pose)
    assert last.target.as_tuple()[0] == 0.75


def test_arcs_and_curves_become_one_move_each() -> None:
    arc = Move(MotionKind.CIRC, place(0.2), Settings(), at(1), (place(0.1),))
    part = Move(MotionKind.CIRC, place(0.2), Settings(), at(2), (place(0.1),), real(7.0))
    curve = Move(MotionKind.SPLINE, place(0.4), Settings(zone=real(0.01)), at(3), (place(0.1), place(0.2)))
    moves = icr.run(compiled(arc, part, curve)).moves
    assert [(one.kind, len(one.via), one.angle) for one in moves] == [
        (MotionKind.CIRC, 1, None),
        (MotionKind.CIRC, 1, 7.0),
        (MotionKind.SPLINE, 2, None),
    ]


@pytest.mark.parametrize("via", [(), (place(0.1), place(0.2))])
def test_an_arc_through_another_number_of_points_is_unsound(via: tuple[Expression, ...]) -> None:
    with pytest.raises(LoweringError, match="through one point"):
        compiled(Move(MotionKind.CIRC, place(0.3), Settings(), at(1), via))


def test_a_path_of_a_kind_without_an_instruction_is_unsound() -> None:
    helix = cast("MotionKind", "HELIX")
    with pytest.raises(LoweringError, match="no instruction makes a path of kind `HELIX`"):
        compiled(Move(helix, place(0.3), Settings(), at(1), (place(0.1),)))


def test_a_curve_with_an_angle_is_unsound() -> None:
    with pytest.raises(LoweringError, match="a curve goes on no circle"):
        compiled(Move(MotionKind.SPLINE, place(0.3), Settings(), at(1), (place(0.1),), real(1.0)))


def test_a_task_called_inside_with_inherits_the_settings_and_with_takes_them_back() -> None:
    block = With(Settings(ptp_speed=real(0.5)), (Call("a", (), at(2)),), at(1))
    moves = icr.run(compiled(block, Call("a", (), at(3)), tasks=(task("a", mov(0.1)),))).moves
    assert [move.modal.ptp_speed for move in moves] == [0.5, 1.0]


@pytest.mark.parametrize("way_out", [Break(at(3)), Continue(at(3))])
def test_leaving_a_with_by_break_or_continue_restores_the_settings(way_out: Statement) -> None:
    inner = With(Settings(ptp_speed=real(0.25)), (mov(0.1), way_out), at(3))
    outer = With(Settings(ptp_speed=real(0.5)), (inner,), at(2))
    moves = icr.run(compiled(Repeat(whole(2), (outer,), None, at(1)), mov(0.2))).moves
    assert moves[-1].modal.ptp_speed == 1.0
    assert len(moves) == (2 if isinstance(way_out, Break) else 3)


def test_returning_out_of_a_with_restores_the_settings() -> None:
    body = With(Settings(ptp_speed=real(0.25)), (Return(whole(7), at(3)),), at(2))
    main = (Call("a", (), at(1), result="k"), mov(0.1), say(k()))
    trace = icr.run(compiled(*main, tasks=(task("a", body, result=INT),)))
    assert trace.moves[0].modal.ptp_speed == 1.0
    assert trace.messages == ("7",)


def test_set_holds_until_further_notice() -> None:
    moves = icr.run(compiled(Set(Settings(ptp_speed=real(0.5)), at(1)), mov(0.1), mov(0.2))).moves
    assert [move.modal.ptp_speed for move in moves] == [0.5, 0.5]


COUNT: Block = (Assign("k", Binary("add", k(), whole(1), INT), at(9)),)


@pytest.mark.parametrize(
    ("count", "until", "expected"),
    [
        (whole(3), None, "3"),
        (whole(0), None, "0"),
        (whole(-2), None, "0"),
        (real(3.0), None, "3"),
        (None, Binary("ge", k(), whole(4), BOOL), "4"),
        (None, Constant(True, BOOL), "1"),
        (whole(2), Binary("ge", k(), whole(4), BOOL), "2"),
        (whole(0), Constant(True, BOOL), "0"),
    ],
)
def test_repeat_passes(count: Expression | None, until: Expression | None, expected: str) -> None:
    assert said(Assign("k", whole(0), at(1)), Repeat(count, COUNT, until, at(2)), say(k())) == [expected]


def test_a_repeat_count_is_evaluated_once() -> None:
    assert said(Assign("k", whole(3), at(1)), Repeat(k(), COUNT, None, at(2)), say(k())) == ["6"]


def test_a_repeat_count_that_is_not_whole_is_a_trap() -> None:
    assert said(Repeat(real(2.5), COUNT, None, at(2))) == ["I461"]


def test_an_endless_repeat_is_left_by_break() -> None:
    leave = If(((Binary("ge", k(), whole(5), BOOL), (Break(at(4)),)),), (), at(3))
    assert said(Repeat(None, (*COUNT, leave), None, at(2)), say(k())) == ["5"]


@pytest.mark.parametrize(
    ("name", "first", "last", "step", "values"),
    [
        ("k", whole(1), whole(3), whole(1), "1 2 3"),
        ("k", whole(3), whole(1), Unary("neg", whole(1), INT), "3 2 1"),
        ("k", whole(1), whole(6), whole(2), "1 3 5"),
        ("k", whole(2), whole(1), whole(1), ""),
        ("x", real(0.0), real(1.0), real(0.1), "0 0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9 1"),
        ("x", whole(1), whole(0), real(-0.5), "1 0.5 0"),
    ],
)
def test_for_passes(name: str, first: Expression, last: Expression, step: Expression, values: str) -> None:
    kind = INT if name == "k" else REAL
    loop = For(name, first, last, step, (say(Variable(name, kind)),), at(2))
    assert " ".join(said(loop)) == values


def test_the_passes_of_for_do_not_depend_on_what_the_body_does_to_the_variable() -> None:
    body = (say(k()), Assign("k", whole(99), at(3)))
    assert said(For("k", whole(1), whole(3), whole(1), body, at(2))) == ["1", "2", "3"]


def test_while_and_continue() -> None:
    skip = If(((Binary("eq", k(), whole(2), BOOL), (Continue(at(5)),)),), (), at(4))
    loop = While(Binary("lt", k(), whole(4), BOOL), (*COUNT, skip, say(k())), at(2))
    assert said(Assign("k", whole(0), at(1)), loop) == ["1", "3", "4"]


def test_the_first_branch_that_holds_is_run() -> None:
    def pick(value: int) -> list[str]:
        branches = tuple((Binary("lt", k(), whole(n), BOOL), (say(whole(n)),)) for n in (1, 2))
        return said(Assign("k", whole(value), at(1)), If(branches, (say(whole(9)),), at(2)))

    assert [pick(0), pick(1), pick(5)] == [["1"], ["2"], ["9"]]


def test_code_behind_a_way_out_is_left_out() -> None:
    body = Repeat(None, (Break(at(2)), mov(0.1)), None, at(1))
    tasks = (task("a", Return(None, at(3)), Call("b", (), at(4))), task("b"))
    program = compiled(body, Call("a", (), at(5)), Stop("", at(6)), mov(0.2), tasks=tasks)
    assert [procedure.name for procedure in program.procedures] == ["main", "a"]


def test_parameters_are_passed_by_value_and_integers_widen() -> None:
    body = (Assign("z", Binary("mul", Variable("z", REAL), real(2.0), REAL), at(9)), say(Variable("z", REAL)))
    callee = task("a", *body, parameters=(Local("z", REAL),))
    assert said(Assign("k", whole(3), at(1)), Call("a", (k(),), at(2)), say(k()), tasks=(callee,)) == [
        "6",
        "3",
    ]


def test_a_result_that_nobody_wants_is_taken_from_the_stack() -> None:
    assert said(
        Call("a", (), at(1)), say(whole(1)), tasks=(task("a", Return(whole(2), at(2)), result=INT),)
    ) == ["1"]


def test_a_task_with_a_result_and_no_return_gives_zero() -> None:
    main = (Call("a", (), at(1), result="x"), say(Variable("x", REAL)))
    assert said(*main, tasks=(task("a", result=INT),)) == ["0"]


def test_variables_that_might_be_read_early_start_with_zero() -> None:
    program = compiled(
        say(k()), say(Variable("ok", BOOL)), say(Variable("p", POSE)), Assign("x", real(1.0), at(2))
    )
    stores = [step.operands[0] for step in program.procedures[0].code[:6] if step.mnemonic == "STORE"]
    assert stores == ["k", "ok", "p"]
    assert icr.run(program).messages == ("0", "false", "(0, 0, 0, 0, 0, 0)")


def test_a_global_read_in_a_task_starts_with_zero_in_main() -> None:
    program = compiled(Call("a", (), at(1)), tasks=(task("a", say(k())),))
    assert program.procedures[0].code[1] == icr.Step("STORE", ("k",))
    assert icr.run(program).messages == ("0",)


def test_a_component_is_replaced() -> None:
    main = (Assign("p", place(0.5), at(1)), AssignComponent("p", 2, whole(3), at(2)))
    values = tuple(say(Component(Variable("p", POSE), index)) for index in (0, 2))
    assert said(*main, *values) == ["0.5", "3"]


def test_a_digital_input_is_waited_for_without_polling() -> None:
    conditions: list[tuple[Expression, bool]] = [
        (SignalValue("part", BOOL), True),
        (Unary("not", SignalValue("part", BOOL), BOOL), False),
        (Binary("eq", SignalValue("part", BOOL), Constant(False, BOOL), BOOL), False),
        (Binary("ne", SignalValue("part", BOOL), Constant(False, BOOL), BOOL), True),
    ]
    for condition, value in conditions:
        program = compiled(WaitUntil(condition, None, (), at(1)))
        code = program.procedures[0].code
        assert [step.mnemonic for step in code[:4]] == ["PUSH", "PUSH", "WAIT.IN", "POP"]
        assert code[0].operands == (icr.Constant(icr.Type.BOOL, value),)


@pytest.mark.parametrize("condition", ["part", "force"])
def test_a_wait_that_ends_without_its_condition_traps_or_runs_the_other_way(condition: str) -> None:
    holds: Expression = SignalValue("part", BOOL)
    if condition == "force":
        holds = Binary("gt", SignalValue("force", REAL), real(5.0), BOOL)
    bare = WaitUntil(holds, real(1.0), (), at(1))
    other = WaitUntil(holds, real(1.0), (say(Constant("late", STR)),), at(1))
    assert said(bare) == ["I462"]
    assert said(other) == ["late"]
    assert said(bare, other, say(whole(1)), part=True, force=6.0) == ["1"]


def test_waiting_for_ever_for_a_condition_ends_by_the_budget() -> None:
    never = Binary("gt", SignalValue("force", REAL), real(5.0), BOOL)
    assert said(WaitUntil(never, None, (), at(1))) == ["I463"]


def test_a_timeout_of_zero_does_not_wait_for_ever() -> None:
    assert said(WaitUntil(SignalValue("part", BOOL), whole(0), (), at(1))) == ["I462"]


def test_outputs_grippers_waits_and_messages() -> None:
    main = (
        Output("lamp", Constant(True, BOOL), at(1)),
        Output("level", whole(2), at(2)),
        Grip(GripAction.CLOSE, "jaws", at(3)),
        Wait(whole(1), at(4)),
        Message((Constant("k is", STR), k(), Constant((1.0, 2.0, 3.0), ValueType.VEC)), at(5)),
        Message((), at(6)),
        Stop("done", at(7)),
    )
    trace = icr.run(compiled(*main))
    assert trace.messages == ("k is 0 (1, 2, 3)", "", "done")
    assert [one.tool for one in trace.grips] == ["jaws"]
    assert [one.duration for one in trace.io if isinstance(one, WaitInstruction)] == [1.0]


@pytest.mark.parametrize(
    ("operation", "left", "right", "kind", "expected"),
    [
        ("add", whole(2), whole(3), INT, "5"),
        ("div", whole(7), whole(2), REAL, "3.5"),
        ("div", whole(-7), whole(2), INT, "-4"),
        ("mod", whole(-7), whole(2), INT, "1"),
        ("pow", whole(2), whole(10), INT, "1024"),
        ("pow", real(2.0), real(0.5), REAL, "1.41421"),
        ("atan2", real(1.0), real(1.0), REAL, "0.785398"),
        ("max", whole(2), real(2.5), REAL, "2.5"),
        ("le", whole(2), real(2.0), BOOL, "true"),
        ("ne", Constant(True, BOOL), Constant(False, BOOL), BOOL, "true"),
        ("and", Constant(True, BOOL), Constant(False, BOOL), BOOL, "false"),
        ("distance", place(1.0), place(4.0), REAL, "3"),
    ],
)
def test_binary_operations(
    operation: str, left: Expression, right: Expression, kind: ValueType, expected: str
) -> None:
    assert said(say(Binary(operation, left, right, kind))) == [expected]


@pytest.mark.parametrize(
    ("operation", "operand", "kind", "expected"),
    [
        ("neg", whole(2), INT, "-2"),
        ("neg", whole(2), REAL, "-2"),
        ("abs", real(-2.5), REAL, "2.5"),
        ("sqrt", whole(16), REAL, "4"),
        ("to_real", whole(3), REAL, "3"),
        ("round", real(2.5), INT, "3"),
        ("round", real(-2.5), INT, "-3"),
        ("round", real(0.49999999999999994), INT, "0"),
        ("trunc", real(-2.7), INT, "-2"),
        ("trunc", whole(4), INT, "4"),
        ("not", Constant(True, BOOL), BOOL, "false"),
        ("invert", place(2.0), POSE, "(-2, 0, 0, 0, 0, 0)"),
        ("position", place(2.0), ValueType.VEC, "(2, 0, 0)"),
        ("orientation", place(2.0), ValueType.ORI, "(0, 0, 0)"),
    ],
)
def test_unary_operations(operation: str, operand: Expression, kind: ValueType, expected: str) -> None:
    assert [text.replace("-0,", "0,") for text in said(say(Unary(operation, operand, kind)))] == [expected]


@pytest.mark.parametrize(
    "statement",
    [
        Assign("nobody", whole(1), at(1)),
        Assign("k", real(1.0), at(1)),
        Call("nobody", (), at(1)),
        Call("a", (whole(1),), at(1)),
        Call("a", (), at(1), result="k"),
        Output("nobody", whole(1), at(1)),
        Move(MotionKind.LIN, Home(), Settings(), at(1)),
        Break(at(1)),
        Continue(at(1)),
        For("ok", whole(1), whole(2), whole(1), (), at(1)),
        For("k", whole(1), whole(2), whole(0), (), at(1)),
        For("k", whole(1), whole(2), k(), (), at(1)),
        say(Home()),
        say(Binary("add", place(1.0), place(2.0), POSE)),
        say(Unary("neg", place(1.0), POSE)),
    ],
)
def test_a_program_that_contradicts_itself_is_refused(statement: Statement) -> None:
    with pytest.raises(LoweringError, match="I450"):
        compiled(statement, tasks=(task("a"),))


def test_a_frame_that_is_not_declared_is_refused() -> None:
    with pytest.raises(LoweringError, match="frame `nowhere`"):
        compiled(frame="nowhere")


def test_recursion_is_left_to_the_verifier() -> None:
    program = lower(Program("t", (Call("a", (), at(1)),), (), (task("a", Call("a", (), at(2))),)), SOURCE)
    assert [one.code for one in icr.verify(program)] == ["I422"]


def test_a_lowered_palletizing_program_is_the_golden_text() -> None:
    location = Variable("l", POSE)
    down = Settings(path_speed=real(0.15))
    grip = Task(
        "grip",
        (Local("l", POSE),),
        (),
        None,
        (
            Move(MotionKind.PTP, Binary("compose", location, place(-0.06), POSE), Settings(), at(11)),
            Move(MotionKind.LIN, location, down, at(12)),
            Grip(GripAction.CLOSE, "", at(13)),
            Wait(real(0.2), at(14)),
        ),
        (Contract(GripAction.OPEN, "assumes gripper open", at(10)),),
        at(9),
    )
    wait = WaitUntil(SignalValue("part", BOOL), real(10.0), (Stop("no part", at(5)),), at(4))
    rows = For("k", whole(1), whole(6), whole(1), (wait, Call("grip", (Variable("p", POSE),), at(6))), at(3))
    main = (Grip(GripAction.OPEN, "", at(1)), Assign("p", place(0.4), at(2)), rows, say(k(), 8))
    text = icr.disassemble(compiled(*main, tasks=(grip,), frame="cell", tool="jaws"))
    check_golden(GOLDEN / "icr" / "lowered.icr", text)


def test_a_motion_in_joint_space_that_a_sensor_corrects_is_unsound() -> None:
    corrected = Tracking("force", real(0.1), real(1.0), ToolDirection.Z)
    with pytest.raises(LoweringError, match="not corrected by a sensor"):
        compiled(Move(MotionKind.PTP, place(0.1), Settings(), at(1), tracking=corrected))


def test_a_kept_value_outside_of_what_keeps_it_is_unsound() -> None:
    with pytest.raises(LoweringError, match="no value is kept"):
        compiled(Assign("p", Kept(POSE), at(1)))


def test_what_is_kept_is_computed_once() -> None:
    there = Unary("invert", place(0.1), POSE)
    twice = Keeping(there, Binary("compose", Kept(POSE), Kept(POSE), POSE), POSE)
    program = compiled(Assign("p", twice, at(1)), say(Component(Variable("p", POSE), 0)))
    assert [step.mnemonic for step in program.procedures[0].code].count("INV") == 1
    assert [float(one) for one in icr.run(program).messages] == [pytest.approx(-0.2)]
