"""Whether a mechanism can be: its counts, the tree of its joints, its axes, couplings and loops."""

from collections.abc import Iterator
from functools import lru_cache

from ropsim.core import Diagnostic, RopsimError
from ropsim.model.findings import mechanism_diagnostics as kinds
from ropsim.model.findings.diagnostics import COUNT_MISMATCH, HOME_OUT_OF_RANGE
from ropsim.model.mechanism.coupling_check import coupling_findings
from ropsim.model.mechanism.loop_check import loop_findings
from ropsim.model.mechanism.mechanism import Mechanism
from ropsim.model.mechanism.spring_check import spring_findings
from ropsim.model.mechanism.tree_check import axis_findings, external_findings, name_findings, parent_findings


class MechanismError(RopsimError):
    """A mechanism cannot be."""


def check_mechanism(mechanism: Mechanism) -> None:
    """Make sure that the joints of a mechanism move its links in one way.

    Raises:
        MechanismError: with the first of its `tree_findings`.
    """
    found = tree_findings(mechanism)
    if found:
        raise MechanismError(found[0])


def check_counts(mechanism: Mechanism) -> None:
    """Make sure that a mechanism has a link for each joint, and drives, if any, for its axes.

    Raises:
        MechanismError: it has not, or `check_mechanism` has something against it.
    """
    found = mechanism_findings(mechanism)
    if found:
        raise MechanismError(found[0])


def check_open(mechanism: Mechanism) -> None:
    """Make sure that a mechanism can be moved by a controller: it has no closed chains that are cut.

    Raises:
        MechanismError: it has, or `check_mechanism` has something against it.
    """
    check_mechanism(mechanism)
    if mechanism.cuts:
        raise MechanismError(
            kinds.LOOP_NOT_SIMULATED.at(
                None,
                f"`{mechanism.name}` has {len(mechanism.cuts)} closed chains that are cut",
                hint="describe it by couplings where its coordinates are linear functions of the axes",
            )
        )


def mechanism_findings(mechanism: Mechanism) -> tuple[Diagnostic, ...]:
    """Return the contradictions of a mechanism: of its counts, and the result of `tree_findings`."""
    return (*_counts(mechanism), *tree_findings(mechanism))


@lru_cache(maxsize=256)
def tree_findings(mechanism: Mechanism) -> tuple[Diagnostic, ...]:
    """Return the errors in joints, axes, couplings, loops, springs; without errors kinematics is defined."""
    tree = (
        *name_findings(mechanism),
        *parent_findings(mechanism),
        *axis_findings(mechanism),
        *external_findings(mechanism),
    )
    return tree or (*coupling_findings(mechanism), *loop_findings(mechanism), *spring_findings(mechanism))


def _counts(mechanism: Mechanism) -> Iterator[Diagnostic]:
    joints, n = len(mechanism.joints), mechanism.n
    rows = (
        ("links", len(mechanism.links), joints, "joints"),
        ("drives", len(mechanism.drives) or n, n, "axes"),
    )
    for what, count, allowed, of in rows:
        if count != allowed:
            yield COUNT_MISMATCH.at(
                None,
                f"`{mechanism.name}` has {count} {what} for {allowed} {of}",
                hint=f"give one entry of {what} for each of the {of}",
                data={"found": count, "allowed": allowed},
            )
    if mechanism.home.shape != (n,):
        yield HOME_OUT_OF_RANGE.at(
            None,
            f"the home position has {mechanism.home.size} coordinates for {n} axes",
            hint="give one coordinate for each axis",
            data={"found": mechanism.home.size, "allowed": n},
        )
