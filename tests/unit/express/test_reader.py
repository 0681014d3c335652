"""Schemas: what is declared is read, and what is not is told by its place."""

import pytest

from ropsim.core import SourceText
from ropsim.express import Schema, read_schema
from ropsim.express.declarations import Attribute
from ropsim.express.types import AggregateKind, AggregateType, NamedType, SimpleType

TEXT = """
(* Remarks stand (* in each other *). *)
SCHEMA shop; -- a tail remark
TYPE label = STRING; END_TYPE;
TYPE share = REAL; WHERE wr1 : {0.0 <= SELF <= 1.0}; END_TYPE;
TYPE colour = ENUMERATION OF (red, green); END_TYPE;
TYPE thing = SELECT (article, label); END_TYPE;
ENTITY article ABSTRACT SUPERTYPE OF (ONEOF (book, tool) ANDOR gift);
  name : label;
  price, weight : REAL;
UNIQUE
  ur1 : name;
WHERE
  wr1 : SELF.price >= 0.0;
END_ENTITY;
ENTITY book SUBTYPE OF (article);
  pages : LIST [1:?] OF UNIQUE INTEGER;
DERIVE
  SELF\\article.weight : REAL := 0.005 * SIZEOF(pages);
INVERSE
  orders : SET [0:2] OF order FOR what;
END_ENTITY;
ENTITY tool SUBTYPE OF (article); paint : OPTIONAL colour; END_ENTITY;
ENTITY gift SUBTYPE OF (article); END_ENTITY;
ENTITY order; what : article; END_ENTITY;
RULE few FOR (order);
WHERE
  wr1 : SIZEOF(QUERY(one <* order | one.what.price > 2.0 ** 3)) <= 1;
END_RULE;
END_SCHEMA;
"""


def schema(text: str = TEXT) -> Schema:
    made, findings = read_schema(SourceText("shop.exp", text))
    assert findings == ()
    assert made is not None
    return made


def test_declarations_are_read() -> None:
    made = schema()
    assert made.name == "shop"
    assert set(made.entities) == {"article", "book", "tool", "gift", "order"}
    assert made.entities["article"].abstract
    assert made.entities["article"].one_of == (("book", "tool"),)
    assert made.entities["book"].attributes == (
        Attribute("pages", AggregateType(AggregateKind.LIST, 1, None, SimpleType.INTEGER, True)),
    )
    assert made.entities["tool"].attributes == (Attribute("paint", NamedType("colour"), True),)
    assert made.items == {"red", "green"}


def test_parameters_are_those_of_the_supertypes_first_and_derived_ones_are_marked() -> None:
    parameters = schema().parameters["book"]
    assert [(one.attribute.name, one.derived) for one in parameters] == [
        ("name", False),
        ("price", False),
        ("weight", True),
        ("pages", False),
    ]


def test_a_supertype_that_is_met_twice_counts_once() -> None:
    text = (
        "SCHEMA s; ENTITY a; x : REAL; END_ENTITY; ENTITY b SUBTYPE OF (a); y : REAL; END_ENTITY;"
        "ENTITY c SUBTYPE OF (a); z : REAL; END_ENTITY; ENTITY d SUBTYPE OF (b, c); END_ENTITY; END_SCHEMA;"
    )
    assert schema(text).lineages["d"] == ("a", "b", "c", "d")
    assert [one.attribute.name for one in schema(text).parameters["d"]] == ["x", "y", "z"]


@pytest.mark.parametrize(
    ("old", "new", "code", "line"),
    [
        ("SCHEMA shop;", "SCHEMA shop", "X964", 4),
        ("SIZEOF(pages)", "LENGTH(pages)", "X964", 19),
        ("SIZEOF(pages)", "SIZEOF(pages, pages)", "X964", 19),
        ("[1:?]", "[one:?]", "X964", 17),
        ("END_SCHEMA;", "FUNCTION f; END_SCHEMA;", "X964", 30),
        ("END_SCHEMA;", "", "X964", 31),
        ("price >= 0.0", "price >= ;", "X964", 14),
        ("(article, label)", "(artcle, label)", "X965", 7),
        ("SUBTYPE OF (article); paint", "SUBTYPE OF (artikel); paint", "X965", 23),
        ("FOR (order)", "FOR (orders)", "X965", 26),
        ("one.what", "on.what", "X965", 26),
        ("ur1 : name", "ur1 : nam", "X965", 8),
        ("ENTITY order;", "ENTITY book;", "X965", 25),
        ("ENTITY order;", "ENTITY order SUBTYPE OF (order);", "X965", 25),
    ],
)
def test_mistakes_are_told_by_their_place(old: str, new: str, code: str, line: int) -> None:
    assert old in TEXT
    made, findings = read_schema(SourceText("shop.exp", TEXT.replace(old, new)))
    assert made is None
    assert findings[0].span
    assert (findings[0].code, findings[0].span.line) == (code, line)


@pytest.mark.parametrize("part", ["(", "-(", "SELF[", "SELF.a", " + 1", "SIZEOF("])
def test_depth_is_bounded(part: str) -> None:
    text = f"SCHEMA s; TYPE t = REAL; WHERE w : {part * 20_000}"
    assert [one.code for one in read_schema(SourceText("s.exp", text))[1]] == ["X964"]
