"""Plans: as short as any, against a search of its own; why there is none; lazy geometry; limits."""

import random
from collections import deque
from collections.abc import Iterator

import pytest

from ropsim.tasks import WorldState
from support.examples import examples
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


@pytest.mark.parametrize("seed", range(examples(25)))
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


def test_goals_that_are_possible_alone_and_not_together_are_said_to_be_so() -> None:
    known = base()
    (finding,) = known.plan(*in_a_circle(2)).findings
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
    places = [f"s{index}" for index in range(12)]
    goal = [f"at(p{part}, {place})" for part, place in enumerate([*places[1:], places[0]])]
    state = state_of(tuple(places), [*places, "b"])
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
    goal, state = in_a_circle(24)
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


def cell_of(now: Places, places: list[str], *facts: str) -> WorldState:
    """Return the same in a cell that has locations."""
    more = (*facts, *(f"location({place})" for place in places))
    return WorldState((*state_of(now, places).facts, *WorldState.of(*more).facts))


PLACES = "params([P-part, A-location, B-location, C-location])"
PICKED = "eff([-gripper(open), +gripper(closed), -at(P, A), +held(P), +free(A)])"
REACHED = "geo([reachable(arm, A), reachable(arm, B), reachable(arm, C)])"
WAY = "body([mov(B), mov(A), close, mov(C)])"
THREE_PLACES = {
    "over two others": (
        f"task(t(P, A, B, C), [{PLACES}, pre([gripper(open), at(P, A)]), {PICKED}, {REACHED}, {WAY}])."
    ),
    "over two that are locations": (
        f"task(t(P, A, B, C), [{PLACES}, pre([gripper(open), at(P, A), location(B), location(C)]), "
        f"{PICKED}, {REACHED}, {WAY}])."
    ),
    "over two free ones": (
        f"task(t(P, A, B, C), [{PLACES}, pre([gripper(open), at(P, A), free(B), free(C)]), "
        f"{PICKED}, {REACHED}, {WAY}])."
    ),
    "marks that nobody reads": (
        "task(t(A, B, C), [params([A-location, B-location, C-location]), pre([gripper(open)]), "
        "eff([+swept(A), +swept(B), +free(C)]), geo([reachable(arm, A)]), body([mov(A), mov(B), mov(C)])])."
    ),
    "two parts that change places": (
        "task(t(P, Q, A, B, C), [params([P-part, Q-part, A-location, B-location, C-location]), "
        "pre([gripper(open), at(P, A), at(Q, B), free(C)]), "
        "eff([-at(P, A), -at(Q, B), +at(Q, A), +at(P, B)]), "
        "geo([reachable(arm, C)]), body([mov(A), close, mov(C), open])])."
    ),
    "three parts that change places": (
        "task(t(P, Q, R, A, B, C), [params([P-part, Q-part, R-part, A-location, B-location, C-location]), "
        "pre([gripper(open), at(P, A), at(Q, B), at(R, C)]), "
        "eff([-at(P, A), -at(Q, B), -at(R, C), +at(P, B), +at(Q, C), +at(R, A)]), "
        "body([mov(A), mov(B), mov(C)])])."
    ),
}
AT_MOST = 4.0
"""A task of the user with three places may make planning take so many times the inferences."""


@pytest.mark.slow
@pytest.mark.parametrize("what", THREE_PLACES)
def test_a_task_with_three_places_costs_the_rotation_of_eight_parts_little(what: str) -> None:
    places = [f"s{index}" for index in range(8)]
    goal = [f"at(p{k}, {places[(k + 1) % 8]})" for k in range(8)]
    state = cell_of(tuple(places), [*places, "b1", "b2"])
    without = base().plan(goal, state, seconds=PATIENCE)
    known = base(THREE_PLACES[what])
    plan = known.plan(goal, state, seconds=PATIENCE)
    assert plan.ok, plan.findings
    assert 0 < plan.inferences <= AT_MOST * without.inferences
    assert len(plan.calls) <= len(without.calls) == 18
    after = known.check_all(plan.calls, state)
    assert all(one.ok for one in after)
    assert all(after[-1].state.holds(one) for one in goal)


def test_places_that_only_geometry_looks_at_are_the_first_that_it_allows() -> None:
    known = base(THREE_PLACES["over two others"] + PARKED)
    GEOMETRY.refuse(("arm", "s0"), ("arm", "s1"))
    plan = known.plan(["resting(p0)"], cell_of(("s2",), ["s0", "s1", "s2", "s3"]))
    assert [str(one) for one in plan.calls] == ["grip s2", "rest s2, s2"]


PARKED = """
task(rest(P, A, B), [params([P-part, A-location, B-location]), pre([held(P)]), eff([+resting(P)]),
  geo([reachable(arm, A), reachable(arm, B)]), body([mov(A), mov(B)])]).
goal(resting/1).
"""


