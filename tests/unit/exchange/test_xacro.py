"""Xacro: a file of macros, as robot files of ROS are written, becomes the robot that was meant."""

from pathlib import Path

import pytest

from ropsim.core import SourceText
from ropsim.exchange import ReadOptions, RobotFolder, read_urdf
from ropsim.exchange.testing import Notes, expanded, read_xml
from ropsim.model import Mesh, ReadRobot, RobotModel
from support.exchange_laws import differences
from support.urdf_texts import MACROS, SPELLINGS

MAIN = """<robot name="$(arg name)" xmlns:xacro="http://wiki.ros.org/xacro">
  <xacro:arg name="name" default="folding"/>
  <xacro:arg name="bare" default="false"/>
  <xacro:include filename="$(find arm)/urdf/macros.xacro"/>
  <xacro:arm prefix="r_" meshes="$(arg meshes)"/>
</robot>
"""
PLAIN = """<robot name="folding"><link name="r_base_link"/>
  <link name="r_upper"><inertial><origin xyz="0.25 0 0"/><mass value="2"/>
    <inertia ixx="{a}" ixy="0" ixz="0" iyy="{b}" iyz="0" izz="{b}"/></inertial></link>
  <link name="r_fore"><inertial><origin xyz="0.25 0 0"/><mass value="1.5"/>
    <inertia ixx="{c}" ixy="0" ixz="0" iyy="{d}" iyz="0" izz="{d}"/></inertial></link>
  <link name="r_tool0"/>
  <joint name="r_joint_1" type="continuous"><parent link="r_base_link"/><child link="r_upper"/>
    <origin xyz="0 0 1"/><axis xyz="0 1 0"/></joint>
  <joint name="r_joint_2" type="continuous"><parent link="r_upper"/><child link="r_fore"/>
    <origin xyz="0.5 0 0"/><axis xyz="0 1 0"/></joint>
  <joint name="t" type="fixed"><parent link="r_fore"/><child link="r_tool0"/><origin xyz="0.5 0 0"/></joint>
</robot>""".format(a=2 / 12 * 0.02, b=2 / 12 * 0.26, c=1.5 / 12 * 0.02, d=1.5 / 12 * 0.26)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "packages" / "urdf").mkdir(parents=True)
    (tmp_path / "packages" / "urdf" / "macros.xacro").write_text(MACROS)
    (tmp_path / "packages" / "fore.stl").write_text("solid")
    return tmp_path


def read(folder: Path, main: str = MAIN, **arguments: str) -> ReadRobot:
    if main.count("(arg meshes)"):
        arguments.setdefault("meshes", "false")
    options = ReadOptions(folder=RobotFolder(folder, {"arm": "packages"}), arguments=arguments)
    return read_urdf(SourceText("main.xacro", main), options)


def robot_of(found: ReadRobot) -> RobotModel:
    assert found.robot is not None, found.findings
    return found.robot


def test_macros_properties_blocks_and_arguments_give_the_robot(folder: Path) -> None:
    robot = robot_of(read(folder))
    plain = robot_of(read_urdf(SourceText("a", PLAIN)))
    assert robot.name == "folding"
    assert max(differences(robot, plain)) < 1e-15
    assert robot.joints[1].upper == pytest.approx(2.0943951023931953)
    assert robot.joints[0].max_speed == pytest.approx(1.5707963267948966)
    assert [one.max_jerk for one in robot.joints] == [50.0, 50.0]


def test_arguments_choose(folder: Path) -> None:
    robot = robot_of(read(folder, name="other", bare="true"))
    assert robot.name == "other"
    assert robot.X_nM.position.tolist() == [0.0, 0.0, 0.0]


def test_meshes_of_packages_are_found_and_missing_ones_are_told(folder: Path) -> None:
    found = read(folder, meshes="true")
    robot = robot_of(found)
    assert Mesh("packages/fore.stl") in [one.solid for one in robot.links[1].shapes]
    missing = [one.message for one in found.findings if one.code == "X991"]
    assert missing == ["the mesh `package://arm/upper.stl` is not there"]


