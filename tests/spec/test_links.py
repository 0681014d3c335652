"""Links between pages: every one leads to a file, and to a heading where it names one."""

import re
from pathlib import Path

from support.manual import DOCS
from support.pages import steps

ROOT = DOCS.parent
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)|(?:src|srcset)=\"([^\"]+)\"")
FENCE = re.compile(r"^```.*?^```$|^    .*$|`[^`\n]+`", re.MULTILINE | re.DOTALL)


def slug(title: str) -> str:
    """Return the name of a heading in addresses, as code hosts make it."""
    return re.sub(r"\s", "-", re.sub(r"[^\w\s-]", "", title.lower().replace("`", "")))


def headings(page: Path) -> set[str]:
    return {slug(title) for title in re.findall(r"^#+ +(.+)$", page.read_text("utf-8"), re.MULTILINE)}


def links(page: Path) -> list[str]:
    """Return what the links of a page name, but for those to other hosts."""
    named = [match[1] or match[2] for match in LINK.finditer(FENCE.sub("", page.read_text("utf-8")))]
    return [target for target in named if not re.match(r"[a-z]+:", target)]


def leads_somewhere(page: Path, target: str) -> bool:
    file, _, heading = target.partition("#")
    place = (page.parent / file).resolve() if file else page
    return place.exists() and (not heading or heading in headings(place))


def test_every_link_of_a_page_leads_somewhere() -> None:
    """In one test: a test for each of the pages would be one of twelve of the whole suite."""
    named = [
        (page, target) for page in sorted([*DOCS.rglob("*.md"), *ROOT.glob("*.md")]) for target in links(page)
    ]
    assert len(named) > 500
    nowhere = [
        (page.relative_to(ROOT).as_posix(), target)
        for page, target in named
        if not leads_somewhere(page, target)
    ]
    assert nowhere == []


def test_the_index_names_every_page() -> None:
    index = (DOCS / "README.md").read_text("utf-8")
    generated = DOCS / "reference" / "diagnostics"
    pages = [page for page in DOCS.rglob("*.md") if generated not in page.parents and page.parent != DOCS]
    missing = [page.relative_to(DOCS).as_posix() for page in pages]
    assert [page for page in missing if page not in index] == []


PATH = re.compile(r"`((?:[a-z_]+/)+[a-z_]+(?:\.(?:py|pl|ts|toml|md|sh)|/)?)`")
PLACES = [ROOT / place for place in ("", "src", "src/ropsim", "frontend/src", "tests")]
"""Folders that paths in pages are relative to, besides that of the page."""


def missing_paths(page: Path) -> list[str]:
    """Return the paths below a known folder that a page names and that neither exist nor are made by it."""
    made, places = {one.path for one in steps(page)}, [*PLACES, page.parent]
    return [
        path
        for path in PATH.findall(page.read_text("utf-8"))
        if any((place / path.split("/")[0]).is_dir() for place in places)
        and not any((place / f"{path}{end}").exists() for place in places for end in ("", ".py"))
        and not any(path in one for one in made)
    ]


def test_pages_for_engineers_name_files_that_exist() -> None:
    pages = [*(DOCS / "how-to").glob("*.md"), *(DOCS / "explanation").glob("*.md"), *ROOT.glob("*.md")]
    pages += (ROOT / "src").rglob("README.md")
    assert {page.name: missing for page in pages if (missing := missing_paths(page))} == {}
