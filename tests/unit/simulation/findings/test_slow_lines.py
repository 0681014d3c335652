"""The hint on lines that are flown slower than programmed: when it is given, where, and in which words."""

from dataclasses import replace

import pytest

from ropsim import robots
from ropsim.core import Diagnostic, Span
from ropsim.flow import LimitQuantity, MoveEvent, Origin, ReachedSpeed, Recording, SpeedCause
from ropsim.model import Cell, Tool
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.simulation.testing import FinishedStation, Tally, Track, slow_lines
from support.cells import one_station
from support.compiled import code_of

PUMA = robots.load("puma560")
SLOW = ReachedSpeed(0.18, 0.01, 0.0, 0.3, SpeedCause.ACCELERATION, 4.4)


JOINT = {"cause": SpeedCause.JOINT, "joint": "4", "quantity": LimitQuantity.SPEED}


def move(
    line: int, reached: ReachedSpeed | None = SLOW, *, ordinal: int = 0, flown: float = 0.0
) -> MoveEvent:
    origin = Origin(Span.whole_line("main.task", line), 1)
    return MoveEvent(
        float(ordinal),
        0.5,
        "robot",
        origin,
        motion="LIN",
        ordinal=ordinal,
        travel=0.5,
        flown=flown,
        path_speed=0.4,
        reached=reached,
    )


def found(*events: MoveEvent, slowed: frozenset[int] = frozenset()) -> tuple[Diagnostic, ...]:
    return slow_lines(
        FinishedStation(PUMA, "main.task", 1000, 10.0, Tally((), 0), Track(), Track(), events, slowed)
    )


@pytest.mark.parametrize(
    ("changes", "words", "helps"),
    [
        ({}, "path acceleration 4.4 m/s²", "longer move"),
        ({"cause": SpeedCause.JERK, "value": 44.0}, "path jerk 44 m/s³", "larger zone"),
        (
            {"cause": SpeedCause.TURN_SPEED, "turn": 0.698132, "value": 5.0},
            "the tool turns 40° on it, rotation speed 286°/s",
            "orientation_speed",
        ),
        (
            {"cause": SpeedCause.TURN_ACCELERATION, "turn": 0.698132, "value": 6.0},
            "rotation acceleration 344°/s²",
            "orientation_acceleration",
        ),
        (
            {"cause": SpeedCause.ZONE, "value": 0.002, "corner": 1.5},
            "a zone of 2 mm at a corner of 85.9°",
            "larger zone",
        ),
        ({"cause": SpeedCause.BEND, "value": 0.02}, "the way is bent, radius 20 mm", "wider bend"),
        (
            {
                "cause": SpeedCause.JOINT,
                "joint": "4",
                "quantity": LimitQuantity.SPEED,
                "singularity": "wrist",
            },
            "joint `4` is at its speed limit, near the singularity of the wrist",
            'orientation = "wrist angles"',
        ),
        ({"cause": SpeedCause.EXTERNAL}, "an external axis", "external axes"),
        ({"cause": SpeedCause.LOOK_AHEAD}, "does not look further ahead", "look_ahead"),
    ],
)
def test_the_message_says_what_is_reached_and_why_and_what_helps(
    changes: dict[str, object], words: str, helps: str
) -> None:
    (one,) = found(move(7, replace(SLOW, **changes)))  # type: ignore[arg-type]
    assert one.span is not None
    assert (one.code, one.span.line, one.severity.value) == ("S727", 7, "hint")
    assert "this move of 10 mm reaches 180 of 400 mm/s: " in one.message
    assert words in one.message
    assert helps in (one.hint or "")


def test_a_move_that_reaches_its_speed_somewhere_says_how_fast_it_is_on_average() -> None:
    (one,) = found(move(7, replace(SLOW, top=0.4, length=0.1, cause=SpeedCause.ZONE)))
    assert "is flown at 200 of 400 mm/s on average" in one.message


def test_what_costs_next_to_nothing_is_not_said() -> None:
    assert found(move(7, None), move(8, replace(SLOW, lost=0.09))) == ()
    many = [move(20 + k, None, ordinal=k) for k in range(60)]  # 30 s: 2 % are 0.6 s
    assert found(move(7, ordinal=60), *many) == ()
    assert len(found(move(7, replace(SLOW, lost=0.7), ordinal=60), *many)) == 1


def test_passes_of_a_line_are_said_once_and_add_up() -> None:
    (one,) = found(*(move(7, replace(SLOW, lost=0.05 + 0.01 * k), ordinal=k) for k in range(3)))
    assert one.message.endswith(
        "; in 3 passes it takes 1.50 s, 1.25 s of it for ramps at stops, at full speed all the way 0.07 s"
    )
    assert one.data["lost_s"] == pytest.approx(0.18)


def test_time_that_a_line_does_not_lose_at_stops_is_not_called_ramps() -> None:
    (one,) = found(move(7, replace(SLOW, lost=0.475)))
    assert one.message.endswith("; it takes 0.50 s, at full speed all the way 0.02 s")