WRONG = {
    "nobody has defined `lenght`": MAIN.replace("r_", "${lenght}"),
    "there is no macro `amr`": MAIN.replace("xacro:arm", "xacro:amr"),
    "the argument `mehses` has no value": MAIN.replace("(arg meshes)", "(arg mehses)"),
    "no parameter `side`": MAIN.replace("prefix=", "side=").replace("meshes=", 'prefix="" meshes='),
    "lacks the parameter `prefix`": MAIN.replace('prefix="r_" ', ""),
    "not near to the robot file": MAIN.replace("find arm", "find leg"),
    "`$(env ...)` is not carried out": MAIN.replace("$(arg name)", "$(env HOME)"),
    "a condition is `perhaps`": MAIN,
    "more than 40 in each other": MAIN.replace(
        "<xacro:arm", '<xacro:macro name="m"><xacro:m/></xacro:macro><xacro:m/><xacro:arm'
    ),
    "becomes too much": MAIN.replace(
        "<xacro:arm",
        '<xacro:macro name="m0"/>'
        + "".join(f'<xacro:macro name="m{k}">{f"<xacro:m{k - 1}/>" * 9}</xacro:macro>' for k in range(1, 12))
        + "<xacro:m11/><xacro:arm",
    ),
    "is defined by itself": MAIN.replace(
        "<xacro:arm", '<xacro:property name="M_PI" value="${M_PI}"/><xacro:arm'
    ),
    "a list has more": MAIN.replace(
        "<xacro:arm",
        '<xacro:property name="l0" value="${[1, 2]}"/>'
        + "".join(f'<xacro:property name="l{k}" value="${{[l{k - 1}, l{k - 1}]}}"/>' for k in range(1, 28))
        + '<link name="${l27}"/><xacro:arm',
    ),
    "a text has more": MAIN.replace(
        "<xacro:arm",
        '<xacro:property name="t0" value="abcdefgh"/>'
        + "".join(f'<xacro:property name="t{k}" value="${{t{k - 1}}}${{t{k - 1}}}"/>' for k in range(1, 28))
        + '<link name="${t27}"/><xacro:arm',
    ),
    "takes 0 blocks, the call has `link` too": MAIN.replace(
        'meshes="$(arg meshes)"/>', 'meshes="0"><link name="x"/></xacro:arm>'
    ),
    "lacks the block": MAIN.replace("<xacro:arm", '<xacro:hinge number="1" parent="a" child="b"/><xacro:arm'),
    "more than one of `value`": MAIN.replace(
        "<xacro:arm", '<xacro:property name="p" value="1" default="2"/><xacro:arm'
    ),
    "is a pattern of several files": MAIN.replace("macros.xacro", "*.xacro"),
    "the file refuses itself: no arm": MAIN.replace(
        "<xacro:arm", "<gazebo>${xacro.fatal('no', 'arm')}</gazebo><xacro:arm"
    ),
    "is not closed": MAIN.replace('"r_"', '"${1"'),
}


@pytest.mark.parametrize("words", WRONG)
def test_mistakes_are_told_with_their_place(folder: Path, words: str) -> None:
    arguments = {"bare": "perhaps"} if "perhaps" in words else {}
    found = read(folder, WRONG[words], **arguments)
    assert found.robot is None
    (error,) = [one for one in found.findings if one.is_error]
    assert (error.code, words in error.message) == ("X992", True), error
    assert error.span is not None
    assert error.hint


@pytest.mark.parametrize(
    "name",
    ["../outside.xacro", "/etc/hostname", "file:///etc/hostname", "$(find arm)/../../x", "a\0b", "urdf"],
)
def test_nothing_outside_of_the_folders_is_read(folder: Path, name: str) -> None:
    (folder.parent / "outside.xacro").write_text("<robot/>")
    text = MAIN.replace("$(find arm)/urdf/macros.xacro", name.replace("\0", "&#1;"))
    assert read(folder, text).robot is None


