"""Lists of points in CSV texts: forms that spreadsheets write, and a finding at the cell that is wrong."""

from functools import partial
from pathlib import Path

import pytest

from ropsim import icr
from ropsim.core import Diagnostic, SourceText
from ropsim.language import Environment, compile
from ropsim.spatial import Pose
from ropsim.tasks import PointList, point_table, points_of, read_point_list
from ropsim.tasks.testing import points_text
from support.work import steps_of

HEAD = "name,x,y,z\n,mm,mm,mm\n"


def read(text: str) -> PointList:
    found, findings = points_of(SourceText("points/l.csv", text), "l")
    assert found is not None
    assert not findings, [str(one) for one in findings]
    return found


def wrong(text: str) -> tuple[Diagnostic, ...]:
    return points_of(SourceText("points/l.csv", text), "l")[1]


def numbers(text: str) -> list[tuple[float, ...]]:
    return [tuple(point) for _, point in read(text).points if isinstance(point, tuple)]


@pytest.mark.parametrize(
    "text",
    [
        f"{HEAD}p,1.5,2,3\n",
        "name;x;y;z\n;mm;mm;mm\np;1,5;2;3\n",
        "name\tx\ty\tz\n\tmm\tmm\tmm\np\t1,5\t2\t3\n",
        "sep=;\r\nName;X;Y;Z\r\n;mm;mm;mm\r\np;1,5;2;3\r\n",
        "\ufeffname,x,y,z\n,mm,mm,mm\np,1.5,2,3\n",
        "z,name,y,x\nmm,,mm,mm\n3,p,2,1.5\n",
        '"name","x","y","z"\n"","mm","mm","mm"\n"p","1.5","2","3"\n',
        '"name";"x";"y";"z"\n"";"mm";"mm";"mm"\n"p";"1,5";"2";"3"\n',
        "name, x, y, z\n, mm, mm, mm\n\n  p , 1.5 , 2 , 3 \n\n",
        "name,x,y,z,pitch,roll\n,mm,mm,mm,deg,deg\np,1.5,2,3,,\n",
        "name,x,y,z,,\n,mm,mm,mm,,\np,1.5,2,3,,\n",
        "name,x,y,z\n,cm,m,inch\np,0.15,0.002,0.11811023622047244\n",
        "name,x [mm],y [mm],z [mm]\np,1.5,2,3\n",
        "Name;X (mm);Y (mm);Z(mm)\np;1,5;2;3\n",
        "name,x [cm],y [m],z [inch]\n,cm,m,inch\np,0.15,0.002,0.11811023622047244\n",
        "name,x [cm],y,z\n,,mm,mm\np,0.15,2,3\n",
        "name,x,y,z\n\n,mm,mm,mm\np,1.5,2,3\n",
        "\n;;;\nname;x;y;z\n;;;\n;MM;mm;mm\n;;;\np;1,5;2;3\n",
    ],
)
def test_a_list_may_be_written_as_spreadsheets_do(text: str) -> None:
    found = read(text)
    ((name, point),) = found.points
    assert name == "p"
    assert isinstance(point, tuple)
    assert point == pytest.approx((1.5, 2.0, 3.0), rel=1e-12)
    assert found.numbers == {"p": 1}


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "cp1252", "unmarked"])
def test_a_file_may_have_the_encodings_of_spreadsheets(encoding: str, tmp_path: Path) -> None:
    text = "name;x;y;z\n;mm;mm;mm\nTür;1,5;2;3\n"
    content = text.encode("utf-16-be" if encoding == "unmarked" else encoding)
    (tmp_path / "l.csv").write_bytes(b"\xff\xfe" + content if encoding == "utf-16-le" else content)
    found, findings = read_point_list(tmp_path / "l.csv")
    assert not findings
    assert found is not None
    assert [name for name, _ in found.points] == ["Tür"]


def test_names_may_be_left_out() -> None:
    assert [name for name, _ in read("x,y,z\nmm,mm,mm\n1,2,3\n4,5,6\n").points] == ["1", "2"]
    assert read(f"{HEAD},1,2,3\na,4,5,6\n").numbers == {"a": 2}


def test_quotes_hold_separators_and_quotes() -> None:
    found = read(f'{HEAD}"a,b",1,2,3\n"say ""on""",1,2,3\n')
    assert [name for name, _ in found.points] == ["a,b", 'say "on"']


