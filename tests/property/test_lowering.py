"""Whatever structured program a front end makes: its ICR passes the verifier and runs the same way twice."""

from functools import cache

from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim import icr
from ropsim.core import Span
from ropsim.flow import (
    Comparison,
    GripAction,
    ModalState,
    MotionKind,
    PostureRequest,
    Side,
    TargetOrientation,
    ToolDirection,
)
from ropsim.program import (
    Assign,
    AssignComponent,
    Binary,
    Block,
    Break,
    Call,
    Component,
    Constant,
    Continue,
    Expression,
    For,
    Grip,
    Guard,
    Home,
    If,
    InAxes,
    InFrame,
    InPosture,
    Keeping,
    Kept,
    Local,
    MakeExternal,
    MakePose,
    MakeVector,
    MakeZyx,
    Message,
    Move,
    Offset,
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
    Trigger,
    Unary,
    ValueType,
    Variable,
    Wait,
    WaitUntil,
    While,
    With,
    check_contracts,
    lower,
)
from ropsim.spatial import Pose
from support.examples import examples

BOOL, INT, REAL, POSE = ValueType.BOOL, ValueType.INT, ValueType.REAL, ValueType.POSE
BUDGET = 5_000
SIGNALS = (SignalUse("part", True, BOOL), SignalUse("force", True, REAL), SignalUse("lamp", False, BOOL))
VARIABLES = {BOOL: "flag", INT: "k", REAL: "x", POSE: "p"}
AXES = [(1.0, 0.0, 0.0, 0.0), (0.6, 0.0, 0.8, 0.0)]
LOCALS = tuple(Local(name, kind) for kind, name in VARIABLES.items())

spans = st.integers(1, 50).map(lambda line: Span.on_line("t.task", line, 1))
small = st.integers(-3, 3)


@cache
def values(kind: ValueType) -> st.SearchStrategy[Expression]:
    """Return expressions of a type."""
    leaves: dict[ValueType, st.SearchStrategy[Expression]] = {
        BOOL: st.booleans().map(lambda value: Constant(value, BOOL)) | st.just(SignalValue("part", BOOL)),
        INT: small.map(lambda value: Constant(value, INT)),
        REAL: small.map(lambda value: Constant(value / 2.0, REAL)) | st.just(SignalValue("force", REAL)),
        POSE: st.builds(
            lambda x, external: Constant((x / 4.0, 0.0, 0.5, 0.0, 1.0, 0.0, 0.0, *external), POSE),
            small,
            st.sampled_from([(), (), (0.8,), (0.8, -1.5)]),
        ),
    }
    return leaves[kind] | st.just(Variable(VARIABLES[kind], kind))


def binary(kind: ValueType, operations: list[str], result: ValueType) -> st.SearchStrategy[Expression]:
    return st.builds(
        Binary,
        st.sampled_from(operations),
        st.deferred(lambda: expressions[kind]),
        values(kind),
        st.just(result),
    )


def unary(kind: ValueType, operations: list[str], result: ValueType) -> st.SearchStrategy[Expression]:
    return st.builds(
        Unary, st.sampled_from(operations), st.deferred(lambda: expressions[kind]), st.just(result)
    )


arithmetic = ["add", "sub", "mul", "div", "mod", "min", "max"]
compare = ["eq", "ne", "lt", "le", "gt", "ge"]
expressions: dict[ValueType, st.SearchStrategy[Expression]] = {
    BOOL: values(BOOL)
    | binary(INT, compare, BOOL)
    | binary(REAL, compare, BOOL)
    | binary(BOOL, ["and", "or", "eq", "ne"], BOOL)
    | unary(BOOL, ["not"], BOOL),
    INT: values(INT) | binary(INT, [*arithmetic, "pow"], INT) | unary(REAL, ["round", "trunc"], INT),
    REAL: values(REAL)
    | binary(REAL, [*arithmetic, "pow", "atan2"], REAL)
    | binary(INT, ["add", "div"], REAL)
    | unary(REAL, ["neg", "abs", "sqrt", "sin", "tan", "asin"], REAL)
    | binary(POSE, ["distance"], REAL)
    | st.builds(Component, values(POSE), st.integers(0, 5)),
    POSE: values(POSE)
    | binary(POSE, ["compose"], POSE)
    | unary(POSE, ["invert"], POSE)
    | st.builds(InFrame, st.deferred(lambda: expressions[POSE]), st.sampled_from(["plate", ""]))
    | st.builds(InAxes, st.deferred(lambda: expressions[POSE]), st.sampled_from(AXES))
    | st.builds(
        Offset,
        st.deferred(lambda: expressions[POSE]),
        st.builds(MakeVector, values(REAL), values(INT), values(REAL)),
    )
    | st.builds(
        InPosture,
        st.deferred(lambda: expressions[POSE]),
        st.builds(
            PostureRequest,
            st.sampled_from([(), ("left",), ("right", "up")]),
            st.lists(st.integers(-2, 2), max_size=3).map(tuple),
            st.sampled_from(TargetOrientation),
        ),
    )
    | st.builds(
        MakeExternal,
        st.deferred(lambda: expressions[POSE]),
        st.lists(values(REAL), min_size=1, max_size=3).map(tuple),
    )
    | st.builds(
        lambda value, other: Keeping(value, Binary("compose", Kept(POSE), other, POSE), POSE),
        st.deferred(lambda: expressions[POSE]),
        st.deferred(lambda: expressions[POSE]) | st.just(Kept(POSE)),
    )
    | st.builds(
        MakePose,
        st.builds(MakeVector, values(REAL), values(INT), values(REAL)),
        st.builds(MakeZyx, values(REAL), values(REAL), values(REAL)),
    ),
}
positive = st.sampled_from([0.1, 0.5, 1.0]).map(lambda value: Constant(value, REAL))
modal = st.builds(
    Settings,
    tool=st.none() | st.sampled_from(["jaws", "cell tool", ""]),
    path_speed=st.none() | positive | st.just(Variable("x", REAL)),
    ptp_speed=st.none() | positive,
    zone=st.none() | positive | st.just(Constant(0.0, REAL)),
)


