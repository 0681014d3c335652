"""The body of a task is walked against its header: its effects, and what its steps need."""

import pytest

from ropsim.core import Severity
from ropsim.prolog import Term
from ropsim.tasks import effect_findings, own_tasks
from ropsim.tasks.testing import Believed, Held, Path, library_texts
from support.knowledge import base

HEAD = "task(fetch(P, L), [params([P-part, L-location]), pre([gripper(open), at(P, L)]),\n"
TAKES = "  eff([-gripper(open), +gripper(closed), -at(P, L), +held(P), +free(L)]),\n"
LEAVES = "task(leave(P, L), [params([P-part, L-location]), pre([gripper(closed), held(P), free(L)]),\n"
LEFT = "  eff([-gripper(closed), +gripper(open), -held(P), +at(P, L), -free(L)]),\n"
COUNTED = "task(t(P, L, N), [params([P-part, L-location, N-int]), pre([gripper(open), at(P, L)]),\n"
NAMED = "task(t(L), [params([L-location]), pre([gripper(open), at(_, L)]),\n"


def differing(text: str) -> list[tuple[str, int, str]]:
    """Return code, line and marked characters of each difference of a text."""
    known = base(text)
    lines = text.splitlines()
    found = []
    for one in effect_findings(known, own_tasks(known)):
        assert one.span is not None
        assert (one.severity, one.span.source) == (Severity.WARNING, "kb/t0.pl")
        assert one.hint
        mark = lines[one.span.line - 1][one.span.column - 1 : one.span.end_column - 1]
        found.append((one.code, one.span.line, mark))
    return found


@pytest.mark.parametrize(
    "text",
    [
        f"{HEAD}{TAKES}  body([mov(above(L, 5)), lin(L), close, lin(above(L, 5))])]).",
        f"{HEAD}{TAKES}  body([call(pick(L))])]).",
        f"{HEAD}{TAKES}  body([call(pick(L, clear = 5*mm))])]).",
        f"{HEAD}{TAKES}  body([if(x > 1, [lin(L), close], [mov(L), close])])]).",
        f"{HEAD}{TAKES}  body([mov(L), repeat(3, [wait(1)]), lin(L), close])]).",
        f"{HEAD}{TAKES}  body([with([speed(5*mm/s)], [lin(L), close])])]).",
        f"{HEAD}{TAKES}  body([lin(L), set(vacuum, on)])]).",
        f"{HEAD}{TAKES}  body([lin(L), close, if(lost, [stop])])]).",
        f"{HEAD}{TAKES}  body([load([x], L), mov(x), close])]).",
        f"{HEAD}  eff([+polished(P)]),\n  body([mov(L)])]).\ngoal(polished/1).",
        f"{HEAD}  eff([-at(P, L), +free(L)]),\n  body([lin(L), lin(p(1, 2, 3))])]).",
        f"{HEAD}  body([call(grip(L)), call(release(L))])]).",
        f"{HEAD}  body([mov(L), close, open])]).",
        f"{HEAD}{TAKES}  geo([])]).",
        f"{LEAVES}{LEFT}  body([mov(L), open])]).",
        f"{LEAVES}{LEFT}  body([call(place(L))])]).",
        f"{COUNTED}  body([repeat(N, [call(grip(L)), call(release(L))])])]).",
        "task(t(L, N), [params([L-location, N-int]), pre([gripper(open)]),\n"
        "  body([x := 1, repeat(N, [call(grip(p(x, 2, 3))), call(release(L)), x := x + 1])])]).",
        f"{NAMED}  body([call(grip(L)), call(release(L))])]).",
        "clear(L) :- \\+ at(_, L).\ntask(u(L), [params([L-location]), pre([clear(L)])]).\n"
        "task(t(L), [params([L-location]), body([call(u(L))])]).",
        "task(t, [body([wait(1), print([1])])]).",
    ],
)
def test_a_body_that_does_what_the_header_says_has_no_warning(text: str) -> None:
    assert differing(text) == []


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            f"{HEAD}{TAKES}  body([mov(L)])]).",
            [("P159", 2, "-gripper(open)"), ("P159", 2, "+gripper(closed)"), ("P159", 2, "+held(P)")],
        ),
        (f"{HEAD}  eff([-at(P, L), +held(P)]),\n  body([mov(L), close])]).", [("P160", 3, "close")]),
        (f"{HEAD}  body([mov(L), repeat(3, [wait(1)]), lin(L), close])]).", [("P160", 2, "close")]),
        (f"{LEAVES}{LEFT}  body([mov(L), close])]).", [("P159", 2, one) for one in (
            "-gripper(closed)", "+gripper(open)", "-held(P)", "+at(P, L)")]),
        (f"{LEAVES}  eff([-gripper(closed), +gripper(open), -held(P), -free(L)]),\n  body([mov(L), open])]).",
            [("P160", 3, "open")]),
        (f"{HEAD}{TAKES}  body([call(grip(L)), call(release(L))])]).", [("P159", 2, one) for one in (
            "-gripper(open)", "+gripper(closed)", "-at(P, L)", "+held(P)", "+free(L)")]),
        ("task(t(L), [params([L-location]), pre([gripper(open)]),\n  body([if(a > 1, [wait(1)], [\n"
            "    call(release(L))])])]).", [("P161", 3, "call(release(L))")]),
        (f"{HEAD}{TAKES}  body([call(grip(L)), call(grip(L))])]).", [("P161", 3, "call(grip(L))")]),
        ("task(t, [body([open])]).", [("P160", 1, "open")]),
        ("task(t(L), [params([L-location]), body([while(x < 1, [mov(L), stop, open]), open])]).",
            [("P160", 1, "open")]),
        ("task(t(P, L), [params([P-part, L-location]), pre([at(P, L)]), body([call(inspect(L))])]).",
            [("P160", 1, "call(inspect(L))")]),
    ],
)  # fmt: skip
def test_a_body_that_differs_from_the_header_is_a_warning_at_its_place(
    text: str, expected: list[tuple[str, int, str]]
) -> None:
    found = differing(text)
    assert [one for one in expected if one not in found] == []
    assert {one[0] for one in found} <= {"P159", "P160", "P161"}


