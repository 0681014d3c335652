"""Texts of a knowledge base: each clause alone, every mistake at its place, all else keeps working."""

from pathlib import Path

import pytest

from ropsim.prolog import Atom, Struct, Var
from ropsim.tasks import KnowledgeBase, TaskError, read_folder
from support.knowledge import base, last

OWN_GRIP = "task(grip(P, L), [params([P-part, L-location]), body([mov(L), close])])."
OPEN_FACT = """\
:- module(kb_a, []).
part(bolt).
task(a(P), [params([P-part]), pre([\\+ held(P), clear(P)])]).
clear(_)."""
GOOD = "task(good(L), [params([L-location]), body([mov(L)])]).\n"


def found(text: str) -> list[tuple[str, int, str]]:
    """Return code, line and marked characters of each finding of a text."""
    result = []
    lines = text.splitlines()
    for one in base(text).findings:
        assert one.span is not None
        assert one.span.source == "kb/t0.pl"
        end = one.span.end_column - 1 if one.span.end_line == one.span.line else None
        result.append((one.code, one.span.line, lines[one.span.line - 1][one.span.column - 1 : end]))
    return result


@pytest.mark.parametrize(
    ("clause", "expected"),
    [
        ("task(a, b).", ("P130", 1, "b")),
        ("task(a).", ("P130", 1, "task(a)")),
        ("task(3, []).", ("P130", 1, "3")),
        ("task(a(_X, f), [params([_X-part])]).", ("P130", 1, "a(_X, f)")),
        ('task(a, [docc("x")]).', ("P130", 1, 'docc("x")')),
        ("task(a, [doc([])]).", ("P130", 1, "doc([])")),
        ("task(a, [pre([]), pre([])]).", ("P130", 1, "pre([])")),
        ("task(a(P), [params([P-part]), eff([held(P)])]).", ("P130", 1, "held(P)")),
        ("task(a(_L), []).", ("P131", 1, "a(_L)")),
        ("task(a(L), [params([L-location, _M-part])]).", ("P131", 1, "_M-part")),
        ("task(a(L), [params([L-locaton])]).", ("P132", 1, "L-locaton")),
        ("task(a(L), [params([L-location]), body([call(gip(L))])]).", ("P133", 1, "call(gip(L))")),
        ("task(a(L), [params([L-location]), body([call(a(L))])]).", ("P133", 1, "call(a(L))")),
        ("task(a(L), [params([L-location]), body([call(grip(L, L))])]).", ("P134", 1, "call(grip(L, L))")),
        ("task(mov(L), [params([L-location])]).", ("P135", 1, "mov(L)")),
        (GOOD + "task(good, []).", ("P135", 2, "good")),
        ("task(a(P), [params([P-part]), eff([+hold(P)])]).", ("P136", 1, "+hold(P)")),
        ("task(a(P), [params([P-part]), pre([helt(P)])]).", ("P137", 1, "helt(P)")),
        ("task(a, [body([opn])]).", ("P138", 1, "opn")),
        ("task(a, [body([repeat(2, [open, clos])])]).", ("P138", 1, "clos")),
        ("task(a, [body([shell(id)])]).", ("P138", 1, "shell(id)")),
        ("x --> y.", ("P139", 1, "x --> y")),
        ("part(_).", ("P139", 1, "part(_)")),
        (":- dynamic part/1.", ("P139", 1, ":- dynamic part/1")),
        ("task(a, [eff([-held(_P)])]).", ("P140", 1, "-held(_P)")),
        ("task(a(L), [params([L-location]), geo([near(L)])]).", ("P141", 1, "near(L)")),
        ("task(a(L), [params([L-location]), geo([reachable(f(1), L)])]).", ("P141", 1, "reachable(f(1), L)")),
        ("task(a, [geo([reachable(arm, 3)])]).", ("P141", 1, "reachable(arm, 3)")),
        (
            "task(a(L, N, D), [params([L-location, N-int, D-length]), "
            "geo([in_rows(in_rows(reachable(arm, L), N, N, D), N, N, D)])]).",
            ("P141", 1, "in_rows(in_rows(reachable(arm, L), N, N, D), N, N, D)"),
        ),
        (f"part({'f(' * 70}a{')' * 70}).", ("P142", 1, f"part({'f(' * 70}a{')' * 70})")),
        (OWN_GRIP, ("P146", 1, "grip(P, L)")),
        ("part(bolt nut).", ("P101", 1, " ")),
        ("task(a(L), [params([L-location])]).", None),
        ("clear(L) :- location(L), \\+ at(_, L).", None),
        (OPEN_FACT, ("P139", 4, "clear(_)")),
    ],
)  # fmt: skip
def test_a_mistake_is_found_at_its_place_and_the_task_behind_it_is_there(
    clause: str, expected: tuple[str, int, str] | None
) -> None:
    text = f"{clause}\ntask(behind(L), [params([L-location]), body([lin(L)])]).\n"
    codes = found(text)
    assert expected in [*codes, None]
    assert [one for one in codes if one[0] not in ("P103", "P137")] in ([], [expected])
    assert "behind" in last().names


