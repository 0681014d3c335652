import os
from pathlib import Path

import pytest

from ropsim.core import configuration_folder
from ropsim.userfiles import Trust, TrustError, code_in, set_trust, trust_in
from ropsim.workbench import new_project, open_project


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("ROPSIM_CONFIG_HOME", str(tmp_path / "config"))
    return new_project(tmp_path / "cell")


def add_code(project: Path) -> None:
    (project / "controllers").mkdir()
    (project / "controllers" / "law.py").write_text("raise SystemExit\n", "utf-8")
    (project / "press.FMU").write_bytes(b"")


def test_nothing_is_trusted_until_the_user_says_so_and_links_lead_to_the_same_folder(
    project: Path, tmp_path: Path
) -> None:
    (tmp_path / "link").symlink_to(project)
    assert trust_in(project) is Trust.WITHHELD
    set_trust(tmp_path / "link", Trust.GIVEN)
    assert trust_in(project) is Trust.GIVEN
    assert trust_in(project / "programs") is Trust.WITHHELD
    set_trust(project, Trust.WITHHELD)
    assert trust_in(project) is Trust.WITHHELD


def test_the_project_has_no_say_in_its_trust(project: Path) -> None:
    before = sorted(project.rglob("*"))
    set_trust(project, Trust.GIVEN)
    assert sorted(project.rglob("*")) == before


def test_only_project_folders_are_trusted(tmp_path: Path, project: Path) -> None:
    for place in (tmp_path, tmp_path / "nowhere", project / "cell.toml"):
        with pytest.raises(TrustError) as refused:
            set_trust(place, Trust.GIVEN)
        assert refused.value.diagnostic.code == "X892"


def test_trust_that_cannot_be_stored_is_told(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROPSIM_CONFIG_HOME", str(project / "cell.toml"))
    with pytest.raises(TrustError) as refused:
        set_trust(project, Trust.GIVEN)
    assert refused.value.diagnostic.code == "X891"


@pytest.mark.parametrize("content", ["", "[]", '{"version":2,"folders":["/"]}', '{"version":1,"folders":3}'])
def test_a_damaged_list_trusts_nobody(project: Path, content: str) -> None:
    set_trust(project, Trust.GIVEN)
    (configuration_folder() / "trust.json").write_text(content, "utf-8")
    assert trust_in(project) is Trust.WITHHELD


def test_code_is_named_and_results_and_hidden_folders_are_not(project: Path) -> None:
    assert code_in(project) == ()
    add_code(project)
    for name in ("out", ".venv", "__pycache__"):
        (project / name).mkdir()
        (project / name / "x.py").write_text("", "utf-8")
    assert code_in(project) == ("controllers/law.py", "press.FMU")


def test_opening_says_which_code_stays_inert_until_the_folder_is_trusted(project: Path) -> None:
    assert open_project(project).diagnostics == ()
    add_code(project)
    (finding,) = open_project(project).diagnostics
    assert (finding.code, finding.is_error) == ("X890", False)
    assert "`controllers/law.py`" in finding.message
    set_trust(project, Trust.GIVEN)
    assert open_project(project).diagnostics == ()


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="no owners of files")
@pytest.mark.parametrize("others", [0o020, 0o002])
def test_a_list_that_others_can_write_trusts_nobody(project: Path, others: int) -> None:
    set_trust(project, Trust.GIVEN)
    place = configuration_folder() / "trust.json"
    assert place.stat().st_mode & 0o777 == 0o600
    place.chmod(0o600 | others)
    assert trust_in(project) is Trust.WITHHELD
    set_trust(project, Trust.GIVEN)
    assert trust_in(project) is Trust.GIVEN


def test_a_list_in_the_working_folder_trusts_nobody(
    project: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    set_trust(project, Trust.GIVEN)
    planted = (configuration_folder() / "trust.json").rename(tmp_path / "trust.json")
    monkeypatch.chdir(planted.parent)
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    for place in ("", "."):
        monkeypatch.setenv("ROPSIM_CONFIG_HOME", place)
        assert trust_in(project) is Trust.WITHHELD
