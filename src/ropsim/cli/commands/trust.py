"""`ropsim trust`: let the code of a project folder run, or no more."""

import argparse
from pathlib import Path

from ropsim.cli.terminal.output import Output
from ropsim.userfiles import Trust, code_in, set_trust


def trust(options: argparse.Namespace, output: Output) -> int:
    """Trust a project folder or take that back, and return the exit code."""
    folder = Path(options.path)
    given = Trust.WITHHELD if options.revoke else Trust.GIVEN
    set_trust(folder, given)
    code = code_in(folder)
    words = "no longer trusted" if options.revoke else "trusted"
    listed = "its code:\n  " + "\n  ".join(code) if code else "there is no code in it"
    output.text(f"{folder} is {words}; {listed}")
    output.document({"ok": True, "trusted": given is Trust.GIVEN, "code": list(code)})
    return 0
