"""Calls against a state: there, called rightly, possible, within reach; and what an operator is told."""

from itertools import pairwise

import pytest

from ropsim.prolog import Atom, Struct, Var, write_term
from ropsim.tasks import Quantity, TaskCall, TaskError, WorldState, fact_words
from ropsim.tasks.testing import neighbours, places_in_rows
from support.knowledge import GEOMETRY, base

CELL = WorldState.of("gripper(open)", "at(bolt, s1)", "at(nut, s2)", "free(s3)")


def behind(part: str, count: int) -> list[str]:
    """Return the facts that so many parts wait behind one in its supply."""
    queue = [part, *(f"{part}_{number}" for number in range(count))]
    return [f"follows({one}, {before})" for before, one in pairwise(queue)]


def test_calls_in_a_row_carry_the_state() -> None:
    reports = base().check_all(["grip s1", "grip s2", "release s3", "grip s2", "release s1"], CELL)
    assert [one.ok for one in reports] == [True, False, True, True, True]
    assert reports[0].call.objects == (("P", "bolt"),)
    assert {one.unchecked for one in reports} == {("draughts",)}
    assert reports[1].state == reports[0].state
    assert reports[-1].state == WorldState.of("at(bolt, s3)", "at(nut, s1)", "free(s2)", "gripper(open)")


def test_a_task_that_is_not_there_is_told_with_a_near_one() -> None:
    report = base().check("palletise s1, s2, 0.1, 6", CELL)
    assert [(one.code, one.message) for one in report.findings] == [("P150", "Task not defined: `palletise`")]
    assert report.findings[0].hint == "did you mean `palletize`?"
    assert report.fails == (Struct("fails", (Atom("task"), Atom("palletise"))),)
    assert report.message == "Task not defined: `palletise`"


@pytest.mark.parametrize(
    ("call", "words"),
    [
        ("grip", "`grip` takes 1 point, given: 0"),
        ("grip s1, s2", "`grip` takes 1 point, given: 2"),
        ("grip s1, 3", "`grip` takes 0 parameters, given: 1"),
        ("grip (1, 2, 3, 4, 5, 6)", None),
        (TaskCall("grip", ((1.0, 2.0),)), "a point has 3, 5 or 6 numbers, given: 2"),
        ("pick s1, 3 s", "`clearance` of `pick` is in cm, inch, m, mm, given: 3 s"),
        ("palletize s1, s2, 10 mm, 2.5", "`parts in a row` of `palletize` is a whole number, given: 2.5"),
        (
            "palletize s1, s2, 10 mm, 2 mm",
            "`parts in a row` of `palletize` is a value of kind `int` without a unit, given: 2 mm",
        ),
        ("palletize s1, s2, true, 2", "`distance` of `palletize` is a value of kind `length`, given: True"),
        (TaskCall("palletize", ("s1", "s2"), (Quantity(1, "cm"), 2)), None),
        ("palletize s1, s2, 10 mm, 1", None),
        ("palletize s1, s2, 10 mm, 0", "`parts in a row` of `palletize` is at least 1, given: 0"),
        ("palletize s1, s2, 0 mm, 1", "`distance` of `palletize` is more than 0 mm, given: 0 mm"),
        ("load_pallet s1, s2, 2, 2, 0", "`distance` of `load_pallet` is more than 0 mm, given: 0"),
        ("pick s1, -1 cm", "`clearance` of `pick` is at least 0 mm, given: -1 cm"),
        ("pick s1, 0 inch", None),
        ("insert s1, 0 m/s", "`speed` of `insert` is more than 0 mm/s, given: 0 m/s"),
        ("insert s1, 5 %", None),
    ],
)
def test_points_and_parameters_are_counted_and_have_kinds(call: TaskCall | str, words: str | None) -> None:
    report = base().check(call, CELL)
    wrong = [one for one in report.findings if one.code == "P151"]
    assert [one.message for one in wrong] == ([] if words is None else [words])
    if words is not None:
        assert report.fails == (Struct("fails", (Atom("call"), words)),)


def test_what_is_missing_is_told_with_the_tasks_that_could_provide_it() -> None:
    report = base().check("release s3", CELL)
    assert [one.message for one in report.findings] == [
        "`release` is not possible now: a closed gripper is needed",
        "`release` is not possible now: a part in the gripper is needed",
    ]
    assert report.fails[1] == Struct("fails", (Atom("pre"), Struct("held", (Var("P"),))))
    assert report.providers == ("grip", "pick")  # nothing is in a machine that could be unloaded
    assert report.findings[1].hint == "`grip`, `pick` could provide it"
    assert not report.ok


