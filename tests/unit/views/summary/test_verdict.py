"""How far a run can be relied on, in one word."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.core import Category, Diagnostic, Severity, Span
from ropsim.views import Verdict, summarize, verdict
from support.recordings import facts, pick_and_place, station

STOPPED = Diagnostic("S761", "run-stopped", Severity.HINT, "ended at 1 s", category=Category.STOPPED)
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
        ((9, 9), "failed: collision on line 9: jaws – box 1, 2.0 mm deep; 2 errors, 1 warning"),
        ((9, 17, 9), "failed: collision on lines 9 and 17: jaws – box 2, 3.0 mm deep; 3 errors, 1 warning"),
        (
            (1, 2, 3, 4),
            "failed: collision on lines 1, 2, 3 and 4: jaws – box 3, 4.0 mm deep; 4 errors, 1 warning",
        ),
        ((1, 2, 3, 4, 5), "failed: collision on 5 lines: jaws – box 4, 5.0 mm deep; 5 errors, 1 warning"),
    ],
)
def test_a_collision_fails_the_run_and_the_deepest_one_is_named_first(
    lines: tuple[int, ...], said: str
) -> None:
    met = [
        Diagnostic(
            "S751",
            "penetration",
            Severity.ERROR,
            f"{k}",
            span=Span.whole_line("main.task", line),
            data={"bodies": f"jaws – box {k}", "distance_m": -1e-3 * (k + 1)},
            category=Category.COLLISION,
        )
        for k, line in enumerate(lines)
    ]
    found = verdict(summarize(pick_and_place(1, findings=(WARNED, *met))))
    assert found.text == said
    assert (found.kind is Verdict.FAILED) == bool(lines)
    failed = verdict(summarize(pick_and_place(1, findings=(WRONG, *met)))).text
    assert ("collision" in failed) == bool(lines)


@pytest.mark.parametrize(
    ("margins", "said"),
    [
        ({}, "ran to the end, no errors, no warnings"),
        ({1: 0.5}, "ran to the end, but joint 2 comes within 0.5° of the end of its range"),
        ({1: -0.5}, "ran to the end, but joint 2 is 0.5° beyond the end of its range"),
        (
            {0: 0.9, 1: 0.5, 2: 0.7},
            "ran to the end, but joint 2 comes within 0.5° of the end of its range, 2 more within 1° or 1 mm",
        ),
    ],
)
def test_joints_near_the_ends_of_their_ranges_make_a_run_doubtful(
    margins: dict[int, float], said: str
) -> None:
    recording = pick_and_place(1)
    q = recording.channels["q"].values
    axes = tuple(
        replace(
            one,
            lower=float(q[:, k].min()) - 1.0,
            upper=float(q[:, k].max()) + np.radians(margins.get(k, 60.0)),
        )
        for k, one in enumerate(station().axes)
    )
    found = verdict(summarize(replace(recording, facts=facts(stations=(station(axes=axes),)))))
    assert found.text == said
    assert found.kind is (Verdict.DOUBTFUL if margins else Verdict.GOOD)
