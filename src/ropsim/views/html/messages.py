"""The messages of the program in the HTML report."""

from collections.abc import Sequence

from ropsim.core import plural
from ropsim.views.figures import seconds
from ropsim.views.markup import table, text
from ropsim.views.messages import Message

SHOWN_MESSAGES = 500


def messages_section(told: Sequence[Message]) -> str:
    """Return what `print` showed; empty where it showed nothing."""
    if not told:
        return ""
    rows = [
        (seconds(one.time), text(one.place), str(one.visit or ""), text(one.text))
        for one in told[:SHOWN_MESSAGES]
    ]
    more = len(told) - len(rows)
    rest = f"<p>… and {plural(more, 'more message')}.</p>" if more > 0 else ""
    listed = table("What <code>print</code> showed.", ("at t [s]", "line", "pass", "text"), rows, "words")
    return f"<section><h2>Messages</h2>\n{listed}{rest}</section>\n"