def test_a_link_that_leads_out_is_not_followed(
    folder: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    other = tmp_path_factory.mktemp("other")
    (other / "macros.xacro").write_text(MACROS)
    (folder / "packages" / "urdf" / "macros.xacro").unlink()
    (folder / "packages" / "urdf" / "macros.xacro").symlink_to(other / "macros.xacro")
    assert read(folder).robot is None


def test_properties_of_outer_scopes_and_defaults() -> None:
    text = """<robot name="a" xmlns:xacro="x">
      <xacro:macro name="set"><xacro:property name="where" value="${1 + 1}" scope="parent"/>
        <xacro:property name="all" value="3" scope="global"/></xacro:macro>
      <xacro:property name="where" default="9"/><xacro:set/><xacro:property name="where" default="7"/>
      <xacro:call macro="set"/>
      <link name="base_link"/><link name="l${where}${all}$${x}"/>
      <joint name="j" type="continuous"><parent link="base_link"/><child link="l23${'$'}{x}"/></joint>
    </robot>"""
    robot = robot_of(read_urdf(SourceText("a", text)))
    assert robot.n == 1


def test_macros_hand_values_to_their_callers_as_files_of_universal_robots_do(folder: Path) -> None:
    text = """<robot name="a" xmlns:xacro="x">
      <xacro:macro name="look" params="name:=^ type:=^">
        <xacro:property name="found" value="${files[name][type]}" scope="parent"/>
      </xacro:macro>
      <xacro:macro name="path" params="name:=^ type:=^">
        <xacro:look/>
        <xacro:property name="mesh" scope="parent"
          value="file://$(find ${found['package']})/${found['path']}"/>
      </xacro:macro>
      <xacro:macro name="mesh" params="name type"><xacro:path/><mesh filename="${mesh}"/></xacro:macro>
      <xacro:macro name="arm" params="files:=${dict(fore=dict(visual=dict(package='arm', path='fore.stl')))}">
        <link name="base_link"/>
        <link name="fore"><visual><geometry><xacro:mesh name="fore" type="visual"/></geometry></visual></link>
        <joint name="j" type="continuous"><parent link="base_link"/><child link="fore"/></joint>
      </xacro:macro>
      <xacro:arm/>
    </robot>"""
    robot = robot_of(read(folder, text))
    assert [one.solid for one in robot.links[0].shapes] == [Mesh("packages/fore.stl")]


LINKS = """<robot name="a" xmlns:xacro="x">{body}
  <link name="base_link"/><link name="tip"/>
  <joint name="j" type="continuous"><parent link="base_link"/><child link="tip"/></joint></robot>"""


def made(folder: Path, body: str) -> list[tuple[str, dict[str, str]]]:
    """Return names and attributes of the elements `t` that a body becomes."""
    notes = Notes()
    root = read_xml(SourceText("main.xacro", LINKS.format(body=body)), notes)
    assert root is not None
    whole = expanded(root, ReadOptions(folder=RobotFolder(folder, {"arm": "packages"})), notes)
    assert whole is not None, notes.found
    return [(one.name, dict(one.attributes)) for one in whole.children if one.name not in ("link", "joint")]


MEANT = {
    "blocks are passed by their order": (
        """<xacro:macro name="m" params="**first *second"><t><xacro:insert_block name="first"/></t>
           <xacro:insert_block name="second"/><xacro:insert_block name="first"/></xacro:macro>
           <xacro:m><any><u v="1"/></any><w/></xacro:m>""",
        [("t", {}), ("w", {}), ("u", {"v": "1"})],
    ),
    "contents of outer blocks come before elements of the call": (
        """<xacro:property name="b"><t v="1"/></xacro:property>
           <xacro:macro name="m" params="*b"><xacro:insert_block name="b"/>
             <xacro:macro name="n" params="*b"><xacro:insert_block name="b"/></xacro:macro>
             <xacro:property name="b"><t v="2"/></xacro:property><xacro:n><u v="3"/></xacro:n></xacro:macro>
           <xacro:m><u v="4"/></xacro:m>""",
        [("t", {"v": "1"}), ("t", {"v": "2"})],
    ),
    "a property in quotation marks is a number where it is used": (
        """<xacro:property name="q" value="'12'"/><t a="${q * 2}" b="${q == 12}"/>""",
        [("t", {"a": "24", "b": "True"})],
    ),
    "infinite numbers of parameter files are numbers": (
        """<xacro:property name="y" value="${load_yaml('inf.yaml')}"/>
           <xacro:property name="q" value="${y.a}"/>
           <t a="${y.a}" b="${min(y.a, 5)}" c="${y.a > 3}" d="${y.b > -7}" e="${q > 3}" f="${y.c}"/>""",
        [("t", {"a": "inf", "b": "5", "c": "True", "d": "False", "e": "True", "f": "nan"})],
    ),
    "elements of a call are expanded before they are passed": (
        """<xacro:macro name="m" params="*block"><xacro:insert_block name="block"/></xacro:macro>
           <xacro:m><xacro:if value="0"><u/></xacro:if><xacro:unless value="0"><w/></xacro:unless>
           </xacro:m>""",
        [("w", {})],
    ),
    "names of elements and attributes are computed": (
        """<xacro:property name="n" value="t"/><xacro:element xacro:name="${n}" a="${n}">
           <xacro:attribute name="${n}${n}" value="${1 + 1}"/></xacro:element>
           <xacro:element xacro:name="xacro:if" value="1"><u xacro:hidden="1"/></xacro:element>""",
        [("t", {"a": "t", "tt": "2"}), ("u", {})],
    ),
    "properties are removed": (
        """<xacro:property name="p" default="1st"/><xacro:property name="p" remove="true"/>
           <xacro:property name="p" default="2nd"/><t p="${p}"/>""",
        [("t", {"p": "2nd"})],
    ),
    "a property is evaluated where it is used, or where it is defined": (
        """<xacro:property name="x" value="1"/><xacro:property name="late" value="${x}"/>
           <xacro:property name="now" value="${x}" lazy_eval="false"/><xacro:property name="x" value="2"/>
           <xacro:property name="now" value="${now + 10}" lazy_eval="false"/><t l="${late}" n="${now}"/>""",
        [("t", {"l": "2", "n": "11"})],
    ),
    "a macro has its own properties and macros": (
        """<xacro:property name="p" value="outer"/><xacro:macro name="m"><t p="${p}"/>
           <xacro:property name="p" value="inner"/><xacro:macro name="m"><u p="${p}"/></xacro:macro>
           <xacro:m/></xacro:macro><xacro:m/><xacro:m/>""",
        [("t", {"p": "outer"}), ("u", {"p": "inner"})] * 2,
    ),
    "parameters have blanks about their defaults, and quotation marks in them": (
        """<xacro:macro name="m" params="a := 1 b = 'x y' c:='' d:=^|${2 * 3} e:=v'1 2'">
           <t a="${a}" b="${b}" c="${c}" d="${d}" e="${e}"/></xacro:macro><xacro:m/>""",
        [("t", {"a": "1", "b": "x y", "c": "", "d": "6", "e": "v'1 2'"})],
    ),
    "names that every file has are not defined by a default": (
        """<xacro:property name="pi" default="3"/><t v="${pi > 3}"/>""",
        [("t", {"v": "True"})],
    ),
    "a list is true if it holds something": (
        """<xacro:if value="${[0]}"><t/></xacro:if><xacro:if value="${None}"><u/></xacro:if>""",
        [("t", {})],
    ),
    "quotation marks keep a text where it is evaluated once": (
        """<xacro:property name="late" value="'0010'"/><t p="${late}"/>
           <xacro:property name="now" value="'0010'" lazy_eval="false"/><t p="${now}"/>
           <xacro:property name="all" value="'0010'" scope="global"/><t p="${all}"/>
           <xacro:property name="n" value="5"/><xacro:property name="p" value="'${n}'"/><t p="${p + 1}"/>
           <xacro:macro name="m" params="p q:='0010'"><t p="${p}" q="${q}"/></xacro:macro><xacro:m p="'07'"/>
           """,
        [("t", {"p": value}) for value in ("10", "0010", "0010", "6")] + [("t", {"p": "07", "q": "0010"})],
    ),
    "files that are not there may be optional": (
        """<xacro:include filename="none.xacro" optional="true"/><t/>""",
        [("t", {})],
    ),
    "a file that is included into a name space is seen behind its name": (
        """<xacro:property name="var" value="main"/><xacro:include filename="space.xacro" ns="A"/>
           <xacro:property name="late" value="l"/><t var="${var}" a="${2 * A.var}"/>
           <xacro:A.foo p="${var}"/><xacro:call macro="A.set"/><u var="${var}"/>""",
        [
            ("t", {"var": "main", "a": "4"}),
            ("foo", {"p": "2", "var": "2", "late": "l"}),
            ("u", {"var": "macro"}),
        ],
    ),
}
SPACE = """<robot xmlns:xacro="x"><xacro:property name="var" value="2"/>
  <xacro:macro name="foo" params="p"><foo p="${p}" var="${var}" late="${late}"/></xacro:macro>
  <xacro:macro name="set"><xacro:property name="var" value="macro" scope="parent"/></xacro:macro></robot>"""


@pytest.mark.parametrize("case", MEANT)
def test_constructs_mean_what_the_official_tool_makes_of_them(folder: Path, case: str) -> None:
    body, expected = MEANT[case]
    (folder / "space.xacro").write_text(SPACE)
    (folder / "inf.yaml").write_text("a: .inf\nb: -.INF\nc: .nan\n")
    assert made(folder, body) == expected


def test_the_folder_of_an_included_file_is_its_own(folder: Path) -> None:
    (folder / "packages" / "urdf" / "here.xacro").write_text(
        '<robot xmlns:xacro="x"><xacro:property name="v" value="${load_yaml(\'$(dirname)/v.yaml\')}"/>'
        '<t v="${v.x}" mesh="$(dirname)/../fore.stl"/></robot>'
    )
    (folder / "packages" / "urdf" / "v.yaml").write_text("x: 5")
    ((_, attributes),) = made(folder, '<xacro:include filename="packages/urdf/here.xacro"/>')
    assert attributes["v"] == "5"
    assert RobotFolder(folder).path(attributes["mesh"]) == "packages/fore.stl"


def test_messages_of_a_file_are_reported_once(folder: Path) -> None:
    text = MAIN.replace(
        "<xacro:arm", "<gazebo>${xacro.warning('no mass of', 'link_3')}</gazebo>" * 3 + "<xacro:arm"
    )
    found = read(folder, text)
    robot_of(found)
    (message,) = [one for one in found.findings if one.code == "X998"]
    assert message.message == "the file says: no mass of link_3"
    assert message.span is not None


def test_texts_are_cut_joined_and_counted() -> None:
    found = read_urdf(SourceText("words.xacro", SPELLINGS))
    robot = robot_of(found)
    assert [one.name for one in robot.joints] == ["BASE_1", "LEFT_2"]
    assert robot.joints[0].upper == pytest.approx(1.5707963267948966)
    assert [one.code for one in found.findings if one.code == "X998"] == ["X998"]
    other = robot_of(
        read_urdf(SourceText("words.xacro", SPELLINGS), ReadOptions(arguments={"side": "right"}))
    )
    assert [one.name for one in other.joints] == ["BASE_1", "RIGH_2"]


@pytest.mark.parametrize(
    ("callers", "hint"),
    [
        ([], "open the file that calls them"),
        (["main.xacro"], "open `main.xacro`, which calls them"),
        (["a.xacro", "macro.xacro"], "open `macro.xacro`, `a.xacro`, which call them"),
    ],
)
def test_a_file_that_only_defines_macros_names_them_and_who_calls_them(
    folder: Path, callers: list[str], hint: str
) -> None:
    urdf = folder / "packages" / "urdf"
    for name in callers:
        (urdf / name).write_text(MAIN, "utf-8")
    (urdf / "other.xacro").write_text('<robot name="a" xmlns:xacro="http://wiki.ros.org/xacro"/>', "utf-8")
    options = ReadOptions(folder=RobotFolder(folder, {}, "packages/urdf"))
    (found,) = read_urdf(SourceText("packages/urdf/macros.xacro", MACROS), options).findings
    assert found.code == "X982"
    assert "the file only defines macros, `" in found.message
    assert "`arm`" in found.message
    assert found.hint == hint