@pytest.mark.parametrize(
    ("line", "column", "length", "said"),
    [
        ("p,nan,2,3", 3, 3, "`nan` is no finite number"),
        ("p,1,-inf,3", 5, 4, "`-inf` is no finite number"),
        ("p,1,2,3mm", 7, 3, "`3mm` is no number"),
        ("p,1,2,1_000", 7, 5, "`1_000` is no number"),
        ("p,1,,3", 5, 1, "a number is missing"),
        ("p,1,2", 1, 5, "a number is missing"),
        ("p, 1e300 ,2,3", 4, 5, "`1e300` is too large"),
        ('p,"12,5",2,3', 3, 6, "`12,5` is no number"),
        ("p,12,5,2,3", 10, 1, "5 cells found, the list has 4 columns"),
        ('"p,1,2,3', 1, 8, "a quote is not closed in its line"),
        ("n" * 201 + ",1,2,3", 1, 201, "the name has 201 characters, allowed are 200"),
        ("n" * 10_001 + ",1,2,3", 1, 10_007, "the line has 10007 characters, allowed are 10000"),
    ],
)
def test_a_wrong_line_is_told_at_its_cell(line: str, column: int, length: int, said: str) -> None:
    (found,) = wrong(f"{HEAD}a,1,2,3\n{line}\nb,1,2,3\n")
    assert found.code == "P148"
    assert found.message.startswith(said)
    assert found.hint
    assert found.span is not None
    assert (found.span.line, found.span.column, found.span.end_column - found.span.column) == (
        4,
        column,
        length,
    )


@pytest.mark.parametrize(
    ("text", "line", "said"),
    [
        ("", 1, "the columns x, y, z are missing"),
        ("x,y\nmm,mm\n1,2\n", 1, "the column z is missing"),
        ("a,b,c\nmm,mm,mm\n1,2,3\n", 1, "`a` is no column of a list"),
        ("x,y,z,x\nmm,mm,mm,mm\n1,2,3,4\n", 1, "the column `x` stands twice"),
        ("x,y,z,pitch\nmm,mm,mm,deg\n1,2,3,4\n", 1, "the column roll is missing"),
        ("x,y,z,yaw\nmm,mm,mm,deg\n1,2,3,4\n", 1, "the columns pitch, roll are missing"),
        (
            "x,y,z\n1,2,3\n4,5,6\n",
            2,
            "the line below the titles gives no unit of `x`, allowed are mm, cm, m, inch",
        ),
        ("x,y,z\n,,\n1,2,3\n", 3, "the line below the titles gives no unit of `x`"),
        ("x [mm],y [feet],z [mm]\n1,2,3\n", 2, "`feet` is no unit of `y`"),
        ("x [mm],y,z [mm]\n1,2,3\n", 2, "`y` has no unit, others have one in their titles"),
        ("x [mm],y [mm],z [mm]\nmm,m,mm\n1,2,3\n", 2, "`y` is in `m` here and in `mm` by its title"),
        ("x,y,z\n", 2, "the line below the titles gives no unit of `x`"),
        ("x,y,z\nmm,mm,feet\n1,2,3\n", 2, "`feet` is no unit of `z`, allowed are mm, cm, m, inch"),
        ("x,y,z,pitch,roll\nmm,mm,mm,mm,deg\n", 2, "`mm` is no unit of `pitch`, allowed are deg, rad"),
    ],
)
def test_wrong_titles_and_units_make_no_list(text: str, line: int, said: str) -> None:
    found, findings = points_of(SourceText("points/l.csv", text), "l")
    assert found is None
    (one,) = findings
    assert one.message.startswith(said)
    assert one.span is not None
    assert one.span.line == line


def test_a_comma_and_a_point_in_one_number_are_refused() -> None:
    (found,) = wrong("x;y;z\nmm;mm;mm\n1.234,5;2;3\n")
    assert found.message == "`1.234,5` has a comma and a point"


def test_two_decimal_signs_in_one_list_are_refused() -> None:
    """A point among decimal commas may stand between thousands: 1.300 is 1300 there."""
    (found,) = wrong("x;y;z\nmm;mm;mm\n300,5;0;300\n1.300;5,5;300\n")
    assert found.message == "`1.300` has a `.`, numbers before it have a `,`"


