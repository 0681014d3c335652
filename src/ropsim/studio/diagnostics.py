"""Diagnostics of the studio (U950 to U979)."""

from ropsim.core import RopsimError, Severity, define

NO_PROJECT = define(
    "U950",
    "nothing-to-open",
    Severity.ERROR,
    "the studio was started where there is no project",
    """
`ropsim studio` opens a project folder, which has a `cell.toml` and a folder `programs`; without a path it
opens the folder in which it runs. A project with mistakes in its files opens: the editor shows them.

`ropsim new my_cell` makes a project from an example, `ropsim studio my_cell` opens it.
""",
)

PORT_TAKEN = define(
    "U951",
    "port-taken",
    Severity.ERROR,
    "the port of the studio cannot be used",
    """
Another program, perhaps another studio, listens on that port, or the system does not allow it. Without
`--port`, or with `--port 0`, the studio takes the port that this project had the last time, or any free one
where that is taken.
""",
)

NO_PAGES = define(
    "U952",
    "pages-not-built",
    Severity.ERROR,
    "the pages of the studio are missing in this installation",
    """
The pages are built when ropsim is installed. They are missing where `ROPSIM_SKIP_FRONTEND=1` was set, or
where an installation from the source tree was interrupted. Install ropsim again, in the source tree with
`pip install .` or `make demo`.
""",
)

NOT_UNDERSTOOD = define(
    "U953",
    "message-not-understood",
    Severity.WARNING,
    "the page sent a message that the server does not know",
    """
Page and server speak the same version of one protocol. A page that was loaded before ropsim was updated may
not: reload it. Nothing was changed.
""",
)

READ_ONLY = define(
    "U954",
    "another-tab-edits",
    Severity.WARNING,
    "a change was refused because another tab has the right to edit",
    """
One tab at a time edits a project, so that two of them do not write over each other; the others follow.
`Take over` gives the right to this tab.
""",
)

WORKER_LOST = define(
    "U955",
    "worker-lost",
    Severity.ERROR,
    "a process of the studio has ended by itself and was started again",
    """
Simulating and drawing are done in processes of their own, so that a crash there takes no text and no page
with it. Most likely the memory ran out: a shorter program, or `--kinematic` runs, need less. If it happens
again with the same project, it is a fault of ropsim.
""",
)

CHANGED_ON_DISK = define(
    "U956",
    "changed-on-disk",
    Severity.WARNING,
    "a file has changed on the disk while it had unsaved text in the studio",
    """
Another program, such as an editor or git, has written or removed the file. Nothing was written over it.
`Reload` takes the text of the file and gives up the one in the studio, `Overwrite` does the opposite. Until
one of them is chosen the conflict stays, also when the studio ends and is started again. `Overwrite` is
refused once more where the file has changed again since it was shown.
""",
)

NOT_SAVED = define(
    "U957",
    "not-saved",
    Severity.ERROR,
    "a document could not be written to its file",
    """
The operating system refused to write, or the name cannot be that of a file of the project. The text is still
in the studio and in its journal; the file is as it was.
""",
)

NOT_EDITABLE = define(
    "U958",
    "not-editable",
    Severity.WARNING,
    "a document that the studio shows but does not change",
    """
Documents are texts in UTF-8 of at most 5 MB which belong to the project: `cell.toml`, the programs, the
tasks `kb/*.pl` and the robot files `robots/*.toml`. A file in another encoding is shown with `�` for what
cannot be read; convert it to UTF-8 first.
""",
)

NO_JOURNAL = define(
    "U959",
    "journal-not-written",
    Severity.WARNING,
    "unsaved text cannot be kept for the next start",
    """
Unsaved text is kept in a journal in the folder for application state of the user, which cannot be written
now: it may be read only or full. Save often. `ROPSIM_STATE_HOME` names another folder.
""",
)

TRUST_NOT_KEPT = define(
    "U960",
    "trust-not-kept",
    Severity.ERROR,
    "the trust in a folder could not be stored",
    """
Trusted folders are listed in the configuration folder of the user, which cannot be written now. Nothing
changed: what is code in the project stays inert. `ROPSIM_CONFIG_HOME` names another folder.
""",
)

PROJECT_GONE = define(
    "U965",
    "project-gone",
    Severity.ERROR,
    "the project folder has been removed or renamed while it was open",
    """
Another program has removed, moved or unmounted the folder. The texts of the project stay in the studio, as
unsaved ones, and in its journal. When the folder is back they are compared with its files; saving a text
makes the folder anew. Meshes and other files of the project are not in the studio and do not come back by
that.
""",
)

UNWATCHED = define(
    "U963",
    "project-not-watched",
    Severity.WARNING,
    "the files of the project cannot be read now",
    """
The operating system does not say what is in the project folder: it may not be read any more, or its disk does
not answer. The texts stay in the studio as they are. The studio tries again every second.
""",
)

INTERNAL = define(
    "U961",
    "studio-fault",
    Severity.ERROR,
    "the studio could not do what the page asked for, by a fault of its own",
    """
This is a bug in ropsim, not in your project. Texts are not touched by it; the studio goes on.
""",
)


class StudioError(RopsimError):
    """The studio cannot start; carries the finding."""
