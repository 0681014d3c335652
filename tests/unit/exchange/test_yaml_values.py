"""Parameter files of robots: the part of YAML that they use; the rest is refused."""

from math import pi
from pathlib import Path

import pytest

from ropsim.core import SourceText
from ropsim.exchange import ReadOptions, RobotFolder, read_urdf
from ropsim.exchange.xacro.values import Value, XacroError
from ropsim.exchange.xacro.yaml_values import yaml_value
from support.urdf_texts import LIMITS


def test_what_parameter_files_use_is_read() -> None:
    assert yaml_value(LIMITS) == {
        "joint_limits": {
            "shoulder_pan": {
                "has_velocity_limits": True,
                "max_position": pytest.approx(2.0 * pi),
                "min_position": pytest.approx(-2.0 * pi),
                "turn": pytest.approx(pi / 2.0),
            },
            "elbow": {"max_position": 3.5, "name": "a: b # c"},
        },
        "list": [1, {"x": 2, "y": [1, "two", {"k": 3}]}, [-4]],
        "empty": None,
        "nothing": None,
        "inline": {"a": 1, "b": "x, y"},
    }


@pytest.mark.parametrize(
    ("text", "value"), [("", {}), ("5", 5), ("[1, 2]", [1, 2]), ("-5", -5), ("- 5", [5])]
)
def test_small_texts(text: str, value: Value) -> None:
    assert yaml_value(text) == value


@pytest.mark.parametrize(
    "text",
    [
        "a: &b 1",
        "a: *b",
        "a: |\n  text",
        "a: !!python/object:os.system x",
        "a: !degrees x",
        "a: [1,\n  2]",
        "a: [1,, 2]",
        "a: {b}",
        "\ta: 1",
        "a: 1\n   b: 2\n c: 3",
        "a: 1\nb",
        "a: " + "[" * 30 + "]" * 30,
        "\n".join(" " * k + f"k{k}:" for k in range(40)),
        "a: [" + "1, " * 3000 + "1]",
        "a: 1\n" * 6000,
    ],
)
def test_the_rest_is_refused(text: str) -> None:
    with pytest.raises(XacroError):
        yaml_value(text)


def test_a_xacro_file_takes_its_limits_from_one(tmp_path: Path) -> None:
    (tmp_path / "limits.yaml").write_text(LIMITS)
    text = """<robot name="a" xmlns:xacro="x">
      <xacro:property name="file" value="limits.yaml"/>
      <xacro:property name="limits" value="${xacro.load_yaml(file)['joint_limits']}"/>
      <link name="base_link"/><link name="l"/>
      <joint name="j" type="revolute"><parent link="base_link"/><child link="l"/>
        <limit lower="${limits['shoulder_pan']['min_position']}" upper="${limits['elbow']['max_position']}"
          velocity="${load_yaml('$(find p)/limits.yaml').list[0]}" effort="0"/></joint>
    </robot>"""
    options = ReadOptions(folder=RobotFolder(tmp_path, {"p": ""}))
    robot = read_urdf(SourceText("a.xacro", text), options).robot
    assert robot is not None
    (joint,) = robot.joints
    assert [joint.lower, joint.upper, joint.max_speed] == pytest.approx([-2.0 * pi, 3.5, 1.0])
    refused = read_urdf(SourceText("a.xacro", text.replace("limits.yaml", "../x.yaml")), options)
    assert [one.code for one in refused.findings] == ["X992"]