def test_two_points_of_one_name_are_warned_about_and_the_first_one_has_it() -> None:
    found, findings = points_of(SourceText("points/l.csv", f"{HEAD}a,1,2,3\nb,1,2,3\na,4,5,6\n"), "l")
    assert [one.code for one in findings] == ["P162"]
    assert findings[0].message == "`a` is the name of the point in line 3, too"
    assert found is not None
    assert found.numbers == {"a": 1, "b": 2}
    assert len(found.points) == 3


def test_findings_of_a_list_end_with_their_number() -> None:
    findings = wrong(HEAD + "p,x,2,3\n" * 1000)
    assert len(findings) == 21
    assert findings[-1].message == "980 further lines are wrong"


def test_a_list_has_a_hundred_thousand_points_at_most() -> None:
    found, findings = points_of(SourceText("points/l.csv", "x,y,z\nmm,mm,mm\n" + "1,2,3\n" * 100_001), "l")
    assert found is not None
    assert len(found.points) == 100_000
    assert [(one.message, one.span.line if one.span else 0) for one in findings] == [
        ("a list has at most 100000 points", 100_003)
    ]


def test_reading_takes_work_in_proportion_to_the_list() -> None:
    texts = [SourceText("l", HEAD + "".join(f'"p{k}",{k},2,3\n' for k in range(n))) for n in (200, 400)]
    small, large = (steps_of(partial(points_of, text, "l")) for text in texts)
    assert large < 2.2 * small


def test_poses_are_those_of_the_same_numbers_in_a_program() -> None:
    titles = "x,y,z,pitch,roll,yaw\nmm,mm,mm,deg,deg,deg\n"
    listed = read(f"{titles}100,-200,300,80,10,20\n100,-200,300,30,5,\n100,-200,300,,,\n")
    table = point_table(listed)
    written = ("(100, -200, 300; pitch 80, roll 10, yaw 20)", "(100, -200, 300, 30, 5)", "(100, -200, 300)")
    text = "program t\nunits mm, deg, s\n" + "".join(
        f"lin {one}\nlin l[{k}]\n" for k, one in enumerate(written, 1)
    )
    program = compile(text, Environment(lists={"l": table})).icr
    assert program is not None
    targets = [one.target for one in icr.run_verified(program).moves]
    assert len(targets) == 6
    for one, other in zip(targets[::2], targets[1::2], strict=True):
        assert isinstance(one, Pose)
        assert isinstance(other, Pose)
        assert one.as_tuple() == other.as_tuple()


def test_a_list_that_is_written_is_read_back() -> None:
    points = read(
        "name,x,y,z,pitch,roll,yaw\n,mm,mm,mm,deg,deg,deg\na,1,2,3,4,5,6\nb,1,2,3,4,5,\nc,1,2,3,,,\n"
    ).points
    assert read(points_text(points)).points == points


def test_a_list_without_points_is_told() -> None:
    assert [one.message for one in wrong(HEAD)] == ["the list has no points"]


def test_utf_16_without_its_mark_is_read_in_both_orders(tmp_path: Path) -> None:
    for encoding in ("utf-16-le", "utf-16-be"):
        (tmp_path / "l.csv").write_bytes("x;y;z\nmm;mm;mm\n1,5;2;3\n".encode(encoding))
        found, findings = read_point_list(tmp_path / "l.csv")
        assert not findings
        assert found is not None
        assert len(found.points) == 1


def test_a_list_that_is_too_large_says_so_in_megabytes(tmp_path: Path) -> None:
    (tmp_path / "l.csv").write_bytes(b"x;y;z\nmm;mm;mm\n" + b"300;0;300\n" * 2_100_000)
    found, findings = read_point_list(tmp_path / "l.csv")
    assert found is None
    (one,) = findings
    assert one.message.endswith("l.csv` has 21 MB, allowed are 20 MB")
    assert one.hint == "cut it into several lists"


def test_a_point_without_numbers_is_no_line_of_units() -> None:
    found = wrong("name,x [mm],y [mm],z [mm]\nstart,,,\np,1,2,3\n")
    assert {one.span.line for one in found if one.span} == {2}
    assert all(one.is_error for one in found)