@pytest.mark.parametrize(
    ("one", "other", "words"),
    [
        ("at(p0, s1)", "at(p0, s3)", "`p0` at `s1` and `p0` at `s3`"),
        ("at(p0, s3)", "at(p1, s3)", "`p0` at `s3` and `p1` at `s3`"),
        ("held(p0)", "held(p1)", "`p0` in the gripper and `p1` in the gripper"),
        ("gripper(open)", "held(p0)", "an open gripper and `p0` in the gripper"),
        ("gripper(closed)", "gripper(open)", "a closed gripper and an open gripper"),
        ("at(p0, s2)", "held(p0)", "`p0` at `s2` and `p0` in the gripper"),
        ("at(p0, s3)", "free(s3)", "`p0` at `s3` and an empty place `s3`"),
        ("door(open)", "door(shut)", "`door(open)` and `door(shut)`"),
    ],
)
def test_goals_that_exclude_each_other_are_named_at_once(one: str, other: str, words: str) -> None:
    known = base(DOOR)
    state = cell_of(("s1", "s2"), ["s1", "s2", "s3", "e1"], "door(shut)")
    plan = known.plan([one, other], state)
    assert [finding.message for finding in plan.findings] == [f"no plan: {words} exclude each other"]
    assert plan.looked_at == 0
    assert GEOMETRY.asked == []
    assert known.plan([one], state).ok
    assert known.plan([other], state).ok


DOOR = """
task(lift, [eff([-door(shut), +door(open)]), pre([door(shut)]), body([mov(home)])]).
task(drop, [eff([-door(open), +door(shut)]), pre([door(open)]), body([mov(home)])]).
given(door/1).
"""


@pytest.mark.parametrize(
    ("goal", "text"),
    [
        (["at(p0, s2)", "at(p1, s1)"], ""),
        (["at(p0, s3)", "gripper(open)"], ""),
        (["inserted(p0)", "held(p0)"], ""),
        # A task that makes both, whatever the library does.
        (
            ["at(p0, s1)", "at(p0, s3)"],
            "task(copied(P, A, B), [params([P-part, A-location, B-location]), pre([at(P, A), free(B)]), "
            "eff([+at(P, B), -free(B)]), body([mov(A), mov(B)])]).",
        ),
    ],
)
def test_goals_that_can_both_be_made_are_not_said_to_exclude_each_other(goal: list[str], text: str) -> None:
    assert base(text).plan(goal, cell_of(("s1", "s2"), ["s1", "s2", "s3"]), seconds=PATIENCE).ok


@pytest.mark.slow
def test_a_plan_that_need_not_be_the_fewest_says_so() -> None:
    known = base(THREE_PLACES["three parts that change places"])
    places = [f"s{index}" for index in range(8)]
    goal = [f"at(p{k}, {places[(k + 1) % 8]})" for k in range(8)]
    begin = cell_of(tuple(places), [*places, "b1", "b2"])
    assert not known.plan(goal, begin, seconds=PATIENCE).is_fewest
    assert base().plan(goal, begin, seconds=PATIENCE).is_fewest


@pytest.mark.parametrize(
    ("goal", "message", "hint"),
    [
        ("at(bolt, tabel)", "there is no location `tabel`", "did you mean `table`?"),
        ("at(bolt, nowhere)", "there is no location `nowhere`", "there are `s1`, `table`"),
        ("held(boltt)", "there is no part `boltt`", "did you mean `bolt`?"),
        ("parked(no_place)", "there is no location `no_place`", "there are `s1`, `s2`"),
        ("parkt(s1)", "no task can make `parkt(s1)`", "did you mean `parked`?"),
        ("parked", "no task can make `parked`", "`parked` has 1 argument, given: 0"),
    ],
)
def test_a_goal_that_names_what_is_not_there_is_told_so_with_a_near_name(
    goal: str, message: str, hint: str
) -> None:
    state = WorldState.of(
        "gripper(open)", "at(bolt, s1)", "free(table)", "location(s1)", "location(table)", "part(bolt)"
    )
    (finding,) = base().plan([goal], state).findings
    assert (finding.code, finding.message) == ("P154", f"no plan: {message}")
    assert finding.hint == hint


def test_a_condition_that_names_a_robot_that_is_not_there_is_told_so() -> None:
    known = base("task(t(L), [params([L-location]), geo([reachable(amr, L)]), body([mov(L)])]).")
    report = known.check("t s1", WorldState.of("location(s1)"))
    (finding,) = report.findings
    assert finding.message == "`t` is not possible here: there is no robot `amr`"
    assert finding.hint == "did you mean `arm`?"
