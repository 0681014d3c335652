"""Diagnostics of text files that are to be read (X840 to X842)."""

from ropsim.core import Severity, define

MISSING_PATH = define(
    "X840",
    "missing-path",
    Severity.ERROR,
    "a file or folder that is not there",
    """
The path that was given does not exist. Paths are taken relative to the folder in which the command runs.
""",
)

UNREADABLE = define(
    "X841",
    "unreadable-file",
    Severity.ERROR,
    "a file that cannot be read as text",
    """
Programs and cell files are text in UTF-8. This file cannot be opened, or holds bytes that are no UTF-8: it
may be a binary file, or be saved in another encoding. Save it as UTF-8.
""",
)

TOO_LARGE = define(
    "X842",
    "file-too-large",
    Severity.ERROR,
    "a file beyond what a program can be",
    """
Task files are read up to 5 MB, about a hundred thousand lines. A larger file is most likely no program.
""",
)
