"""Exchange files: every kind of parameter is read, and every mistake has its place."""

import pytest

from ropsim.core import SourceText
from ropsim.part21 import (
    Absent,
    Binary,
    Enumeration,
    ExchangeFile,
    Record,
    Reference,
    Typed,
    Value,
    read_exchange,
    references,
)

HEAD = (
    "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('n','',(''),(''),'','','');\n"
    "FILE_SCHEMA(('A_V1 { 1 0 }'));\nENDSEC;\nDATA;\n"
)
TAIL = "ENDSEC;\nEND-ISO-10303-21;\n"
FIRST = HEAD.count("\n") + 1


def read(body: str) -> ExchangeFile:
    file, findings = read_exchange(SourceText("a.stp", HEAD + body + TAIL))
    assert findings == ()
    return file


def told(text: str) -> list[tuple[str, int, int]]:
    """Return code, line and column of each finding."""
    _, findings = read_exchange(SourceText("a.stp", text))
    return [(one.code, one.span.line, one.span.column) for one in findings if one.span]


def test_every_kind_of_parameter_is_read() -> None:
    file = read("#7 = ALL(1,-2.5E-3,'a',$,*,.METRE.,\"0FF\",#7,(1,(2.,())),LENGTH_MEASURE(3.));\n")
    assert file.instances[0].records[0].values == (
        *(1, -2.5e-3, "a", Absent.UNSET, Absent.DERIVED, Enumeration("METRE"), Binary("0FF"), Reference(7)),
        (1, (2.0, ())),
        Typed("LENGTH_MEASURE", 3.0),
    )


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("(1.,-2.5E-3 ,\n+0.5)", (1.0, -2.5e-3, 0.5)),
        ("( #7, #7,\r\n#1 )", (Reference(7), Reference(7), Reference(1))),
        ("(1.,/* two */2.)", (1.0, 2.0)),
        ("(1.,2)", (1.0, 2)),
        ("(1.,#7)", (1.0, Reference(7))),
        ("(1000000000000000000000000.,1.E300)", (1e24, 1e300)),
        ("((1.,2.),(#7),())", ((1.0, 2.0), (Reference(7),), ())),
    ],
)
def test_lists_of_one_kind_are_read_like_others(written: str, meant: Value) -> None:
    file = read(f"#7=A({written},'behind');\n#1=B();\n")
    assert file.instances[0].records == (Record("A", (meant, "behind")),)


def test_a_complex_instance_has_a_record_for_each_entity() -> None:
    file = read("#1=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n")
    assert [record.keyword for record in file.instances[0].records] == [
        "LENGTH_UNIT",
        "NAMED_UNIT",
        "SI_UNIT",
    ]
    assert file.instances[0].keyword == "LENGTH_UNIT+NAMED_UNIT+SI_UNIT"


def test_names_of_schemas_come_without_their_identifiers() -> None:
    assert read("").schemas == ("A_V1",)


def test_comments_and_line_ends_stand_anywhere() -> None:
    file = read("/* #1=B(); */ #1 /* ' */ = A /* ; */ ( 1 ,\r\n /**/ 'x\ny' ) ;\n")
    assert file.instances[0].records == (Record("A", (1, "xy")),)


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("it''s", "it's"),
        (r"a\\b", r"a\b"),
        (r"\X2\00E903B1\X0\!", "éα!"),
        (r"\X4\0001F916\X0\ ", "🤖 "),
        (r"\X\E9", "é"),
        (r"\S\i", "é"),
        (r"\PB\\S\1 \PA\\S\1", "ą ±"),
        (r"\PE\\S\P", "а"),
        (r"a\N\b\T\c", "abc"),
    ],
)
def test_strings_stand_for_characters(written: str, meant: str) -> None:
    assert read(f"#1=A('{written}');\n").instances[0].records[0].values == (meant,)


@pytest.mark.parametrize(
    ("body", "code", "column"),
    [
        ("#1=A(1;", "X960", 7),
        ("#1=A(.5);", "X960", 6),
        ("#1=A(1E5);", "X960", 7),
        ("#1=A(1.E999);", "X960", 6),
        ("#1=A(" + "9" * 41 + ");", "X960", 6),
        ("#1=A(#123456789012345678901);", "X960", 6),
        (r"#1=A('ab\Xq');", "X960", 9),
        (r"#1=A('\X2\D800\X0\');", "X960", 7),
        (r"#1=A('\X4\00110000\X0\');", "X960", 7),
        ("#1=A(,1);", "X960", 6),
        ("#1=A(1,);", "X960", 8),
        ("#1 A();", "X960", 4),
        ("1=A();", "X960", 1),
        ("#1=(A()B();", "X960", 11),
        ("#1=A((" + "(" * 40 + "));", "X960", 6 + 33),
        ("#1=A();#1=B();", "X961", 8),
        ("#1=A((3,#2));", "X962", 6),
        ("#1=A((1.,1.E999));", "X960", 10),
        ("#1=A((#1,#12345678901234567890));", "X960", 10),
        ("ENDSEC;DATA;", "X963", 8),
        ("#1=A(é);", "X960", 6),
    ],
)
def test_every_mistake_has_its_place(body: str, code: str, column: int) -> None:
    assert told(HEAD + body + TAIL)[0] == (code, FIRST, column)


def test_reading_goes_on_behind_a_damaged_instance() -> None:
    body = "#1=A(!);\n#2=B(';');\n#3=C(?, /* ; */ ';');\n#4=D();\n"
    file, findings = read_exchange(SourceText("a.stp", HEAD + body + TAIL))
    assert [one.code for one in findings] == ["X960", "X960"]
    assert [instance.number for instance in file.instances] == [2, 4]


def test_no_more_than_twenty_mistakes_are_told() -> None:
    assert len(told(HEAD + "#1=A(?);\n" * 100 + TAIL)) == 20
    assert len(told(HEAD + "#1=A(" + "#2," * 100 + "#2);\n" + TAIL)) == 20
    assert len(told(HEAD + "#1=A();\n" * 100 + TAIL)) == 20


@pytest.mark.parametrize(
    "text",
    [
        "",
        "solid ascii",
        HEAD,
        HEAD + "ENDSEC;",
        HEAD + "#1=A(';",
        HEAD + "#1=A(/*;",
        HEAD + TAIL + "more",
        "ISO-10303-21;HEADER;FILE_NAME('');ENDSEC;DATA;ENDSEC;END-ISO-10303-21;",
    ],
)
def test_what_is_no_exchange_file_is_told(text: str) -> None:
    assert told(text)[0][0] == "X960"


def test_more_than_is_read_is_told() -> None:
    assert told(" " * 4_000_001)[0][0] == "X963"


def test_references_stand_in_lists_and_typed_values() -> None:
    file = read("#1=A(#1,(#2,(#1)),T(#2));\n#2=B();\n")
    assert tuple(references(file.instances[0].records[0].values)) == (1, 2, 1, 2)
