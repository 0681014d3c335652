"""Findings on contacts: one for two bodies, a station and a line, with its passes."""

from dataclasses import replace

from ropsim.flow import Contact, RunFacts, StationFacts, WayFacts
from ropsim.simulation import contact_findings

HIT = Contact(
    "tool:jaws", "pallet", 1.0, 1.2, -0.002, 1.1, (0.1, 0.2, 0.3), "jaws – pallet", "left", 7, visit=1
)
LEFT, RIGHT = StationFacts("left", source="left.task"), StationFacts("right", source="right.task")


def facts(*contacts: Contact, stations: tuple[StationFacts, ...] = (LEFT, RIGHT)) -> RunFacts:
    return RunFacts(stations=stations, ways=WayFacts(contacts=contacts))


def test_contacts_of_one_pass_are_one_pass_however_many_they_are() -> None:
    again = replace(HIT, begin=1.4, end=1.5, time=1.45, distance=-0.004)
    (one,) = contact_findings(facts(HIT, again))
    assert one.message == "collision jaws – pallet, 4.0 mm deep, line 7"
    assert one.label == "worst at t = 1.45 s"
    (two,) = contact_findings(facts(HIT, again, replace(HIT, begin=9.0, visit=2)))
    assert two.message == "collision jaws – pallet, 4.0 mm deep, line 7 (2 passes)"
    assert two.data["passes"] == (1, 2)


def test_the_same_line_of_two_stations_is_two_findings_each_in_its_own_text() -> None:
    found = contact_findings(facts(HIT, replace(HIT, station="right")))
    assert [one.span.source for one in found if one.span] == ["left.task", "right.task"]
    assert [one.notes for one in found] == [(), ()]


def test_where_two_stations_run_one_text_the_finding_names_its_station() -> None:
    shared = replace(RIGHT, source="left.task")
    (found,) = contact_findings(facts(HIT, stations=(LEFT, shared)))
    assert found.notes == ("at station `left`",)
