"""Which folders of the machine a page is told, so that the user can choose one."""

from pathlib import Path

import pytest

from ropsim.studio.testing import folders_in, places_of


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a home with projects, one of them open, beside what is no business of pages."""
    home = tmp_path / "home"
    for name in ("cells/one", "cells/two/programs", "cells/.git", "music"):
        (home / name).mkdir(parents=True)
    for name in ("one", "two"):
        (home / "cells" / name / "cell.toml").touch()
    (home / "cells" / "notes.txt").touch()
    (tmp_path / "secrets").mkdir()
    (home / "cells" / "out").symlink_to(tmp_path / "secrets")
    monkeypatch.setenv("HOME", str(home))
    return home


def test_first_come_the_folders_beside_the_project_with_which_of_them_are_projects(home: Path) -> None:
    found = folders_in("", places_of(home / "cells" / "one"))
    assert (found.place, found.parent) == (str(home / "cells"), str(home))
    assert [(one.name, one.project) for one in found.folders] == [("one", True), ("two", True)]
    inside = folders_in(found.folders[1].path, places_of(home / "cells" / "one"))
    assert [one.name for one in inside.folders] == ["programs"]


@pytest.mark.parametrize(
    "wanted",
    ["/", "/etc", "..", "{home}/..", "{home}/cells/out", "{home}/cells/notes.txt", "a\0b", "~nobody"],
)
def test_nothing_is_told_of_other_places(home: Path, wanted: str) -> None:
    places = places_of(home / "cells" / "one")
    assert folders_in(wanted.format(home=home), places) == folders_in("", places)
    assert folders_in("~", places) == folders_in(str(home), places)
    assert (folders_in("~", places).place, folders_in("~", places).parent) == (str(home), "")


def test_a_project_in_the_root_of_the_file_system_does_not_open_all_of_it(home: Path) -> None:
    assert places_of(Path("/cell")) == (home,)
    assert folders_in("", ()).place == ""
