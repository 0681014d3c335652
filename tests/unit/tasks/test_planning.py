"""Plans: as short as any, against a search of its own; why there is none; lazy geometry; limits."""

import random
from collections import deque
from collections.abc import Iterator

import pytest

from ropsim.tasks import WorldState
from support.knowledge import GEOMETRY, base
from support.patience import PATIENCE

Places = tuple[str, ...]
"""Where each part is; `hand` for the one that is held."""


def shortest(begin: Places, goal: Places, places: list[str]) -> int | None:
    """Return the fewest tasks by breadth-first search in terms of places; geometry is that of `GEOMETRY`."""
    seen, ahead = {begin: 0}, deque([begin])
    while ahead:
        now = ahead.popleft()
        if now == goal:
            return seen[now]
        for after in following(now, places):
            if after not in seen:
                seen[after] = seen[now] + 1
                ahead.append(after)
    return None


def following(now: Places, places: list[str]) -> Iterator[Places]:
    """Yield where parts can be after one task."""
    for index, at in enumerate(now):
        if at == "hand":
            for place in places:
                refused = ("arm", place) in GEOMETRY.refused or (
                    "arm",
                    f"p{index}",
                    place,
                ) in GEOMETRY.refused
                if place not in now and not refused:
                    yield (*now[:index], place, *now[index + 1 :])
        elif "hand" not in now and not {("arm", at), ("arm", f"p{index}", at)} & GEOMETRY.refused:
            yield (*now[:index], "hand", *now[index + 1 :])


def state_of(now: Places, places: list[str]) -> WorldState:
    """Return the same as facts."""
    held = [f"held(p{index})" for index, at in enumerate(now) if at == "hand"]
    facts = [f"at(p{index}, {at})" for index, at in enumerate(now) if at != "hand"]
    free = [f"free({place})" for place in places if place not in now]
    return WorldState.of(*facts, *free, *held, f"gripper({'closed' if held else 'open'})")


@pytest.mark.parametrize("seed", range(25))
def test_plans_are_as_short_as_those_of_a_breadth_first_search(seed: int) -> None:
    chance = random.Random(seed)
    known = base()
    places = [f"s{index}" for index in range(chance.randint(3, 5))]
    parts = chance.randint(1, 3)
    begin, goal = (tuple(chance.sample(places, parts)) for _ in range(2))
    carried = [
        ("arm", f"p{part}", place) for part in range(parts) for place in places if chance.random() < 0.2
    ]
    GEOMETRY.refuse(*carried, *(("arm", place) for place in places if chance.random() < 0.15))
    best = shortest(begin, goal, places)
    plan = known.plan([f"at(p{index}, {at})" for index, at in enumerate(goal)], state_of(begin, places))
    assert plan.ok == (best is not None)
    if best is None:
        assert [one.code for one in plan.findings] == ["P154"]
        return
    assert len(plan.calls) == best
    reports = known.check_all(plan.calls, state_of(begin, places))
    assert all(one.ok for one in reports)
    after = reports[-1].state if reports else state_of(begin, places)
    assert all(after.holds(f"at(p{index}, {at})") for index, at in enumerate(goal))


def test_eight_parts_that_stand_in_each_others_way_find_their_places() -> None:
    places = [f"s{index}" for index in range(8)]
    begin = tuple(places)
    goal = tuple(places[(index + 1) % 8] for index in range(8))
    plan = base().plan(
        [f"at(p{k}, {at})" for k, at in enumerate(goal)], state_of(begin, [*places, "b1", "b2"])
    )
    assert len(plan.calls) == 18  # each part twice, and one of them over a free place
    assert plan.looked_at < 200


def test_geometry_is_asked_only_for_what_a_plan_would_use() -> None:
    known = base()
    places = [f"s{index}" for index in range(10)]
    plan = known.plan(["at(p0, s5)"], state_of(tuple(places[:4]), places))
    assert [str(one) for one in plan.calls] == ["grip s0", "release s5"]
    assert GEOMETRY.asked == [("arm", "s0"), ("arm", "p0", "s0"), ("arm", "s5"), ("arm", "p0", "s5")]
    assert plan.calls[0].objects == (("P", "p0"),)


def test_parts_that_wait_in_a_supply_are_taken_one_after_the_other() -> None:
    queue = [f"follows(b{k + 1}, b{k})" for k in range(3)]
    state = WorldState.of("at(b0, feed)", *queue, "free(s1)", "free(s2)", "free(s3)", "gripper(open)")
    plan = base().plan(["at(b1, s1)", "at(b2, s2)"], state)
    assert [str(one) for one in plan.calls][4:] == ["grip feed", "release s2"]
    assert [dict(one.objects)["P"] for one in plan.calls] == ["b0", "b0", "b1", "b1", "b2", "b2"]
    assert base().check_all(plan.calls, state)[-1].state.holds("at(b3, feed)")
    assert not base().plan(["at(b4, s1)"], state).ok