def test_what_nobody_provides_is_told_too() -> None:
    known = base("task(a(P), [params([P-part]), pre([blessed(P)])]).")
    (finding,) = known.check("a", CELL).findings
    assert finding.message == "`a` is not possible now: `blessed(P)` is needed"
    assert finding.hint == "no task provides it now: state it, or change the cell"


def test_a_thing_that_nobody_names_is_asked_for() -> None:
    known = base("task(a(D), [params([D-device])]).")
    (finding,) = known.check("a", CELL).findings
    assert "device" in finding.message
    assert known.check("a", WorldState.of("device(oven)")).call.objects == (("D", "oven"),)


def test_geometry_is_asked_last_and_once_per_revision() -> None:
    known = base()
    GEOMETRY.refuse(("arm", "s1"))
    assert known.check("grip s3", CELL).findings[0].code == "P152"
    assert GEOMETRY.asked == []
    report = known.check("grip s1", CELL)
    assert [(one.code, one.message) for one in report.findings] == [
        ("P153", "`grip` is not possible here: `s1` cannot be reached")
    ]
    assert report.fails == (Struct("fails", (Atom("geo"), Struct("reachable", (Atom("arm"), Atom("s1"))))),)
    known.check("grip s1", CELL)
    assert GEOMETRY.asked == [("arm", "s1"), ("arm", "bolt", "s1")]
    GEOMETRY.refuse()
    assert known.check("grip s1", CELL).ok
    assert GEOMETRY.asked == [("arm", "s1"), ("arm", "bolt", "s1")]


def test_of_two_parts_the_one_is_taken_that_geometry_allows() -> None:
    known = base()
    GEOMETRY.refuse(("arm", "bolt", "s3"))
    state = WorldState.of("gripper(closed)", "held(bolt)", "held(nut)", "free(s3)")
    assert known.check("release s3", state).call.objects == (("P", "nut"),)


def test_rules_are_conditions_over_the_state() -> None:
    text = """\
clear(L) :- location(L), \\+ at(_, L).
above(X, Y) :- on(X, Y).
above(X, Z) :- on(X, Y), above(Y, Z).
loop(X) :- loop(X).
location(s1). location(s3). on(a, b). on(b, c).
task(go(L), [params([L-location]), pre([clear(L), above(a, c), \\+ above(c, _)])]).
task(never(L), [params([L-location]), pre([loop(L)])]).
"""
    known = base(text)
    assert known.findings == ()
    assert known.check("go s3", CELL).ok
    assert known.check("go s1", CELL).message == "`go` is not possible now: `clear(s1)` is needed"
    assert not known.check("never s1", CELL).ok


def test_points_are_compared_by_their_numbers() -> None:
    state = WorldState.of("gripper(open)", "at(bolt, p(13.0,5.0,8.0))")
    assert base().check(TaskCall("grip", ((13.0, 5.0, 8.0),)), state).ok
    assert not base().check(TaskCall("grip", ((13.0, 5.0, 9.0),)), state).ok


def test_a_place_given_by_numbers_is_free_where_nothing_lies() -> None:
    there, other = ((1.0, 2.0, 3.0),), ((4.0, 5.0, 6.0),)
    calls = [TaskCall("grip", ("s1",)), TaskCall("release", there), TaskCall("grip", ("s2",))]
    reports = base().check_all([*calls, TaskCall("release", there), TaskCall("release", other)], CELL)
    assert [one.ok for one in reports] == [True, True, True, False, True]


@pytest.mark.parametrize(
    "text", ["", "mov s1", "grip s1\ngrip s2", "grip (1 +", "grip s1 above 3", "grip external"]
)
def test_what_is_no_call_is_refused(text: str) -> None:
    with pytest.raises(TaskError, match="P156"):
        base().check(text if text != "grip external" else "grip s1 external (1)", CELL)


@pytest.mark.parametrize("fact", ["at(X, s1)", "", "at(bolt", "at(bolt) at(nut)", "3", "[a]"])
def test_what_is_no_fact_is_refused(fact: str) -> None:
    with pytest.raises(TaskError, match="P156"):
        WorldState.of(fact)


