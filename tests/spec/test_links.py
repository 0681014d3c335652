"""Links between pages: every one leads to a file, and to a heading where it names one."""

import re
from pathlib import Path

import pytest

from support.manual import DOCS

ROOT = DOCS.parent
PAGES = sorted([*DOCS.rglob("*.md"), *ROOT.glob("*.md")])
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)|(?:src|srcset)=\"([^\"]+)\"")
FENCE = re.compile(r"^```.*?^```$|^    .*$|`[^`\n]+`", re.MULTILINE | re.DOTALL)


def slug(title: str) -> str:
    """Return the name of a heading in addresses, as code hosts make it."""
    return re.sub(r"\s", "-", re.sub(r"[^\w\s-]", "", title.lower().replace("`", "")))


def headings(page: Path) -> set[str]:
    return {slug(title) for title in re.findall(r"^#+ +(.+)$", page.read_text("utf-8"), re.MULTILINE)}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_every_link_of_a_page_leads_somewhere(page: Path) -> None:
    text = FENCE.sub("", page.read_text("utf-8"))
    for match in LINK.finditer(text):
        target = match[1] or match[2]
        if re.match(r"[a-z]+:", target):
            continue
        file, _, heading = target.partition("#")
        place = (page.parent / file).resolve() if file else page
        assert place.exists(), target
        if heading:
            assert heading in headings(place), target


def test_the_index_names_every_page() -> None:
    index = (DOCS / "README.md").read_text("utf-8")
    generated = DOCS / "reference" / "diagnostics"
    pages = [page for page in DOCS.rglob("*.md") if generated not in page.parents and page.parent != DOCS]
    missing = [page.relative_to(DOCS).as_posix() for page in pages]
    assert [page for page in missing if page not in index] == []
