"""The lock file of the pages: no registry in it, all platforms, licences that may be passed on."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

FRONTEND = Path(__file__).parents[2] / "frontend"
LICENCES = {"MIT", "ISC", "BSD-2-Clause"}
"""Of what the pages carry; tools that only build them may have others."""

pytestmark = pytest.mark.skipif(not FRONTEND.is_dir(), reason="an sdist has no sources of pages")


def packages() -> Mapping[str, dict[str, Any]]:
    """Return the entries of the lock file by name, without our own."""
    lock = json.loads((FRONTEND / "package-lock.json").read_text("utf-8"))
    return {path.rpartition("node_modules/")[2]: entry for path, entry in lock["packages"].items() if path}


def addresses(value: object, inside: str = "") -> set[str]:
    """Return the keys under which a value holds web addresses."""
    match value:
        case dict():
            return {key for name, one in value.items() for key in addresses(one, inside or name)}
        case list():
            return {key for one in value for key in addresses(one, inside)}
        case str() if "://" in value:
            return {inside}
        case _:
            return set()


def test_the_lock_file_names_no_registry() -> None:
    assert {key for entry in packages().values() for key in addresses(entry)} <= {"funding"}
    assert [name for name, entry in packages().items() if "resolved" in entry] == []


def test_every_package_is_pinned_by_its_content() -> None:
    assert [name for name, entry in packages().items() if not entry["integrity"].startswith("sha512-")] == []


def test_the_lock_file_serves_every_platform() -> None:
    locked = packages()
    absent = {
        one for entry in locked.values() for one in entry.get("optionalDependencies", {}) if one not in locked
    }
    assert absent == set()


def test_what_the_pages_carry_may_be_passed_on() -> None:
    carried = {name: entry["license"] for name, entry in packages().items() if not entry.get("dev")}
    assert carried
    assert {name: one for name, one in carried.items() if one not in LICENCES} == {}
