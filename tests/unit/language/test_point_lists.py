"""Lists of points in programs: elements, loops, motions along them, and the work of a changed list."""

from dataclasses import replace

import pytest

from ropsim import icr
from ropsim.flow import MotionKind, MoveInstruction
from ropsim.language import Environment, LineCache, PointTable, compile, formatted
from ropsim.spatial import Pose
from support.tasks import CELL, codes, compiled, only
from support.work import calls_of

DOWN = (0.0, 1.0, 0.0, 0.0)
HEAD = "program t\nunits mm, deg, s\n"


def table(count: int, rise: float = 0.0) -> PointTable:
    """Return points 10 mm apart along x, each one higher than the one before by `rise` [m]."""
    points = tuple((0.3 + 0.01 * k, 0.1, 0.2 + rise * k, *DOWN) for k in range(count))
    return PointTable(points, {"first": 1, "third": 3}, "points/seam.csv", tuple(range(3, 3 + count)))


def with_lists(**lists: PointTable) -> Environment:
    return replace(CELL, lists=lists)


SEAM = with_lists(seam=table(5))


def moves(text: str, environment: Environment = SEAM) -> tuple[MoveInstruction, ...]:
    found = compile(HEAD + text, environment, "t.task")
    assert not found.diagnostics, [str(one) for one in found.diagnostics]
    assert found.icr is not None
    assert icr.verify(found.icr) == ()
    return icr.run_verified(found.icr).moves


def places(found: tuple[MoveInstruction, ...]) -> list[tuple[float, ...]]:
    """Return the targets in mm, rounded to a micrometre."""
    targets = [one.target for one in found if isinstance(one.target, Pose)]
    return [tuple(round(1000.0 * c, 3) for c in one.position.tolist()) for one in targets]


def test_a_chain_goes_through_all_points_in_their_order() -> None:
    found = moves("lin along seam blend 2 speed 300")
    assert [one.kind for one in found] == [MotionKind.LIN] * 5
    assert places(found) == [(300.0 + 10 * k, 100.0, 200.0) for k in range(5)]
    assert {one.modal.zone for one in found} == {0.002}


def test_a_chain_is_that_of_its_points_written_one_by_one() -> None:
    written = ", ".join(f"({300 + 10 * k}, 100, 200)" for k in range(4))
    settings = "fine speed 200 acc 2 m/s2"
    one = moves(f"lin along seam {settings}")
    other = moves(f"lin via {written} to (340, 100, 200) {settings}")
    assert places(one) == places(other)
    assert [a.modal for a in one] == [b.modal for b in other]


@pytest.mark.parametrize("count", [1, 2, 3])
def test_a_chain_of_few_points_has_its_triggers_at_its_two_ends(count: int) -> None:
    environment = replace(with_lists(seam=table(count)), signals=SEAM.signals)
    text = f"{HEAD}signal glue = output 1\n"
    text += "lin along seam at 3 after start do set glue on at 4 before end do set glue off\n"
    program = compile(text, environment, "t.task").icr
    assert program is not None
    found = icr.run_verified(program).moves
    assert len(found) == count
    assert [len(one.triggers) for one in (found[0], found[-1])] == ([2, 2] if count == 1 else [1, 1])
    assert sum(len(one.triggers) for one in found) == 2


def test_a_curve_leads_through_all_points() -> None:
    (found,) = moves("spline along seam speed 100")
    assert found.kind == MotionKind.SPLINE
    assert len(found.via) == 4
    assert places((found,)) == [(340.0, 100.0, 200.0)]


def test_a_list_is_read_in_the_frame_in_force() -> None:
    inside = "with frame pallet\n  lin along seam\n  spline along seam\n  lin seam[2]\nendwith\n"
    behind = "lin along seam in pallet\nspline along seam in pallet\nlin seam[2] in pallet\n"
    assert places(moves(inside)) == places(moves(behind))
    assert places(moves(behind))[0] == (700.0, -200.0, 200.0)


def test_all_points_are_moved_alike() -> None:
    above = moves("lin along seam above 10\nspline along seam above 10")
    assert {place[2] for place in places(above)} == {210.0}
    assert places(moves("lin along seam offset (1, 2, 3)"))[0] == (301.0, 102.0, 203.0)
    assert places(moves("lin along seam rel (0, 0, 5)"))[0] == (300.0, 100.0, 195.0)