@pytest.mark.parametrize(
    ("goal", "refused", "words"),
    [
        ("painted(p0)", (), "no task can make `painted(p0)`"),
        ("at(p9, s1)", (), "no task can make `p9` in the gripper"),
        (
            "at(p0, s1)",
            (("arm", "s1"),),
            "geometry refuses what would make `p0` at `s1`: `s1` cannot be reached",
        ),
        (
            "at(p0, s1)",
            (("arm", "s0"),),
            "geometry refuses what would make `p0` in the gripper: `s0` cannot be reached",
        ),
        ("at(p0, s1)", (("arm", "p0", "s1"),), "at `s1` the part `p0` would be 12.3 mm deep in `post`"),
    ],
)
def test_it_is_said_why_there_is_no_plan(goal: str, refused: tuple[tuple[str, ...], ...], words: str) -> None:
    known = base()
    GEOMETRY.refuse(*refused)
    (finding,) = known.plan([goal], state_of(("s0", "s3"), ["s0", "s1", "s2", "s3"])).findings
    assert finding.code == "P154"
    assert words in finding.message


@pytest.mark.parametrize(
    ("count", "end"), [(3, "`s2` cannot be reached"), (5, "`s2` cannot be reached, and 2 more")]
)
def test_of_many_refusals_three_are_named_and_the_others_counted(count: int, end: str) -> None:
    known, places = base(), [f"s{index}" for index in range(count)]
    GEOMETRY.refuse(*(("arm", place) for place in places))
    (finding,) = known.plan(["gripper(open)"], state_of(("hand",), places)).findings
    assert finding.message.endswith(end)


def test_goals_that_exclude_each_other_are_told_as_that() -> None:
    (finding,) = base().plan(["at(p0, s1)", "held(p0)"], state_of(("s0",), ["s0", "s1"])).findings
    assert "not all of them together" in finding.message


def test_a_goal_that_holds_needs_no_task() -> None:
    plan = base().plan(["at(p0, s0)"], state_of(("s0",), ["s0", "s1"]))
    assert (plan.ok, plan.calls) == (True, ())


def test_tasks_of_a_project_take_part_with_their_rules_and_defaults() -> None:
    text = """\
clear(L) :- location(L), \\+ at(_, L).
location(s1). location(s2).
task(shove(P, A, B, V), [params([P-part, A-location, B-location, V-speed = 5*mm/s]),
  pre([at(P, A), clear(B), A \\= B]), eff([-at(P, A), +at(P, B)]), body([mov(A), lin(B, [speed(V)])])]).
"""
    known = base(text)
    assert known.findings == ()
    plan = known.plan(["at(box, s2)"], WorldState.of("at(box, s1)"))
    assert [str(one) for one in plan.calls] == ["shove s1, s2, 5 mm/s"]
    blocked = known.plan(["at(box, s2)"], WorldState.of("at(box, s1)", "at(lid, s2)"))
    assert not blocked.ok


def in_a_circle(count: int) -> tuple[list[str], WorldState]:
    """Return goal and state of parts that stand in each other's places; no other place takes any of them."""
    places = [f"s{index}" for index in range(count)]
    GEOMETRY.refuse(*(("arm", f"p{part}", "b") for part in range(count)))
    goal = [f"at(p{part}, {place})" for part, place in enumerate([*places[1:], places[0]])]
    return goal, state_of(tuple(places), [*places, "b"])


def test_progress_is_told_and_a_plan_can_be_cancelled() -> None:
    known = base()
    goal, state = in_a_circle(5)
    told: list[int] = []

    def stop(looked_at: int) -> None:
        told.append(looked_at)
        known.cancel()

    plan = known.plan(goal, state, seconds=PATIENCE, progress=stop)
    assert told == [50]
    assert [one.code for one in plan.findings] == ["P155"]
    assert "cancelled" in plan.findings[0].message


def test_a_plan_that_takes_too_long_is_stopped_and_the_base_goes_on() -> None:
    known = base()
    goal, state = in_a_circle(8)
    assert [one.code for one in known.plan(goal, state, seconds=0.05).findings] == ["P155"]
    assert known.plan(["at(p0, b)"], state).findings[0].code == "P154"
    assert known.check("grip s0", state).ok


def test_a_function_that_fails_is_told() -> None:
    known = base()
    state = WorldState.of("gripper(open)", "at(bolt, pose(3))", "free(s1)", "location(pose(3))")
    (finding,) = known.plan(["held(bolt)"], state).findings
    assert finding.code == "P155"
    assert "location" in finding.message


def test_patterns_are_no_way_to_a_goal_as_nobody_tells_their_numbers() -> None:
    state = WorldState.of("gripper(open)", "at(bolt, s1)", "free(s2)", "location(s1)", "location(s2)")
    plan = base().plan(["at(bolt, s2)"], state)
    assert [one.name for one in plan.calls] == ["grip", "release"]
    assert plan.looked_at <= 3
    (finding,) = base().plan(["held(nut)"], WorldState.of("gripper(open)", "at(bolt, s1)")).findings
    assert "nut" in finding.message
