"""Both Prologs: the one of the package always, the command `swipl` where this machine has it."""

import shutil

import pytest

from ropsim.prolog import Prolog
from ropsim.prolog.native.program import COMMAND


@pytest.fixture(scope="module", params=list(Prolog), ids=lambda one: one.value)
def prolog(request: pytest.FixtureRequest) -> Prolog:
    """Return each Prolog in turn: what is said of one holds for the other."""
    one: Prolog = request.param
    if one is Prolog.NATIVE and shutil.which(COMMAND) is None:
        pytest.skip(f"no command `{COMMAND}`: apt-get install swi-prolog-nox")
    return one
