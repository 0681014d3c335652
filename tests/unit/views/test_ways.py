"""Collisions and the least distance of a run, in words."""

from dataclasses import replace

from ropsim.flow import BodyPair, Clearance, Contact, Recording, WayFacts
from ropsim.views import Style, html_report, summarize, terminal_report
from support.recordings import facts, pick_and_place, station

NEAR = Clearance("box", "tool:jaws", 0.00842, 2.5, "robot", 7)
DEEP = Contact(
    "tool:jaws", "pallet", 2.25, 2.75, -0.0131, 2.5, (0.1, 0.2, 0.3), "jaws – pallet", "robot", 7, 4
)


def checked(ways: WayFacts) -> Recording:
    return replace(
        pick_and_place(1),
        facts=facts(checked=("collisions", "rated payload"), ways=ways, stations=(station(origins=()),)),
    )


def lines(ways: WayFacts) -> list[str]:
    return terminal_report(summarize(checked(ways)), Style.PLAIN).splitlines()


def page(ways: WayFacts) -> str:
    recording = checked(ways)
    return html_report(recording, summarize(recording), {})


def test_the_least_distance_stands_with_bodies_time_and_line() -> None:
    found = lines(WayFacts(NEAR))
    at = found.index("nearest      8.4 mm: box – jaws")
    assert found[at + 1] == "             at t = 2.50 s, line 7"


def test_a_penetration_has_a_depth() -> None:
    assert "collision    0.6 mm deep: box – jaws" in lines(WayFacts(replace(NEAR, distance=-6e-4)))


def test_bodies_at_no_distance_touch() -> None:
    assert "nearest      0.0 mm, touching: box – jaws" in lines(WayFacts(replace(NEAR, distance=0.0)))


def test_a_run_in_which_nothing_is_known_of_anything_says_so() -> None:
    found = lines(WayFacts(unseen=("hose",), met=(BodyPair("foot", "table"),)))
    at = found.index("nearest      no body with a known shape is beside the robot")
    assert found[at + 1] == "             no shape is known of hose"
    assert " ".join(line.strip() for line in found[at + 2 : at + 4]).startswith(
        "not checked, in each other at the start or drawn so: foot and table"
    )


def test_what_is_not_checked_stands_in_the_line_below_the_verdict() -> None:
    def left(ways: WayFacts) -> str:
        return summarize(checked(ways)).unchecked.text

    assert left(WayFacts(NEAR)) == ""
    assert left(WayFacts(NEAR, ("hose",))) == "not checked: collisions of hose without a known shape"
    assert left(WayFacts(NEAR, ("hose", "cable"), (BodyPair("foot", "table"),))) == (
        "not checked: collisions of 2 bodies without a known shape, "
        "collisions of 1 pair in each other at the start"
    )


def test_names_are_text_in_the_page() -> None:
    found = page(WayFacts(replace(NEAR, one="<b>")))
    assert "&lt;b&gt; – jaws" in found
    assert "<td>8.4 mm</td>" in found


def test_the_page_lists_contacts_from_begin_to_end() -> None:
    found = page(WayFacts(NEAR, contacts=(DEEP,)))
    row = "".join(f"<td>{cell}</td>" for cell in ("13.1 mm", "2.25", "2.75", "2.50", "7", "4"))
    assert "jaws – pallet</td>" in found or "jaws – pallet</th>" in found
    assert row in found.replace("\n", "").replace("> <", "><"), found[found.index("Collisions.") :][:900]


def test_a_long_list_of_contacts_is_cut_and_counted() -> None:
    found = page(WayFacts(NEAR, contacts=(DEEP,) * 130))
    assert found.count("13.1 mm") == 100
    assert "And 30 contacts more." in found