def test_where_a_list_lies_is_computed_once() -> None:
    text = "lin infeed\nq = infeed\nlin along seam rel (0, 0, q.z) speed 100"
    assert places(moves(text))[1:] == [(300.0 + 10 * k, 100.0, 100.0) for k in range(5)]


def test_points_are_counted_from_one_and_have_names() -> None:
    text = 'mov seam[1]\nlin seam["third"]\nn = 2\nlin seam[n + 2]\nloc p = seam[5]\nlin p'
    assert [place[0] for place in places(moves(text))] == [300.0, 320.0, 330.0, 340.0]


def test_a_loop_takes_all_points_and_can_be_left() -> None:
    inside = "  n = n + 1\n  if n = 2 then continue\n  if n > 3 then break\n  lin p above 5\n"
    text = f"n = 0\nfor each p in seam\n{inside}endf"
    assert [place[0] for place in places(moves(text))] == [300.0, 320.0]


def test_a_task_takes_points_of_a_list() -> None:
    text = "task Visit(q: loc)\n  lin q above 10\nendp\nfor each p in seam\n  Visit p\nendf\nVisit seam[1]"
    assert len(moves(text)) == 6


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("lin along sem", "N226"),
        ("lin along infeed", "N226"),
        ("lin seam[0]", "T306"),
        ("lin seam[6]", "T306"),
        ('lin seam["second"]', "N227"),
        ("lin seam", "T301"),
        ("q = seam", "T301"),
        ("seam = infeed", "N207"),
        ("lin infeed[1]", "L109"),
        ("lin along (1, 2, 3)", "N209"),
        ("lin along seam[1]", "L101"),
        ("lin along seam until part_ok", "T301"),
        ("for each p in sem", "N213"),
        ("frame seam = (0, 0, 0)", "N223"),
    ],
)
def test_wrong_lines_have_a_finding_each(line: str, code: str) -> None:
    rest = "\nendf" if line.startswith("for") else ""
    assert codes(f"{HEAD}mov infeed\n{line}{rest}\n", SEAM)[:1] == [code]


def test_a_misspelt_list_and_a_misspelt_point_have_the_near_name() -> None:
    assert "did you mean `seam`?" in only(f"{HEAD}lin along seem\n", SEAM).hint
    assert "did you mean `first`?" in only(f'{HEAD}lin seam["frist"]\n', SEAM).hint


def test_a_curve_does_not_pass_a_point_twice_in_turn() -> None:
    twice = table(4)
    twice = replace(twice, points=(*twice.points[:2], twice.points[1], *twice.points[2:3]))
    found = only(f"{HEAD}spline along seam\n", with_lists(seam=twice))
    assert found.code == "T393"
    assert found.message == "the points 2 and 3 of `seam` are at one place"
    assert "lines 4 and 5 of `points/seam.csv`" in found.hint


def test_a_chain_stops_where_two_points_are_one() -> None:
    one = table(4)
    listed = replace(one, points=tuple(place for place in one.points for _ in range(2)), places=())
    found = only(f"{HEAD}lin along seam\n", with_lists(seam=listed))
    assert (found.code, found.hint) == ("T344", "leave one of them out of the list")
    assert found.message == "the points 1 and 2 of `seam` are at one place, and so are 3 further pairs"
    turned = (one.points[0], (*one.points[0][:3], 0.0, 0.0, 1.0, 0.0), *one.points[1:])
    assert codes(f"{HEAD}lin along seam\n", with_lists(seam=replace(one, points=turned))) == []


def test_a_list_whose_text_is_wrong_has_one_finding() -> None:
    text = (
        f"{HEAD}mov seam[1]\nlin along seam\nspline along seam\nfor each p in seam\n  lin p\nendf\nlin seam\n"
    )
    found = only(text, with_lists(seam=PointTable((), source="points/seam.csv")))
    assert found.code == "N226"
    assert found.message == "the list of points `seam` cannot be used: its text is wrong"
    assert found.hint == "mend `points/seam.csv`"
    assert len(found.secondary) == 4


def test_a_curve_needs_two_points() -> None:
    assert codes(f"{HEAD}spline along seam\n", with_lists(seam=table(1))) == ["T306"]


def test_a_location_may_still_be_named_along() -> None:
    text = "loc along = (300, 0, 100)\nlin along speed 100\nlin along\nlin along above 5"
    assert len(moves(text)) == 3