def test_geometry_holds_at_every_place_of_a_pattern() -> None:
    known, state = base(), WorldState.of(*CELL.facts, *behind("bolt", 9))
    GEOMETRY.refuse(("arm", "(610.0, -20.0, 5.0)"))
    (finding,) = known.check("load_pallet s1, (10, -20, 5), 5, 2, 150", state).findings
    assert finding.code == "P153"
    assert finding.message == (
        "`load_pallet` is not possible here: row 1, column 5 at `(610, -20, 5)` cannot be reached"
    )
    assert finding.hint == "take less for `parts in a row`, `distance`, or choose another location"
    GEOMETRY.refuse(("arm", "bolt", "s3 rel (150, -300, 0)"))
    (finding,) = known.check("load_pallet s1, s3, 2, 3, 15 cm", state).findings
    assert "row 3, column 2 at `s3 rel (150, -300, 0)` the part `bolt` would be 12.3 mm" in finding.message


def test_parts_of_a_pattern_do_not_lie_in_each_other() -> None:
    rods = WorldState.of("gripper(open)", "at(rod, s1)", "free(s3)", *behind("rod", 3))
    (finding,) = base().check("load_pallet s1, s3, 2, 2, 50", rods).findings
    assert finding.message == (
        "`load_pallet` is not possible here: "
        "parts 50 mm apart would be 10 mm in each other: `rod` is 60 mm long there"
    )
    assert finding.hint == "take a distance of 60 mm or more"
    for fitting in ("2, 2, 60", "1, 3, 50", "1, 1, 50"):  # they lie beside each other across
        assert base().check(f"load_pallet s1, s3, {fitting}", rods).ok


@pytest.mark.parametrize(("shape", "count"), [((1, 1), 0), ((3, 1), 1), ((1, 3), 1), ((2, 2), 4)])
def test_a_place_of_a_pattern_has_neighbours_along_both_diagonals(shape: tuple[int, int], count: int) -> None:
    assert len(neighbours(*shape)) == count


def test_of_a_large_pattern_it_is_said_how_much_was_not_looked_at() -> None:
    known = base()
    state = WorldState.of(*CELL.facts, *behind("bolt", 99))
    report = known.check("load_pallet s1, s3, 10, 10, 75", state)
    assert report.ok
    assert len(GEOMETRY.asked) == 1 + 2 * 64
    assert report.unchecked == ("draughts", "36 of 100 places of the pattern")
    assert report.state.holds("at(bolt, s3)")
    assert known.check("unload_pallet s3, s1, 2, 2, 75", report.state).ok
    assert known.check("grip s2", CELL).unchecked == ("draughts",)


QUEUE = ("at(b0, feed)", "follows(b1, b0)", "follows(b2, b1)", "location(feed)", "gripper(open)")


def test_a_supply_brings_the_next_part_to_where_one_was_taken() -> None:
    state = WorldState.of(*QUEUE, "free(s1)", "free(s2)", "free(s3)")
    reports = base().check_all([f"{one} feed" if one == "pick" else one for one in (
        "pick", "place s1", "pick", "place s2", "pick", "place s3", "pick",
    )], state)  # fmt: skip
    assert [one.ok for one in reports] == [True] * 6 + [False]
    assert [reports[at].call.objects for at in (0, 2, 4)] == [(("P", f"b{at}"),) for at in range(3)]
    assert reports[0].state.holds("at(b1, feed)")
    assert not reports[0].state.holds("free(feed)")
    assert reports[4].state.holds("free(feed)")
    assert reports[2].state.holds("follows(b2, b1)") is False
    back = base().check_all(["pick s1", "place feed", "pick feed"], reports[5].state)
    assert back[-1].call.objects == (("P", "b0"),)


def test_after_a_pallet_is_filled_it_is_known_what_lies_where_and_what_the_supply_brings_next() -> None:
    state, first = WorldState.of(*QUEUE, "free(s1)"), (100.0, 200.0, 50.0)
    filled = base().check(TaskCall("load_pallet", ("feed", first), (2, 1, Quantity(75, "mm"))), state).state
    lying = ("at(b0, p(100.0,200.0,50.0))", "at(b1, p(175.0,200.0,50.0))", "at(b2, feed)")
    assert [filled.holds(one) for one in lying] == [True] * 3
    assert base().check(TaskCall("pick", ((175.0, 200.0, 50.0),)), filled).call.objects == (("P", "b1"),)
    more = base().check("load_pallet feed, s1, 3, 1, 75", state).state
    assert [more.holds(one) for one in ("at(b0, s1)", "free(feed)", "at(b2, feed)")] == [True, True, False]
    assert more.holds("at(b2, 's1 rel (150, 0, 0)')")
    emptied = base().check("unload_pallet s1, s3, 2, 1, 75", more).state
    assert [one for one in map(write_term, emptied.facts) if "b0" in one or "b1" in one] == []
    assert emptied.holds("at(b2, 's1 rel (150, 0, 0)')")