def test_a_difference_says_what_was_found_and_what_to_write() -> None:
    known = base(f"{HEAD}  eff([-at(P, L), +held(P), +free(L)]),\n  body([mov(L), close])]).")
    (finding,) = effect_findings(known, own_tasks(known))
    missing = "`-gripper(open)`, `+gripper(closed)`"
    assert finding.message == f"the body of `fetch` leaves {missing} behind, and its effects do not say so"
    assert finding.hint == f"write {missing} in `eff`, or let the body undo it"
    known = base("task(t(L), [params([L-location]), body([call(grip(L))])]).")
    lack = effect_findings(known, own_tasks(known))[0]
    assert "calls `grip`, which needs `gripper(open)`, `at(_, L)`" in lack.message


def test_no_task_of_the_library_differs_from_its_body() -> None:
    known = base(*(one.text for one in library_texts()))
    assert len(own_tasks(known)) == len(known.names)
    assert effect_findings(known, own_tasks(known)) == ()


@pytest.mark.parametrize(
    "name", ["grip", "release", "pick", "place", "insert", "load_machine", "unload_machine"]
)
@pytest.mark.parametrize("effect", ["-gripper", "+gripper"])
def test_each_effect_on_the_gripper_is_missed_in_tasks_of_the_library(name: str, effect: str) -> None:
    (text,) = [one.text for one in library_texts() if f"task({name}(" in one.text]
    begin = text.index("eff([", text.index(f"task({name}("))
    place = text.index(effect, begin)
    end = text.index(")", place) + 1
    known = base(text[:place] + text[end:].lstrip(", "))
    found = effect_findings(known, own_tasks(known))
    assert [(one.code, one.message.split("`")[1]) for one in found] == [("P160", name)]


def test_a_walk_is_linear_in_the_body(monkeypatch: pytest.MonkeyPatch) -> None:
    counts: list[int] = []
    put = Believed.put

    def counted(self: Believed, fact: Term, value: Held, step: Path | None = None) -> None:
        counts.append(1)
        put(self, fact, value, step)

    monkeypatch.setattr(Believed, "put", counted)
    passes = []
    for length in (20, 40, 80):
        steps = ", ".join(["if(a > 1, [close], [call(pick(L)), call(place(L))])", "open"] * length)
        body = f"repeat(2, [repeat(2, [{steps}])])"
        known = base(f"task(t(L), [params([L-location]), pre([gripper(open)]), body([{body}])]).")
        counts.clear()
        effect_findings(known, own_tasks(known))
        passes.append(len(counts))
    assert 0 < passes[2] - passes[1] <= 2.1 * (passes[1] - passes[0])
