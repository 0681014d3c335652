"""The form of a program as edits: applied, they give what `ropsim fmt` writes."""

import pytest

from ropsim.language import formatted
from support.editors import Editor

URI = "file:///nowhere-at-all/x.task"
PLAIN = "program p\nunits mm\nmov home\n"


def after(text: str) -> tuple[str, int]:
    """Return a text with the edits that the server offers, and how many they are."""
    editor = Editor()
    editor.open(URI, text)
    edits = editor.ask(
        "textDocument/formatting", textDocument={"uri": URI}, options={"tabSize": 2, "insertSpaces": True}
    )
    for edit in reversed(edits):
        change = {"range": edit["range"], "text": edit["newText"]}
        document = {"uri": URI, "version": 2}
        editor.tell("textDocument/didChange", textDocument=document, contentChanges=[change])
    return editor.state.documents[URI].text, len(edits)


@pytest.mark.parametrize(
    "text",
    [
        "program p\nunits mm\nif true\nmov home\n   endif\n",
        "program p\n\n\n\n\nunits mm\nx=1\nprint x\n\n\n",
        "program p\r\nx   =  1+2\r\nprint x",
        "\n\nmov   home",
        "x = (1,\n     2, 3)\nmov x # 😀  here\nfrobnicate   it\n",
        "\x0b\x0c\u2028\nmov home\x85\n",
        "",
    ],
)
def test_the_edits_give_the_form(text: str) -> None:
    assert after(text)[0] == formatted(text)


def test_a_program_in_its_form_is_left_alone() -> None:
    assert after(PLAIN) == (PLAIN, 0)


def test_lines_that_have_their_form_are_in_no_edit() -> None:
    text = PLAIN.replace("units mm", "units   mm") + "\n\n\nmov home\n"
    assert after(text) == (PLAIN + "\nmov home\n", 3)
