from ropsim.core import Span
from ropsim.flow import GripAction
from ropsim.program import (
    Block,
    Break,
    Call,
    Constant,
    Continue,
    Contract,
    For,
    Grip,
    If,
    Program,
    Repeat,
    Return,
    Set,
    Settings,
    SignalValue,
    Statement,
    Stop,
    Task,
    ValueType,
    WaitUntil,
    While,
    With,
    check_contracts,
)

YES = Constant(True, ValueType.BOOL)


def at(line: int) -> Span:
    return Span.on_line("t.task", line, 1)


OPEN = Grip(GripAction.OPEN, "", at(1))
CLOSE = Grip(GripAction.CLOSE, "", at(1))


def call(name: str, line: int = 7) -> Call:
    return Call(name, (), at(line))


def task(name: str, assumed: GripAction | None, *body: Statement) -> Task:
    contracts = (Contract(assumed, "assumes", at(20)),) if assumed else ()
    return Task(name, (), (), None, body, contracts, at(19))


GRIP = task("grip", GripAction.OPEN, CLOSE)
RELEASE = task("release", GripAction.CLOSE, OPEN)


def found(*main: Statement, tasks: tuple[Task, ...] = (), tool: str = "") -> list[int]:
    """Return the lines of the calls that are warned of."""
    program = Program("t", main, (), (GRIP, RELEASE, *tasks), tool=tool)
    diagnostics = check_contracts(program)
    assert all(one.code == "T390" and not one.is_error for one in diagnostics)
    return [one.span.line for one in diagnostics if one.span]


def test_nothing_is_known_at_the_start() -> None:
    assert found(call("grip")) == []
    assert found(call("release")) == []


def test_the_opposite_state_is_warned_of_on_the_line_of_the_call() -> None:
    assert found(CLOSE, call("grip", 5)) == [5]
    assert found(OPEN, call("release", 5)) == [5]


def test_the_right_state_is_accepted() -> None:
    assert found(OPEN, call("grip"), call("release"), call("grip")) == []


def test_the_state_travels_through_calls() -> None:
    assert found(call("grip", 2), call("grip", 3)) == [3]
    assert found(OPEN, call("twice"), tasks=(task("twice", None, call("grip", 8), call("grip", 9)),)) == [9]


def test_branches_that_differ_make_the_state_unknown() -> None:
    assert found(If(((YES, (OPEN,)),), (CLOSE,), at(2)), call("grip")) == []
    assert found(If(((YES, (CLOSE,)),), (CLOSE,), at(2)), call("grip", 5)) == [5]
    assert found(CLOSE, If(((YES, (OPEN,)),), (), at(2)), call("grip")) == []


def test_a_branch_that_leaves_does_not_count() -> None:
    for way_out in (Return(None, at(3)), Stop("", at(3))):
        branch: Block = (OPEN, way_out)
        assert found(CLOSE, If(((YES, branch),), (), at(2)), call("grip", 5)) == [5]


def test_loops_are_followed_to_a_fixpoint() -> None:
    assert found(OPEN, While(YES, (call("grip", 4), call("release", 5)), at(2))) == []
    assert found(CLOSE, While(YES, (call("grip", 4),), at(2))) == [4]
    assert found(OPEN, While(YES, (CLOSE,), at(2)), call("grip")) == []
    assert found(OPEN, For("k", YES, YES, YES, (call("grip", 4),), at(2))) == []


def test_a_repeat_that_surely_runs_leaves_the_state_of_its_end() -> None:
    three = Constant(3, ValueType.INT)
    assert found(OPEN, Repeat(three, (CLOSE,), None, at(2)), call("grip", 5)) == [5]
    assert found(OPEN, Repeat(None, (CLOSE,), YES, at(2)), call("grip", 5)) == [5]
    assert found(OPEN, Repeat(Constant(0, ValueType.INT), (CLOSE,), None, at(2)), call("grip", 5)) == []


def test_an_endless_loop_is_left_by_break_only() -> None:
    body: Block = (CLOSE, If(((YES, (Break(at(4)),)),), (), at(3)), OPEN)
    assert found(OPEN, Repeat(None, body, None, at(2)), call("grip", 5)) == [5]
    assert found(CLOSE, Repeat(None, (OPEN,), None, at(2)), call("release", 5)) == []


def test_continue_carries_its_state_to_the_next_pass() -> None:
    body: Block = (call("grip", 4), If(((YES, (Continue(at(5)),)),), (), at(5)), OPEN)
    assert found(OPEN, While(YES, body, at(2))) == []


def test_a_timeout_branch_is_joined() -> None:
    wait = WaitUntil(SignalValue("s", ValueType.BOOL), Constant(1.0, ValueType.REAL), (OPEN,), at(2))
    assert found(CLOSE, wait, call("grip")) == []


def test_changing_between_several_tools_makes_the_state_unknown() -> None:
    other = Settings(tool="welder")
    assert found(CLOSE, Set(other, at(2)), call("grip"), tool="jaws") == []
    assert found(CLOSE, With(other, (), at(2)), call("grip"), tool="jaws") == []
    assert found(CLOSE, With(Settings(tool="jaws"), (call("grip", 4),), at(2)), tool="jaws") == [4]


def test_the_warning_names_both_states_and_points_to_the_contract() -> None:
    (one,) = check_contracts(Program("t", (CLOSE, call("grip")), (), (GRIP,)))
    assert one.message == "task `grip` assumes the gripper open, it is closed at this call"
    assert one.hint == "`open` before the call"
    assert one.secondary[0].span == at(20)


def test_recursion_and_unknown_tasks_do_no_harm() -> None:
    assert found(call("a"), call("nobody"), call("grip"), tasks=(task("a", None, CLOSE, call("a")),)) == []


def test_deep_nesting_takes_no_exponential_time() -> None:
    nested: Block = (CLOSE,)
    for _ in range(60):
        nested = (OPEN, While(YES, nested, at(2)), CLOSE)
    assert found(*nested) == []
