"""How far a run can be relied on, in one word."""

import pytest

from ropsim.core import Diagnostic, Severity, Span
from ropsim.views import summarize, verdict
from ropsim.views.verdict import Verdict
from support.recordings import pick_and_place

STOPPED = Diagnostic("S761", "run-stopped", Severity.HINT, "ended at 1 s")
WARNED = Diagnostic("S731", "torque-saturated", Severity.WARNING, "joint `2` asks for 190 N·m of 186 N·m")
WRONG = Diagnostic("S738", "not-at-destination", Severity.ERROR, "`box` is not where it is to be")


@pytest.mark.parametrize(
    ("findings", "kind"),
    [
        ((), Verdict.GOOD),
        ((STOPPED,), Verdict.DOUBTFUL),
        ((WARNED,), Verdict.DOUBTFUL),
        ((STOPPED, WRONG), Verdict.FAILED),
    ],
)
def test_a_run_is_good_only_where_it_came_to_its_end_with_nothing_found(
    findings: tuple[Diagnostic, ...], kind: Verdict
) -> None:
    assert verdict(summarize(pick_and_place(1, findings=findings))).kind is kind


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        ((), "ran to the end with 1 warning"),
        ((9, 9), "ran to the end, but bodies met on line 9: 3 warnings"),
        ((9, 17, 9), "ran to the end, but bodies met on lines 9 and 17: 4 warnings"),
        ((1, 2, 3, 4), "ran to the end, but bodies met on lines 1, 2, 3 and 4: 5 warnings"),
        ((1, 2, 3, 4, 5), "ran to the end, but bodies met on 5 lines: 6 warnings"),
    ],
)
def test_lines_on_which_bodies_met_are_said_before_all_else(lines: tuple[int, ...], said: str) -> None:
    met = [
        Diagnostic("S751", "collision", Severity.WARNING, f"{k}", span=Span.whole_line("main.task", line))
        for k, line in enumerate(lines)
    ]
    assert verdict(summarize(pick_and_place(1, findings=(WARNED, *met)))).text == said
    failed = verdict(summarize(pick_and_place(1, findings=(WRONG, *met)))).text
    assert ("bodies met" in failed) == bool(lines)
