"""Which project folders may run code of their own: a list of the user, kept outside of the projects."""

import json
from enum import Enum
from pathlib import Path

from ropsim.core import Diagnostic, configuration_folder, read_own_bytes, replace_private_file
from ropsim.userfiles.code_files import code_in
from ropsim.userfiles.diagnostics import INERT, NOT_A_FOLDER, NOT_KEPT, TrustError

VERSION = 1
_NAME = "trust.json"
"""Of the list in the configuration folder."""


class Trust(Enum):
    """Whether code in a project folder may run."""

    GIVEN = "given"
    WITHHELD = "withheld"


def trust_in(folder: Path) -> Trust:
    """Return whether the user trusts a project folder; the folder itself has no say in it."""
    return Trust.GIVEN if str(folder.resolve()) in _trusted() else Trust.WITHHELD


def set_trust(folder: Path, trust: Trust) -> None:
    """Trust a project folder, or do so no more.

    Raises:
        TrustError: X892, it is no project folder; X891, the list cannot be written.
    """
    if trust is Trust.GIVEN and not (folder / "cell.toml").is_file():
        message = f"`{folder}` is no project folder: it has no `cell.toml`"
        raise TrustError(NOT_A_FOLDER.at(None, message, hint="give the folder of a project"))
    before, this = _trusted(), {str(folder.resolve())}
    folders = before | this if trust is Trust.GIVEN else before - this
    if folders == before:
        return
    document = {"version": VERSION, "folders": sorted(folders)}
    try:
        replace_private_file(_place(), json.dumps(document, indent=2).encode())
    except OSError as error:
        message = f"`{_NAME}` cannot be written: {error.strerror or error}"
        raise TrustError(NOT_KEPT.at(None, message, hint="nothing has changed")) from error


def inert_code(folder: Path) -> tuple[Diagnostic, ...]:
    """Return a finding that names the code of a project that is not trusted, if it has any."""
    code = code_in(folder)
    if not code or trust_in(folder) is Trust.GIVEN:
        return ()
    named = ", ".join(f"`{name}`" for name in code[:3]) + (", …" if len(code) > 3 else "")
    message = f"{named} {'is' if len(code) == 1 else 'are'} code and stays inert: the folder is not trusted"
    hint = "`ropsim trust PATH` lets it run, if you know where it comes from"
    return (INERT.at(None, message, hint=hint, data={"files": list(code)}),)


def _place() -> Path:
    return configuration_folder() / _NAME


def _trusted() -> frozenset[str]:
    """Return the trusted folders; none where others can write the list, or it is absent, damaged or newer."""
    try:
        document = json.loads(read_own_bytes(_place()))
    except (OSError, ValueError, RecursionError):
        return frozenset()
    if not isinstance(document, dict) or document.get("version") != VERSION:
        return frozenset()
    folders = document.get("folders")
    return (
        frozenset(one for one in folders if isinstance(one, str))
        if isinstance(folders, list)
        else frozenset()
    )
