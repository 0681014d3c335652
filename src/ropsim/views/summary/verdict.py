"""The verdict on a run in one sentence."""

from enum import Enum

from ropsim.core import Category, frozen_dataclass, plural
from ropsim.views.summary.joint_summary import Closeness, closest_to_position_limit
from ropsim.views.summary.summary import Summary
from ropsim.views.words.characters import clean
from ropsim.views.words.figures import coordinate_scale, with_unit

NAMED = 4
"""Lines with collisions are named up to this number, else counted."""


class Verdict(Enum):
    """How far a run can be relied on."""

    GOOD = "good"
    DOUBTFUL = "doubtful"
    FAILED = "failed"


@frozen_dataclass
class VerdictText:
    """A verdict and the sentence with its reasons."""

    kind: Verdict
    text: str


def verdict(summary: Summary) -> VerdictText:
    """Return the verdict.

    Failed with errors, skipped moves or broken samples; doubtful with warnings, with a joint that is nearly
    at the end of its range, or when ended by hand.
    """
    reasons = []
    if summary.invalid_samples:
        reasons.append(f"{plural(summary.invalid_samples, 'sample')} not finite: the integration failed")
    if summary.skipped:
        reasons.append(
            f"{plural(len(summary.skipped), 'move')} skipped: the cycle time is not that of the program"
        )
    if summary.error_count:
        reasons.append(plural(summary.error_count, "error"))
    failed, collision = bool(reasons), _collision(summary)
    if summary.warning_count:
        reasons.append(plural(summary.warning_count, "warning"))
    if failed:
        first = f"{collision}; " if collision else ""
        return VerdictText(Verdict.FAILED, f"failed: {first}{', '.join(reasons)}")
    end = "ended by hand before the program ended" if summary.stopped_by_hand else "ran to the end"
    near = _near_end(summary)
    if reasons:
        also = f"; {near}" if near else ""
        return VerdictText(Verdict.DOUBTFUL, f"{end} with {', '.join(reasons)}{also}")
    if near:
        return VerdictText(Verdict.DOUBTFUL, f"{end}, but {near}")
    kind = Verdict.DOUBTFUL if summary.stopped_by_hand else Verdict.GOOD
    return VerdictText(kind, f"{end}, no errors, no warnings")


def _near_end(summary: Summary) -> str:
    """Return which joint is nearly at the end of its range or beyond it, in words; empty for none."""
    near = [one for one in summary.joints if one.margin_closeness is not Closeness.FAR]
    worst = closest_to_position_limit(near)
    if worst is None:
        return ""
    margin = with_unit(abs(worst.nearest.margin), coordinate_scale(worst.facts.type), 1)
    is_beyond = worst.margin_closeness is Closeness.BEYOND
    how = f"is {margin} beyond" if is_beyond else f"comes within {margin} of"
    more = f", {len(near) - 1} more within 1° or 1 mm" if len(near) > 1 else ""
    return f"{clean(worst.words)} {how} the end of its range{more}"


def _collision(summary: Summary) -> str:
    """Return lines, bodies and depth of the collisions of a run, the deepest one named; empty for none."""
    found = [one.first for one in summary.findings if one.first.category is Category.COLLISION]
    if not found:
        return ""
    deepest = min(found, key=lambda one: float(str(one.data["distance_m"])))
    bodies = f"{deepest.data['bodies']}, {-1e3 * float(str(deepest.data['distance_m'])):.1f} mm deep"
    lines = sorted({one.span.line for one in found if one.span})
    return f"collision{_on(lines)}: {bodies}"


def _on(lines: list[int]) -> str:
    if not lines:
        return ""
    if len(lines) > NAMED:
        return f" on {len(lines)} lines"
    *before, last = map(str, lines)
    return f" on lines {', '.join(before)} and {last}" if before else f" on line {last}"