@pytest.mark.parametrize(
    ("waiting", "shape"), [(0, "1, 1"), (1, "1, 1"), (1, "2, 1"), (1, "1, 2"), (2, "1, 2"), (2, "3, 1")]
)
def test_where_a_pattern_takes_its_parts_a_part_lies_or_it_is_free(shape: str, waiting: int) -> None:
    queue = (f"follows(b{k + 1}, b{k})" for k in range(waiting))
    state = WorldState.of("gripper(open)", "at(b0, feed)", "free(s1)", *queue)
    report = base().check(f"load_pallet feed, s1, {shape}, 60", state)
    assert report.ok
    after = report.state
    lying = [one for one in map(write_term, after.facts) if one.startswith("at(") and one.endswith(",feed)")]
    assert after.holds("free(feed)") is (lying == [])


@pytest.mark.parametrize(
    ("call", "words"),
    [
        ("load_pallet feed, s1, 2, 2, 75", "3 parts are left at `feed`, the pattern asks for 4"),
        ("load_pallet s2, s1, 1, 2, 75", "1 part is left at `s2`, the pattern asks for 2"),
        ("depalletize feed, s1, 75, 2", "3 parts are left at `feed`, the pattern asks for 4"),
        ("depalletize s1, s3, 75, 1", "no part is left at `s1`, the pattern asks for 1"),
        ("load_pallet s1, s3, 2, 2, 75", "a part at `s1` is needed"),
        (
            "unload_pallet s2, s1, 2, 1, 75",
            "of the 2 places of its pattern one is empty, `s2 rel (75, 0, 0)`",
        ),
        ("load_pallet feed, s1, 3, 1, 75", None),
        ("load_pallet feed, s2, 1, 1, 75", "`nut` lies at `s2`, which is to be filled"),
        ("load_pallet feed, feed, 3, 1, 75", "`b0` lies at `feed`, one of the 3 places of its pattern"),
        ("depalletize feed, s2, 75, 1", "`nut` lies at `s2`, which is to be filled"),
        (TaskCall("depalletize", ("feed", "s1"), (Quantity(75, "mm"), "n")), None),
        ("depalletize s9, s1, 75, 2", None),  # nobody knows what lies there
    ],
)
def test_a_pattern_takes_no_more_parts_than_there_are(call: TaskCall | str, words: str | None) -> None:
    facts = ("free(s1)", "at(nut, s2)", "free('s2 rel (75, 0, 0)')")
    report = base().check(call, WorldState.of(*QUEUE, *facts))
    told = [one.message.partition("not possible now: ")[2] for one in report.findings]
    assert told == ([] if words is None else [words])


def test_of_places_of_a_pattern_of_which_nothing_is_known_it_is_said_how_many() -> None:
    state = WorldState.of(*QUEUE, "free(s1)")
    filled, emptied = base().check_all(
        ["load_pallet feed, s1, 2, 1, 75", "unload_pallet s1, s3, 2, 2, 75"], state
    )
    assert filled.unchecked == ("draughts",)
    assert emptied.unchecked == ("draughts", "whether parts lie at 2 of 4 places of the pattern")


@pytest.mark.parametrize(
    ("call", "hint", "providers"),
    [
        ("pick feed", "no part is left at `feed`: `release`, `place`, `insert` could bring one", 3),
        (
            "place feed",
            "no part is left that could be taken: choose another place, or bring parts there in the cell",
            0,
        ),
    ],
)
def test_a_task_is_proposed_only_where_it_could_be_done(call: str, hint: str, providers: int) -> None:
    parts = ["at(nut, s2)"] if providers else []
    report = base().check(call, WorldState.of("gripper(open)", "free(feed)", *parts))
    assert (report.findings[-1].hint, len(report.providers)) == (hint, providers)
    assert "load_pallet" not in report.providers


def test_a_named_part_that_lies_elsewhere_is_brought_by_a_task_that_can_take_it() -> None:
    text = (
        "task(weld(P), [params([P-part]), pre([at(bolt, s3), part(P)]), eff([+welded(P)])]). goal(welded/1)."
    )
    known, far = base(text), WorldState.of("gripper(open)", "part(nut)", "at(nut, s2)", "free(s3)")
    assert known.check("weld", WorldState.of(*CELL.facts, "part(nut)")).findings[0].hint == (
        "no part is left at `s3`: `release`, `place`, `insert` could bring one"
    )
    assert known.check("weld", far).providers == ()  # there is no bolt


