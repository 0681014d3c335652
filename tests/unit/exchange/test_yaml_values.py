"""Parameter files of robots: the part of YAML that they use; the rest is refused."""

from math import inf, nan, pi
from pathlib import Path

import pytest

from ropsim.core import SourceText
from ropsim.exchange import ReadOptions, RobotFolder, read_urdf
from ropsim.exchange.testing import Value, XacroError, yaml_value
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


def test_anchors_are_taken_over_and_merged() -> None:
    text = """
leftfinger: &finger
  mass: 0.015
  inertia: {xx: 1, yy: 2}
rightfinger: *finger
thumb:
  <<: *finger
  mass: 0.02
rate: &hz 500
again: [*hz, &one 1, *one]
list:
- &first a
- *first
"""
    finger = {"mass": 0.015, "inertia": {"xx": 1, "yy": 2}}
    assert yaml_value(text) == {
        "leftfinger": finger,
        "rightfinger": finger,
        "thumb": {**finger, "mass": 0.02},
        "rate": 500,
        "again": [500, 1, 1],
        "list": ["a", "a"],
    }


def test_brackets_go_over_several_lines_and_words_are_truth_values() -> None:
    text = """
home: [1.5,   # shoulder
  {a: "x, ]",
   b: [2]},
  ]
brake: yes
free: off
urls: {a: http://x/y, b: 'it''s'}
"""
    assert yaml_value(text) == {
        "home": [1.5, {"a": "x, ]", "b": [2]}],
        "brake": True,
        "free": False,
        "urls": {"a": "http://x/y", "b": "it's"},
    }


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("010", 8),
        ("-0x1F", -31),
        ("0b101", 5),
        ("1_000", 1000),
        ("1:30", 90),
        ("-190:20:30", -685230),
        ("20:30.15", 1230.15),
        ("6.8523015e+5", 685230.15),
        ("+.5", "+.5"),
        ("08", "08"),
        ("0o17", "0o17"),
        ("1e3", "1e3"),
        ("1.0e3", "1.0e3"),
        ("1:60", "1:60"),
        ("'0010'", "0010"),
        ("y", "y"),
        ("TRUE", True),
        ("Off", False),
        ("-.INF", -inf),
        (".NaN", nan),
    ],
)
def test_plain_words_are_those_of_yaml_1_1(text: str, value: Value) -> None:
    """As the types of YAML 1.1 have them (yaml.org/type/int.html, float.html, bool.html) and PyYAML 6.0."""
    for whole, expected in (
        (text, value),
        (f"a: {text}", {"a": value}),
        (f"- {text}", [value]),
        (f"[{text}, x]", [value, "x"]),
        (f"{{a: {text}}}", {"a": value}),
    ):
        assert repr(yaml_value(whole)) == repr(expected)  # with its type


def test_keys_that_are_numbers_or_truth_values_stay_such() -> None:
    text = "010: a\n'010': b\n1.5: {on: c, 0x10: d}\n~: [2: e, f:]\n"
    assert yaml_value(text) == {8: "a", "010": "b", 1.5: {True: "c", 16: "d"}, None: [{2: "e"}, {"f": None}]}


def test_lists_stand_in_lists_by_dashes() -> None:
    assert yaml_value("- - 1\n  - -a\n-\n- -") == [[1, "-a"], None, [None]]


def test_numbers_with_units_are_in_si_units() -> None:
    text = "[!degrees 2*90, !radians pi, !meters 2*3, !millimeters 25.0, !foot 1/0.3048, !inches 1/0.0254]"
    assert yaml_value(text) == pytest.approx([pi, pi, 6.0, 0.025, 1.0, 1.0])
    with pytest.raises(XacroError, match="nobody has defined `os`"):
        yaml_value("a: !radians os.system('clear')")


@pytest.mark.parametrize(
    "text",
    [
        "a: *b",
        "a: &b [*b]",
        "<<: 1",
        "a: |\n  text",
        "a: !!python/object:os.system x",
        "a: !degrees x",
        "a: [1,\n  2",
        "a0: &a0 [1, 1]\n" + "\n".join(f"a{k}: &a{k} [*a{k - 1}, *a{k - 1}]" for k in range(1, 40)),
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
