"""State of a reader of a valid file: its instances, the ones already taken, and findings."""

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TypeVar

from ropsim.core import Diagnostic, Kind
from ropsim.express import Population, Schema
from ropsim.nirox.building import Key
from ropsim.nirox.readers.attributes import Attributes, ImpossibleError
from ropsim.part21 import ExchangeFile, Instance

T = TypeVar("T")
MOST = 50
"""Maximum number of errors of one file that are reported, and of other findings."""


class Seen(Attributes):
    """The instances of one file while it is read.

    Attributes:
        unknown: keywords of the entities that the schema does not have, in the order of the file.
        instances: all of the file, by number.
        keys: keys of taken instances, as in `Building`.
        taken: numbers of taken instances, with a key or without.
        findings: so far.
    """

    def __init__(self, schema: Schema, file: ExchangeFile) -> None:
        unknown = [
            (instance.number, record.keyword)
            for instance in file.instances
            for record in instance.records
            if record.keyword.lower() not in schema.entities
        ]
        strange = {number for number, _ in unknown}
        known = tuple(one for one in file.instances if one.number not in strange)
        super().__init__(Population(schema, replace(file, instances=known)))
        self.unknown = tuple(dict.fromkeys(keyword for _, keyword in unknown))
        self.instances: Mapping[int, Instance] = {one.number: one for one in file.instances}
        self.keys: dict[int, Key] = {}
        self.taken: set[int] = set()
        self.findings: list[Diagnostic] = []
        self._counts: Counter[bool] = Counter()

    @property
    def is_refused(self) -> bool:
        """Return whether an error has been found."""
        return self._counts[True] > 0

    def take(self, number: int, *key: str | int | float) -> None:
        """Note that an instance is held by the model, and under which key."""
        self.taken.add(number)
        if key:
            self.keys.setdefault(number, key)

    def attempt(self, read: Callable[[], T], otherwise: T) -> T:
        """Return the result of a reader; if it fails, note the error and return the alternative."""
        try:
            return read()
        except ImpossibleError as error:
            self.add(error.finding)
            return otherwise

    def note(self, kind: Kind, number: int | None, message: str, hint: str = "") -> None:
        """Note a finding at an instance."""
        self.add(self.finding(kind, number, message, hint))

    def add(self, finding: Diagnostic) -> None:
        """Note a finding, as long as there is room; errors have a room of their own."""
        self._counts[finding.is_error] += 1
        if self._counts[finding.is_error] <= MOST:
            self.findings.append(finding)
