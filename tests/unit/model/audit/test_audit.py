from dataclasses import replace
from typing import Any

import numpy as np

from ropsim import robots
from ropsim.core import Diagnostic, Severity
from ropsim.model import RobotModel, audit

ARM = robots.load("two_link")


def codes(robot: RobotModel) -> list[str]:
    """Return the codes of all findings but hints."""
    return [finding.code for finding in audit(robot) if finding.severity is not Severity.HINT]


def with_link(**changes: Any) -> RobotModel:
    return replace(ARM, links=(replace(ARM.links[0], **changes), ARM.links[1]))


def find(robot: RobotModel, code: str) -> Diagnostic:
    (finding,) = [finding for finding in audit(robot) if finding.code == code]
    return finding


def test_built_in_robots_have_no_errors() -> None:
    for name in robots.names():
        assert not [finding for finding in audit(robots.load(name)) if finding.is_error]


def test_published_oddities_of_the_puma_are_warnings_only() -> None:
    findings = [finding for finding in audit(robots.load("puma560")) if finding.severity is Severity.WARNING]
    assert [(finding.code, finding.message.split("`")[1]) for finding in findings] == [
        ("X853", "1"),
        ("X854", "3"),
    ]


def test_estimates_are_hints_with_their_reason() -> None:
    findings = audit(robots.load("puma560"))
    (finding,) = [finding for finding in findings if "motor constants" in finding.message]
    assert (finding.code, finding.severity) == ("X855", Severity.HINT)
    assert len(finding.notes) == sum(one.kind == "estimated" for one in robots.load("puma560").origins)
    assert any("back-EMF" in note for note in finding.notes)


def test_a_massless_link_is_a_hint() -> None:
    assert find(with_link(mass=0.0), "X852").severity is Severity.HINT


def test_a_point_mass_is_no_finding() -> None:
    assert codes(ARM) == []


def test_a_moment_of_inertia_that_is_zero_or_effective_is_a_warning() -> None:
    assert codes(with_link(inertia=np.diag([0.0, 1.0, 0.0]))) == ["X853"]
    assert codes(with_link(mass=0.0, inertia=np.diag([1.0, 1.0, -0.1]))) == ["X853"]
    assert codes(with_link(inertia=np.diag([1.0, 1.0, -1e-4]))) == ["X853"]


def test_the_triangle_inequality_may_hold_with_equality() -> None:
    assert codes(with_link(inertia=np.diag([1.0, 2.0, 3.0]))) == []
    assert codes(with_link(inertia=np.diag([1.0, 2.0, 3.001]))) == ["X854"]


def test_a_home_position_outside_the_limits_names_joint_and_limit() -> None:
    finding = find(replace(ARM, home=np.array([0.0, 4.0])), "X857")
    assert "joint `2` at 4 rad" in finding.message
    assert "-3.142 to 3.142 rad" in finding.message


def test_a_home_position_of_another_length_is_an_error() -> None:
    assert codes(replace(ARM, home=np.zeros(3))) == ["X857"]


def test_missing_links_and_drives_are_errors() -> None:
    puma = robots.load("puma560")
    assert "X858" in codes(replace(puma, links=puma.links[:5]))
    assert "X858" in codes(replace(puma, drives=puma.drives[:5]))