@pytest.mark.parametrize(
    ("helps", "advice"),
    [
        ((LimitQuantity.JERK,), "; or more `path_jerk`, if"),
        ((LimitQuantity.ACCELERATION,), "; or more `path_acceleration`, if"),
        (
            (LimitQuantity.JERK, LimitQuantity.ACCELERATION),
            "; or more `path_jerk` and `path_acceleration`, if",
        ),
        ((), None),
        (None, None),
    ],
)
@pytest.mark.parametrize(
    "cause", [SpeedCause.ACCELERATION, SpeedCause.JERK, SpeedCause.ZONE, SpeedCause.BEND]
)
def test_only_limits_that_help_are_advised(
    helps: tuple[LimitQuantity, ...] | None, advice: str | None, cause: SpeedCause
) -> None:
    (one,) = found(move(7, replace(SLOW, cause=cause, value=2.0, helps=helps)))
    assert one.hint is not None
    assert (advice is None) == ("path_" not in one.hint)
    assert advice is None or advice in one.hint


def test_many_moves_of_a_line_are_summed_up_with_the_cause_that_costs_most() -> None:
    worst = replace(SLOW, lost=0.11, cause=SpeedCause.ZONE, value=0.002, corner=1.5)
    moves = [
        move(7, replace(SLOW, lost=0.06, cause=SpeedCause.BEND, value=0.02), ordinal=k) for k in range(6)
    ]
    (one,) = found(*moves, move(7, worst, ordinal=6))
    assert one.message.startswith(
        "7 moves of this line, 10 mm long on average, are flown at 20 of 400 mm/s: the way is bent"
    )
    assert "wider bend" in (one.hint or "")


def test_a_curve_through_many_points_is_told_what_is_quicker() -> None:
    curve = replace(move(7, replace(SLOW, cause=SpeedCause.BEND, value=0.02, points=2000)), motion="SPLINE")
    (one,) = found(curve)
    assert one.hint is not None
    assert "fewer of them" in one.hint
    assert "`lin along … blend …`" in one.hint
    few = replace(move(7, replace(SLOW, cause=SpeedCause.BEND, value=0.02, points=5)), motion="SPLINE")
    assert "fewer" not in (found(few)[0].hint or "")


def test_a_line_that_is_reported_for_its_joint_already_is_left_out() -> None:
    assert [one.span.line for one in found(move(7), move(8), slowed=frozenset({7})) if one.span] == [8]


def test_a_chain_of_many_lines_is_said_once_at_its_first_line() -> None:
    chain = [move(10 + k, ordinal=k, flown=0.001 if k < 7 else 0.0) for k in range(8)]
    (one,) = found(*chain)
    assert one.span is not None
    assert one.span.line == 10
    assert "a chain of 8 lines begins here that is flown at 20 of 400 mm/s" in one.message
    assert (
        "; it takes 4.00 s, 1.40 s of it for ramps at stops, at full speed all the way 0.20 s" in one.message
    )
    assert one.data["lines"] == 8


def test_several_chains_are_one_finding_too() -> None:
    chains = [
        move(10 + 10 * n + k, ordinal=10 * n + k, flown=0.001 if k < 7 else 0.0)
        for n in range(3)
        for k in range(8)
    ]
    (one,) = found(*chains)
    assert "; with 2 more chains like this it takes 12.00 s" in one.message


def test_moves_with_stops_between_them_are_no_chain() -> None:
    assert len(found(*(move(10 + k, ordinal=2 * k) for k in range(8)))) == 8


CELL: Cell = one_station(
    "c", PUMA, robots.default_controller("puma560"), tools={"": Tool("")}, start=PUMA.home
)


def ran(*lines: str) -> Recording:
    return run(CELL, {"robot": code_of(CELL, *lines)}, RunOptions(Fidelity.KINEMATIC))


def hints(recording: Recording) -> list[int]:
    return [one.span.line for one in recording.findings if one.code == "S727" and one.span]


def test_a_short_approach_to_a_stop_is_quiet_and_a_tight_arc_is_not() -> None:
    assert hints(ran("mov (500, 0, 320)", "lin (500, 0, 300) speed 250 mm/s", "lin (500, 0, 320)")) == []
    tight = ran("mov (500, -40, 300)", "circ via (540, 0, 300) to (500, 40, 300) speed 900 mm/s")
    assert hints(tight) == [4]
    _, arc = tight.events_of(MoveEvent)
    assert arc.reached is not None
    assert arc.reached.cause is SpeedCause.BEND
    assert arc.reached.top < 0.9 * 0.9


@pytest.mark.parametrize("cause", SpeedCause)
def test_every_cause_has_words_and_help(cause: SpeedCause) -> None:
    (one,) = found(move(7, replace(SLOW, cause=cause)))
    assert one.message
    assert one.hint