def points(least: int) -> st.SearchStrategy[tuple[Expression, ...]]:
    """Return points on the way of a motion."""
    return st.lists(expressions[POSE], min_size=least, max_size=3).map(tuple)


places = positive | st.just(Variable("x", REAL))
trigger = st.builds(
    Trigger, st.just("lamp"), expressions[BOOL], st.sampled_from(Side), st.none(), places
) | st.builds(Trigger, st.just("lamp"), expressions[BOOL], st.sampled_from(Side), places)
triggers = st.lists(trigger, max_size=2).map(tuple)
guards = st.none() | st.one_of(
    st.builds(Guard, st.just("part"), st.just(Comparison.IS), expressions[BOOL], st.none() | places),
    st.builds(
        Guard,
        st.just("force"),
        st.sampled_from((Comparison.ABOVE, Comparison.BELOW)),
        expressions[REAL],
        st.none() | places,
    ),
)
gains = positive | st.just(Variable("x", REAL))
trackings = st.none() | st.builds(
    Tracking, st.just("force"), expressions[REAL], gains, st.sampled_from(ToolDirection)
)
stores = st.sampled_from(["", "", "p"])
plain: st.SearchStrategy[Statement] = st.one_of(
    st.builds(
        Move,
        st.sampled_from((MotionKind.PTP, MotionKind.LIN)),
        expressions[POSE],
        modal,
        spans,
        points(0),
        st.none(),
        triggers,
        st.none(),
        st.none(),
        stores,
    ),
    st.builds(
        Move,
        st.just(MotionKind.PTP),
        expressions[POSE],
        modal,
        spans,
        st.just(()),
        st.none(),
        triggers,
        guards,
        st.none(),
        stores,
    ),
    st.builds(
        Move,
        st.just(MotionKind.LIN),
        expressions[POSE],
        modal,
        spans,
        st.just(()),
        st.none(),
        triggers,
        guards,
        trackings,
        stores,
    ),
    st.builds(
        Move,
        st.just(MotionKind.SPLINE),
        expressions[POSE],
        modal,
        spans,
        points(1),
        st.none(),
        triggers,
        guards,
        trackings,
        stores,
    ),
    st.builds(
        Move,
        st.just(MotionKind.CIRC),
        expressions[POSE],
        modal,
        spans,
        st.tuples(expressions[POSE]),
        st.none() | gains,
        triggers,
        guards,
        trackings,
        stores,
    ),
    st.builds(Move, st.just(MotionKind.PTP), st.just(Home()), modal, spans, points(0), st.none(), triggers),
    st.builds(Grip, st.sampled_from(GripAction), st.sampled_from(["", "jaws"]), spans),
    st.builds(Output, st.just("lamp"), expressions[BOOL], spans),
    st.builds(Wait, positive | st.just(Variable("x", REAL)), spans),
    st.builds(Message, st.tuples(expressions[REAL], expressions[POSE]), spans),
    st.builds(Set, modal, spans),
    st.builds(Stop, st.sampled_from(["", "end"]), spans),
    st.builds(Assign, st.just("flag"), expressions[BOOL], spans),
    st.builds(Assign, st.just("k"), expressions[INT], spans),
    st.builds(Assign, st.just("x"), expressions[REAL] | expressions[INT], spans),
    st.builds(Assign, st.just("p"), expressions[POSE], spans),
    st.builds(AssignComponent, st.just("p"), st.integers(0, 5), expressions[REAL], spans),
)