def test_the_form_keeps_lists_as_they_are_written() -> None:
    text = f'{HEAD}lin along seam in pallet above 5 speed 100\nlin seam[1] fine\nlin seam["third"]\n'
    assert formatted(text.replace(" in pallet", "   in   pallet").replace("[1]", "[ 1 ]")) == text


def test_code_is_small_whatever_the_length_of_a_list() -> None:
    text = f"{HEAD}lin along seam\nspline along seam\nfor each p in seam\n  lin p\nendf\n"
    sizes = []
    for count in (10, 10_000):
        program = compile(text, with_lists(seam=table(count))).icr
        assert program is not None
        assert [len(one.poses) for one in program.lists] == [count]
        sizes.append(sum(len(one.code) for one in program.procedures))
    assert sizes[0] == sizes[1]


def test_a_program_has_only_lists_that_it_uses() -> None:
    program = compile(f"{HEAD}lin along seam\n", with_lists(seam=table(3), other=table(4))).icr
    assert program is not None
    assert [one.name for one in program.lists] == ["seam"]


def test_a_changed_list_gives_what_a_new_compiler_gives() -> None:
    text = f"{HEAD}loc corner = seam[2]\nlin corner\nlin along seam\nlin other[1]\n"
    cache = LineCache()
    first = with_lists(seam=table(5), other=table(3))
    second = replace(first, lists={**first.lists, "seam": table(4, rise=0.01)})
    third = replace(first, lists={"other": first.lists["other"]})
    for environment in (first, second, third, first):
        found = compile(text, environment, "t.task", cache)
        alone = compile(text, environment, "t.task")
        assert found.diagnostics == alone.diagnostics
        assert found.icr == alone.icr


def test_a_changed_list_computes_only_what_reads_it() -> None:
    units = "".join(
        f"task T{k}(q: loc)\n  lin q above {k}\n  lin q above {k} + 1\nendp\n" for k in range(200)
    )
    calls = "".join(f"T{k} infeed\n" for k in range(200))
    text = f"{HEAD}{units}{calls}lin along seam\n"
    cache = LineCache()
    whole = calls_of(lambda: compile(text, with_lists(seam=table(5)), "t.task", cache))
    changed = with_lists(seam=table(6))
    changed = replace(
        changed, **{name: getattr(CELL, name) for name in ("frames", "tools", "locations", "signals")}
    )
    part = calls_of(lambda: compile(text, changed, "t.task", cache))
    assert part < whole / 4


def test_names_of_parameters_do_not_hide_lists() -> None:
    text = f"{HEAD}task Visit(seam: loc)\n  lin seam\nendp\nVisit infeed\n"
    assert compiled(text, SEAM).diagnostics[0].code == "N223"


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("lin along seam blend 0", True),
        ("mov along seam blend 0 mm speed 20 %", True),
        ("lin via (300, 100, 200), (310, 100, 200) to (320, 100, 200) blend 0", True),
        ("lin along seam blend 1", False),
        ("lin along seam fine", False),
        ("lin along seam", False),
        ("spline along seam blend 0", False),
        ("lin (300, 100, 200) blend 0", False),
    ],
)
def test_a_zone_of_nothing_on_a_way_through_points_is_told_not_to_stop_there(line: str, told: bool) -> None:
    found = [one for one in compile(HEAD + line, SEAM, "t.task").diagnostics if one.code == "T345"]
    assert len(found) == told
    for one in found:
        assert not one.is_error
        assert one.span is not None
        assert line[one.span.column - 1 :].startswith("blend 0")
        assert "to stop at each point" in one.hint
    if "along" in line and told:
        assert f"`for each p in seam` and `{line[:3]} p`" in found[0].hint


def test_a_point_in_a_variable_keeps_its_number_through_shifts_and_frames() -> None:
    lines = ("for each p in seam", "  q = p above 10", "  lin q", "  lin p in pallet", "endf")
    found = moves("\n".join(lines))
    assert [(one.origin.point.number if one.origin.point else 0) for one in found] == [
        k for k in range(1, 6) for _ in range(2)
    ]
    assert {one.origin.point.line for one in found if one.origin.point} == {3, 4, 5, 6, 7}
    assert {one.origin.point.source for one in found if one.origin.point} == {"points/seam.csv"}
