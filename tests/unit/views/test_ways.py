"""What was seen on the ways of a run, in words."""

from dataclasses import replace

from ropsim.flow import BodyPair, Clearance, Recording, WayFacts
from ropsim.views import Style, html_report, summarize, terminal_report
from support.recordings import facts, pick_and_place, station

NEAR = Clearance("box", "tool:jaws", 0.00842, 2.5, "robot", 7)


def looked_at(ways: WayFacts) -> Recording:
    return replace(
        pick_and_place(1),
        facts=facts(checked=("collisions", "rated payload"), ways=ways, stations=(station(origins=()),)),
    )


def lines(ways: WayFacts) -> list[str]:
    return terminal_report(summarize(looked_at(ways)), Style.PLAIN).splitlines()


def test_the_least_distance_is_told_with_bodies_time_and_line() -> None:
    found = lines(WayFacts(NEAR))
    at = found.index("nearest      8.4 mm: box and tool:jaws")
    assert found[at + 1] == "             at t = 2.50 s, line 7"


def test_bodies_in_each_other_have_a_depth() -> None:
    assert "nearest      0.6 mm in each other: box and tool:jaws" in lines(
        WayFacts(replace(NEAR, distance=-6e-4))
    )


def test_a_run_in_which_nothing_is_known_of_anything_says_so() -> None:
    found = lines(WayFacts(unseen=("hose",), met=(BodyPair("foot", "table"),)))
    at = found.index("nearest      nothing moved against anything of a known shape")
    assert found[at + 1] == "             no shape is known of hose"
    assert " ".join(line.strip() for line in found[at + 2 : at + 4]).startswith(
        "not looked at, since they are in each other at the start or drawn so: foot and table"
    )


def test_what_was_not_seen_stands_behind_not_checked() -> None:
    def left(ways: WayFacts) -> str:
        return summarize(looked_at(ways)).unchecked.text

    assert left(WayFacts(NEAR)) == ""
    assert left(WayFacts(NEAR, ("hose",))) == "not checked: collisions of hose without a known shape"
    assert left(WayFacts(NEAR, ("hose", "cable"), (BodyPair("foot", "table"),))) == (
        "not checked: collisions of 2 bodies without a known shape, "
        "collisions of 1 pair in each other at the start"
    )


def test_names_are_text_in_the_page() -> None:
    recording = looked_at(WayFacts(replace(NEAR, one="<b>")))
    page = html_report(recording, summarize(recording), {})
    assert "&lt;b&gt; and tool:jaws" in page
    assert "<td>8.4 mm</td>" in page
