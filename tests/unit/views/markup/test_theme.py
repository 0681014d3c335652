import re

import pytest

from ropsim.views.testing import DARK, LIGHT, stylesheet

TEXT_CONTRAST = 4.5
"""WCAG 2.1, 1.4.3 (AA) for text."""

PICTURE_CONTRAST = 3.0
"""WCAG 2.1, 1.4.11 for graphical objects."""


def luminance(color: str) -> float:
    """Relative luminance of `#rrggbb` (WCAG 2.1)."""
    channels = [int(color[k : k + 2], 16) / 255.0 for k in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one: str, other: str) -> float:
    light, dark = sorted((luminance(one), luminance(other)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


def colors(scheme: str) -> dict[str, str]:
    return dict(re.findall(r"--(\w+): (#[0-9a-f]{6});", scheme))


@pytest.mark.parametrize("scheme", [LIGHT, DARK], ids=["light", "dark"])
@pytest.mark.parametrize("name", ["text", "quiet", "c1", "c2", "good", "doubt", "bad"])
def test_text_has_contrast(scheme: str, name: str) -> None:
    found = colors(scheme)
    assert contrast(found[name], found["sheet"]) >= TEXT_CONTRAST
    assert contrast(found[name], found["page"]) >= TEXT_CONTRAST


@pytest.mark.parametrize("scheme", [LIGHT, DARK], ids=["light", "dark"])
@pytest.mark.parametrize("name", ["c1", "c2", "limit", "bar"])
@pytest.mark.parametrize("ground", ["sheet", "band"])
def test_traces_have_contrast(scheme: str, name: str, ground: str) -> None:
    found = colors(scheme)
    assert contrast(found[name], found[ground]) >= PICTURE_CONTRAST


def test_both_schemes_name_the_same_colors() -> None:
    assert colors(LIGHT).keys() == colors(DARK).keys()


def test_paper_is_light() -> None:
    onto_paper = stylesheet().split("@media print {")[1]
    assert ":root { color-scheme: light; }" in onto_paper
    assert "@media screen and (prefers-color-scheme: dark)" in stylesheet()
