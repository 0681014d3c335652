"""Diagnostics of trust and of journals (X890 to X899)."""

from ropsim.core import RopsimError, Severity, define

INERT = define(
    "X890",
    "code-stays-inert",
    Severity.HINT,
    "a project holds code, which is not run",
    """
A project folder is data: opening, compiling, simulating and viewing it runs no code that lies in it.
Controllers in Python, FMUs (which are native code) and knowledge bases for the native Prolog engine stay
inert until you trust the folder, because such code can do whatever you can do.

If you know where the project comes from, `ropsim trust PATH` lets its code run, `ropsim trust PATH
--revoke` takes that back. Trust is kept in your own configuration, never in the project.
""",
)

NOT_KEPT = define(
    "X891",
    "trust-not-stored",
    Severity.ERROR,
    "the list of trusted folders cannot be written",
    """
Trusted folders are listed in the configuration folder of the user (`ROPSIM_CONFIG_HOME` names another one).
It cannot be written now, so nothing has changed.
""",
)

NOT_A_FOLDER = define(
    "X892",
    "no-folder-to-trust",
    Severity.ERROR,
    "trust can be given to project folders only",
    """
`ropsim trust PATH` takes the folder of a project, one that has a `cell.toml`. Trust in a folder holds for
what is in it and for nothing above or beside it.
""",
)

DAMAGED_JOURNAL = define(
    "X893",
    "damaged-journal",
    Severity.WARNING,
    "unsaved texts of an earlier session cannot be read",
    """
The journal keeps unsaved texts of the studio until they are saved. The file is damaged or was written by a
newer ropsim. It was set aside under the name that the message tells, and may be looked at with a text
editor.
""",
)


class TrustError(RopsimError):
    """Trust cannot be given or taken; carries the finding."""
