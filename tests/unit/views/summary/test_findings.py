from ropsim.core import Diagnostic, Severity, Span
from ropsim.views import count_text, group_findings
from ropsim.views.testing import runs_text
from support.recordings import two_findings

PLACE = Span("a.task", 3, 1, 3, 4)


def finding(message: str, **data: object) -> Diagnostic:
    return Diagnostic("N201", "unknown-name", Severity.ERROR, message, PLACE, data=data)


def test_passes_of_one_place_are_one_group() -> None:
    warning, errors = group_findings(two_findings())
    assert (warning.count, warning.passes) == (1, ())
    assert (errors.count, errors.passes) == (3, (1, 2, 3))
    assert "171.4" in errors.first.message


def test_different_mistakes_at_one_place_stay_apart() -> None:
    assert len(group_findings([finding("`a` unknown"), finding("`b` unknown"), finding("`a` unknown")])) == 2


def test_different_joints_at_one_place_stay_apart() -> None:
    groups = group_findings([finding("x", joint=1, **{"pass": 1}), finding("y", joint=2, **{"pass": 1})])
    assert len(groups) == 2


def test_runs_of_passes_are_joined() -> None:
    assert runs_text("pass", (1, 2, 3, 7)) == "passes 1-3, 7"
    assert runs_text("pass", (4,)) == "pass 4"


def test_long_lists_of_passes_are_cut() -> None:
    assert runs_text("pass", tuple(range(1, 99, 2)), limit=3) == "passes 1, 3, 5, …"


def test_counts_are_told_by_severity() -> None:
    assert count_text(two_findings()) == "3 errors, 1 warning"
    assert count_text(()) == "no findings"