def test_a_condition_of_geometry_in_a_wrong_form_is_not_told_to_be_unknown() -> None:
    head = "task(a(L, N, D), [params([L-location, N-int, D-length]), geo(["
    for wrong in ("in_rows(reachable(arm, L), N, 2, D)", "in_rows(reachable(arm, L), N)", "reachable(L)"):
        (finding, *_) = base(f"{head}{wrong}])]).").findings
        assert "is not of its form here" in finding.message
        assert finding.hint is not None
        assert "`in_rows(reachable(arm, L), N, M, D)`" in finding.hint
    (finding, *_) = base(f"{head}near(L)])]).").findings
    assert finding.message == "`near/1` is no condition of geometry"


def test_a_task_is_a_record_with_the_names_of_its_text() -> None:
    text = """\
task(fit(P, L, D), [
  doc("fits a part"),
  params([P-part, L-location, D-length = 5*mm]),
  pre([held(P)]), eff([-held(P), +at(P, L)]), geo([reachable(arm, L)]),
  body([lin(above(L, D)), call(release(L))])]).
"""
    task = base(text).task("fit")
    assert task is not None
    P, L, D = Var("P"), Var("L"), Var("D")
    assert str(task) == "fit(P: part, L: location, D: length)"
    assert [one.name for one in task.passed] == ["L", "D"]
    assert task.parameters[2].default == Struct("*", (5, Atom("mm")))
    assert (task.doc, task.needs) == ("fits a part", (Struct("held", (P,)),))
    assert (task.adds, task.removes) == ((Struct("at", (P, L)),), (Struct("held", (P,)),))
    assert task.geometry == (Struct("reachable", (Atom("arm"), L)),)
    assert task.body[0] == Struct("lin", (Struct("above", (L, D)),))
    assert task.called == {"release"}
    assert (task.span.source, task.span.line, task.span.end_line, task.is_built_in) == (
        "kb/t0.pl",
        1,
        5,
        False,
    )


def test_a_task_of_a_project_takes_the_place_of_that_of_the_library() -> None:
    task = base("task(park, [body([open])]).").task("park")
    assert task is not None
    assert (task.is_built_in, task.parameters) == (False, ())
    again = base().task("park")
    assert again is not None
    assert again.is_built_in


def test_a_folder_is_read_in_the_order_of_its_manifest(tmp_path: Path) -> None:
    folder = tmp_path / "kb"
    folder.mkdir()
    for name in ("a", "b", "c"):
        (folder / f"{name}.pl").write_text(GOOD.replace("good", name))
    (folder / "manifest.toml").write_text('order = ["c.pl", "d.pl"]\ntrust = true\n')
    texts, findings = read_folder(tmp_path)
    assert [one.name for one in texts] == [f"{folder.as_posix()}/{name}.pl" for name in "cab"]
    assert [one.code for one in findings] == ["P143", "P143"]
    assert read_folder(folder)[0] == texts
    assert read_folder(folder / "a.pl")[0] == texts[1:2]
    (folder / "manifest.toml").write_text("order = [1")
    assert [one.code for one in read_folder(tmp_path)[1]] == ["P143"]


def test_what_is_no_text_is_a_finding_and_no_folder_an_error(tmp_path: Path) -> None:
    (tmp_path / "kb").mkdir()
    (tmp_path / "kb" / "a.pl").write_bytes(b"part(\xff).")
    texts, findings = read_folder(tmp_path)
    assert (texts, [one.code for one in findings]) == ((), ["P144"])
    (tmp_path / "notes.txt").write_text("part(bolt).")
    for name in ("none", "notes.txt"):
        with pytest.raises(TaskError, match="P144"):
            KnowledgeBase.open(tmp_path / name)


def test_a_link_out_of_the_folder_is_not_followed(tmp_path: Path) -> None:
    (tmp_path / "kb").mkdir()
    (tmp_path / "outside.pl").write_text("part(bolt).")
    (tmp_path / "kb" / "a.pl").symlink_to(tmp_path / "outside.pl")
    (tmp_path / "kb" / "b.pl").write_text("part(nut).")
    texts, findings = read_folder(tmp_path)
    assert [Path(one.name).name for one in texts] == ["b.pl"]
    assert [one.code for one in findings] == ["U962"]
