import json

from ropsim.core import Diagnostic, Label, Severity, Span, TextEdit
from ropsim.records import diagnostic_document

SPAN = Span("a.task", 3, 4, 3, 9)

FULL = Diagnostic(
    "M502",
    "joint-out-of-range",
    Severity.ERROR,
    "message",
    SPAN,
    "label",
    (Label(SPAN, "second"),),
    ("note",),
    "hint",
    TextEdit(SPAN, "new"),
    {"limit_rad": float("nan"), "passes": (1, 2)},
)


def test_document_has_the_documented_form() -> None:
    span = {"source": "a.task", "line": 3, "column": 4, "end_line": 3, "end_column": 9}
    assert diagnostic_document([FULL]) == {
        "schema": "ropsim-diagnostics",
        "version": 1,
        "counts": {"errors": 1, "warnings": 0, "hints": 0},
        "diagnostics": [
            {
                "code": "M502",
                "slug": "joint-out-of-range",
                "severity": "error",
                "category": "other",
                "message": "message",
                "span": span,
                "label": "label",
                "secondary": [{"span": span, "text": "second"}],
                "notes": ["note"],
                "hint": "hint",
                "fix": {"span": span, "replacement": "new"},
                "data": {"limit_rad": "NaN", "passes": [1, 2]},
            }
        ],
    }


def test_document_without_place_and_fix_has_nothing_there() -> None:
    plain = diagnostic_document([Diagnostic("S701", "x", Severity.HINT, "m")])
    entry = json.loads(json.dumps(plain))["diagnostics"][0]
    assert entry["span"] is None
    assert entry["fix"] is None


def test_document_is_strict_json_for_any_data() -> None:
    odd = Diagnostic(
        "S701", "x", Severity.HINT, "m", data={"inf": float("inf"), "object": object(), "enum": Severity.HINT}
    )
    text = json.dumps(diagnostic_document([odd]), allow_nan=False)
    data = json.loads(text)["diagnostics"][0]["data"]
    assert data["inf"] == "Infinity"
    assert data["enum"] == "hint"
