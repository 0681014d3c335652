"""What a kill in the middle of a save has left in a project is gone when the studio opens the project."""

import asyncio
import sys
from pathlib import Path

import pytest

from ropsim.studio.testing import Editing, Tabs

LEFT = ".ropsim-0123456789abcdef"


@pytest.mark.skipif(sys.platform == "win32", reason="no locks on files that are renamed")
def test_a_project_that_is_opened_has_no_temporary_files_any_more(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROPSIM_STATE_HOME", str(tmp_path / "state"))
    project, elsewhere = tmp_path / "cell", tmp_path / "elsewhere"
    for folder in (project / "programs", project / "kb", elsewhere):
        folder.mkdir(parents=True)
    (project / "cell.toml").write_text("[cell]\n", "utf-8")
    (project / "robots").symlink_to(elsewhere)
    for folder in (project, project / "programs", project / "kb", elsewhere):
        (folder / LEFT).write_bytes(b"half")

    async def opened() -> None:
        editing = Editing(project, Tabs(lambda: 0.0), lambda: None, lambda _: None)
        await editing.open()
        await editing.close()

    asyncio.run(opened())
    assert list(tmp_path.rglob(LEFT)) == [elsewhere / LEFT]  # a link leads out of the project
