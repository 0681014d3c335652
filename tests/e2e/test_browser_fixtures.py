"""The browser fixtures: a page without faults passes, every kind of fault is noticed."""

from pathlib import Path

import pytest

from support.browser import Pages, axe

HEAD = '<!doctype html><html lang="en"><head>'
GOOD = f"{HEAD}<title>t</title></head><body><main><h1>x</h1></main></body></html>"
POLICY = "<meta http-equiv=Content-Security-Policy content=\"script-src 'none'\">"


def page_file(folder: Path, text: str) -> str:
    path = folder / "page.html"
    path.write_text(text, "utf-8")
    return path.as_uri()


def test_a_page_without_faults_passes(open_page: Pages, tmp_path: Path) -> None:
    page = open_page(page_file(tmp_path, GOOD))
    assert page.title() == "t"
    assert axe(page) == []
    assert page.evaluate("() => matchMedia('(prefers-reduced-motion: reduce)').matches")


@pytest.mark.parametrize(
    ("fault", "pattern"),
    [
        ("<script>console.error('trouble 1')</script>", "trouble 1"),
        ("<script>throw new Error('trouble 2')</script>", "trouble 2"),
        ("<script>Promise.reject(new Error('trouble 3'))</script>", "trouble 3"),
        (f"{POLICY}<script>1</script>", "violates"),
    ],
)
def test_every_kind_of_fault_is_noticed(fault: str, pattern: str, open_page: Pages, tmp_path: Path) -> None:
    open_page(page_file(tmp_path, GOOD.replace("<title>", f"{fault}<title>")), expected=[pattern])
    assert [text for text in open_page.complaints() if pattern in text]
    assert open_page.unexpected() == []


def test_axe_names_rule_and_place(open_page: Pages, tmp_path: Path) -> None:
    page = open_page(page_file(tmp_path, GOOD.replace("<h1>x</h1>", "<h1>x</h1><button id=b></button>")))
    assert [text for text in axe(page) if text.startswith("button-name:") and "#b" in text]


def test_webgl_draws_in_software(open_page: Pages, tmp_path: Path) -> None:
    page = open_page(page_file(tmp_path, GOOD))
    assert page.evaluate("() => !!document.createElement('canvas').getContext('webgl2')")
