"""How far a run can be relied on, in one word."""

import pytest

from ropsim.core import Diagnostic, Severity
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
