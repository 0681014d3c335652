"""`ropsim robot export` and `import`: what is lost, and where nothing may be."""

from pathlib import Path
from xml.etree import ElementTree

import pytest

from ropsim.cli.testing import main


def test_strictly_nothing_is_written_where_something_is_lost(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    place = tmp_path / "arm.urdf"
    assert main(["robot", "export", "puma560", str(place), "--strict"]) == 1
    assert not place.exists()
    assert "error[X996]" in capsys.readouterr().err


def test_strictly_a_file_is_written_where_nothing_is_lost(tmp_path: Path) -> None:
    first, second = tmp_path / "arm.stp", tmp_path / "again.stp"
    assert main(["robot", "export", "puma560", str(first), "--strict"]) == 0
    assert main(["robot", "import", str(first), "--to", str(second), "--strict"]) == 0
    assert second.read_bytes() == first.read_bytes()


def test_strictly_what_reading_loses_counts_too(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    place, other = tmp_path / "arm.urdf", tmp_path / "arm.stp"
    assert main(["robot", "export", "scara", str(place)]) == 0
    text = place.read_text("utf-8")
    assert main(["robot", "import", str(place), "--to", str(other), "--strict"]) == 0
    other.unlink()
    place.write_text(text.replace("</robot>", "<gazebo/></robot>"), "utf-8")
    capsys.readouterr()
    assert main(["robot", "import", str(place), "--to", str(other), "--strict"]) == 1
    assert not other.exists()
    assert "1 thing would be lost" in capsys.readouterr().err


def test_sdformat_is_written_and_no_cell_is_proposed_that_cannot_read_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    place = tmp_path / "arm.sdf"
    assert main(["robot", "export", "puma560", str(place)]) == 0
    assert ElementTree.fromstring(place.read_text("utf-8")).tag == "sdf"
    assert capsys.readouterr().out == f"wrote {place}\n"


def test_an_ending_that_is_not_written_is_answered_with_those_that_are(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["robot", "export", "puma560", str(tmp_path / "arm.xacro")]) == 2
    assert "`.urdf`, `.xml`, `.stp`, `.step`, `.sdf`" in capsys.readouterr().err