def test_a_pattern_without_end_is_refused_as_quickly_as_any() -> None:
    for shape in ("1000000000000, 1", "1, 1000000000000", "1000000000000, 1000000000000"):
        report = base().check(f"load_pallet feed, s1, {shape}, 75", WorldState.of(*QUEUE, "free(s1)"))
        assert "3 parts are left at `feed`, the pattern asks for 1" in report.message
    first = places_in_rows("s1", 10**12, 10**12, 5.0)
    assert (len(first), first[1]) == (1000, "s1 rel (5, 0, 0)")
    assert places_in_rows("s1", 2, 2, 5.0)[1:3] == ("s1 rel (5, 0, 0)", "s1 rel (0, -5, 0)")
    for columns, rows in ((0, 10**12), (10**12, 0), (-2, -3)):
        assert places_in_rows("s1", columns, rows, 5.0) == ()


def test_a_part_that_is_left_in_the_air_is_a_warning_with_what_is_below() -> None:
    state = WorldState.of(*CELL.facts, "free(cloud)", "free(stool)")
    _, there, back = base().check_all(["grip s1", "release cloud", "grip cloud"], state)
    assert (there.ok, [one.code for one in there.warnings], back.warnings) == (True, ["P158"], ())
    (finding,) = there.warnings
    assert finding.message == (
        "`bolt` would lie in the air at `cloud`, 12.3 mm above `table`; parts stand on what they touch"
    )
    assert finding.hint == "set it down lower, or put what carries it into the cell file"
    stacked = base().check_all(["grip s1", "release stool", "grip s2", "release cloud"], state)
    assert [one.warnings for one in stacked] == [()] * 4
    queue = WorldState.of(*QUEUE, "free(cloud)")
    assert len(base().check("load_pallet feed, cloud, 3, 1, 75", queue).warnings) == 1
    assert base().check("load_pallet feed, s1, 2, 1, 75", queue).warnings == ()


def test_a_tool_without_a_gripper_is_told_and_counts_no_more_once_it_is_changed() -> None:
    racks = ("home_of(glue, r1)", "home_of(jaws, r2)", "without_gripper(glue)", "tool(glue)")
    state = WorldState.of(*racks, *CELL.facts)
    bare, change, taken, glued = base().check_all(
        ["pick s1", "tool_change r1, r2", "pick s1", "release s3"], state
    )
    assert bare.message == "`pick` is not possible now: the tool `glue` has no gripper"
    assert bare.findings[0].hint == (
        "take a tool with a gripper first, or give the tool of the cell a `gripper`"
    )
    assert (bare.providers, [write_term(one) for one in bare.fails]) == ((), ["fails(pre,gripper(open))"])
    assert [change.ok, taken.ok, glued.ok] == [True] * 3
    assert base().plan(["at(bolt, s3)"], state).calls[0].name == "tool_change"
    none = base().check("pick s1", WorldState.of("at(bolt, s1)"))
    assert none.message == "`pick` is not possible now: no gripper is known"


@pytest.mark.parametrize(
    ("call", "message", "hint"),
    [
        ("pick fed", "Location not defined: `fed`", "did you mean `feed`?"),
        ("pick nowhere", "Location not defined: `nowhere`", "there is only `feed`"),
    ],
)
def test_a_location_that_nobody_knows_is_told_with_a_near_name(call: str, message: str, hint: str) -> None:
    report = base().check(call, WorldState.of(*QUEUE))
    assert [(one.message, one.hint) for one in report.findings] == [(message, hint)]
    assert report.providers == ()


def test_where_no_location_is_stated_a_call_lacks_what_lies_there() -> None:
    report = base().check("pick fed", WorldState.of("at(b0, feed)", "gripper(open)"))
    assert "a part at `fed` is needed" in report.message


@pytest.mark.parametrize(
    ("call", "words", "hint"),
    [
        ("tool_change s1, s3", "a tool that has its rack at `s3` is needed", "`home_of(welder, s3).`"),
        ("load_machine s1", "a machine with its chuck at `s1` is needed", "`chuck_of(lathe, s1).`"),
    ],
)
def test_what_the_knowledge_base_has_to_say_of_places_is_told_in_words(
    call: str, words: str, hint: str
) -> None:
    report = base().check(
        call, WorldState.of("tool(jaws)", "gripper(closed)", "held(b0)", "home_of(jaws, s1)")
    )
    assert words in report.message
    assert any(hint in one.hint for one in report.findings)


def test_conditions_of_others_are_told_in_words() -> None:
    both = Struct(";", (Struct("\\+", (Struct("held", (Var("P"),)),)), Struct("free", (Atom("s1"),))))
    assert fact_words(both) == "a state without a part in the gripper or an empty place `s1`"
    assert fact_words(Struct("\\=", (Atom("jaws"), Var("New")))) == "something else than `jaws`"