@cache
def blocks(depth: int, *, is_loop: bool = False, calls: tuple[str, ...] = ()) -> st.SearchStrategy[Block]:
    choices = [plain, plain]
    if is_loop:
        choices.append(st.builds(Break, spans) | st.builds(Continue, spans))
    if calls:
        choices.append(
            st.builds(
                Call,
                st.sampled_from(calls),
                st.tuples(expressions[POSE], values(INT)),
                spans,
                st.sampled_from(["", "x"]),
            )
        )
    else:
        choices.append(st.builds(Return, st.none() | expressions[REAL], spans))
    if depth:
        inner = blocks(depth - 1, is_loop=is_loop, calls=calls)
        body = blocks(depth - 1, is_loop=True, calls=calls)
        branches = st.lists(st.tuples(expressions[BOOL], inner), min_size=1, max_size=2).map(tuple)
        steps = st.sampled_from([Constant(1, INT), Constant(-2, INT), Unary("neg", Constant(1, INT), INT)])
        timeout = st.none() | positive
        choices += [
            st.builds(If, branches, inner, spans),
            st.builds(While, expressions[BOOL], body, spans),
            st.builds(
                Repeat, st.none() | values(INT) | values(REAL), body, st.none() | expressions[BOOL], spans
            ),
            st.builds(For, st.sampled_from(["k", "x"]), values(INT), values(INT), steps, body, spans),
            st.builds(With, modal, inner, spans),
            st.builds(WaitUntil, expressions[BOOL], timeout, inner, spans),
        ]
    return st.lists(st.one_of(choices), max_size=4).map(tuple)


@st.composite
def programs(draw: st.DrawFn) -> Program:
    """Return a sound program; `b` may be called by `a`, and both by main."""
    parameters = (Local("p", POSE), Local("n", INT))
    own = (Local("k", INT), Local("x", REAL), Local("flag", BOOL))
    span = draw(spans)
    b = Task("b", parameters, own, REAL, draw(blocks(1)), (), span)
    body = draw(blocks(1, calls=("b",)))
    a = Task("a", parameters, own[:1], REAL, body, (), span)
    main = draw(blocks(2, calls=("a", "b")))
    identity = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)
    return Program(
        "t",
        main,
        LOCALS,
        (a, b),
        "",
        {"plate": identity},
        {"jaws": identity},
        draw(st.sampled_from(["", "jaws"])),
        SIGNALS,
    )


@settings(max_examples=examples(80), derandomize=True)
@given(programs())
def test_the_icr_of_a_sound_program_is_verified_and_runs_the_same_way_twice(program: Program) -> None:
    code = lower(program, "t.task")
    assert icr.verify(code) == ()
    assert icr.assemble(icr.disassemble(code)) == code
    inputs = {"force": 1.5, "part": True}
    first = icr.run(code, icr.StillWorld(inputs), BUDGET)
    assert first == icr.run(code, icr.StillWorld(inputs), BUDGET)
    assert first.steps <= BUDGET


@settings(max_examples=examples(10), derandomize=True)
@given(programs())
def test_lowering_is_a_function_of_the_program(program: Program) -> None:
    assert icr.program_id(lower(program, "a")) == icr.program_id(lower(program, "b"))


@settings(max_examples=examples(10), derandomize=True)
@given(programs())
def test_without_contracts_there_is_nothing_to_warn_of(program: Program) -> None:
    assert check_contracts(program) == ()


class Timeless:
    """A world that answers the same at every time, so that it need not be rewound."""

    def read(self, channel: str) -> bool | int | float:
        return len(channel)

    def wait(self, channel: str, value: bool, timeout: float | None) -> bool:
        return value and timeout is None and bool(channel)

    def time(self) -> float:
        return 0.5

    def met(self) -> bool:
        return True

    def attained(self, modal: ModalState) -> Pose | None:
        return Pose() if modal.tool else None

    def commanded(self, modal: ModalState) -> Pose | None:
        return Pose() if modal.tool else None

    def reached(self, target: icr.Target, then: ModalState, now: ModalState) -> Pose | None:
        return target if isinstance(target, Pose) and then.tool == now.tool else None


@settings(max_examples=examples(40), derandomize=True)
@given(programs(), st.integers(0, 30))
def test_a_run_resumed_from_a_snapshot_ends_as_the_straight_run(program: Program, pause: int) -> None:
    code = lower(program, "t.task")
    options = icr.MachineOptions(BUDGET)

    def rest(machine: icr.Machine) -> list[object]:
        handed: list[object] = [machine.advance()]
        while not isinstance(handed[-1], icr.Finished):
            handed.append(machine.advance())
        return handed

    machine = icr.Machine(code, Timeless(), options)
    for _ in range(pause):
        machine.advance()
    state = machine.snapshot()
    assert rest(icr.Machine.resume(code, Timeless(), state, options)) == rest(machine)
