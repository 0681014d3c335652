"""The verdict on a run in one sentence."""

from enum import Enum

from ropsim.core import frozen_dataclass, plural
from ropsim.views.summary import Summary


class Verdict(Enum):
    """How far a run can be relied on."""

    GOOD = "good"
    DOUBTFUL = "doubtful"
    FAILED = "failed"


@frozen_dataclass
class VerdictText:
    """A verdict and the sentence that gives its reasons."""

    kind: Verdict
    text: str


def verdict(summary: Summary) -> VerdictText:
    """Return the verdict.

    Failed with errors, skipped moves or broken samples; doubtful with warnings or when ended by hand.
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
    failed = bool(reasons)
    if summary.warning_count:
        reasons.append(plural(summary.warning_count, "warning"))
    if failed:
        return VerdictText(Verdict.FAILED, "failed: " + ", ".join(reasons))
    end = "ended by hand before the program ended" if summary.stopped_by_hand else "ran to the end"
    if reasons:
        return VerdictText(Verdict.DOUBTFUL, f"{end} with " + ", ".join(reasons))
    kind = Verdict.DOUBTFUL if summary.stopped_by_hand else Verdict.GOOD
    return VerdictText(kind, f"{end}, no errors, no warnings")
