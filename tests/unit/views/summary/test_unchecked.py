from dataclasses import replace

import pytest

from ropsim.core import SourceText
from ropsim.flow import (
    Fidelity,
    InputChange,
    OverrideChange,
    Recording,
)
from ropsim.motion import ZONE_CLIPPED, ZONE_STOPS
from ropsim.views import Style, html_report, result_figures, summarize, terminal_report
from ropsim.views.testing import SHORT, ByHand, by_hand, given_text
from support.recordings import SOURCE, estimates, facts, pick_and_place, station


def line_of(recording: Recording) -> str:
    return summarize(recording).unchecked.text


def with_facts(
    *estimated: str, checked: tuple[str, ...] = (), fidelity: Fidelity = Fidelity.DYNAMIC
) -> Recording:
    """Return a run that has looked at these things with an arm of which these parameters are estimates."""
    about = facts(checked=checked, fidelity=fidelity, stations=(station(origins=estimates(*estimated)),))
    return replace(pick_and_place(1), facts=about)


def zoned(*places: tuple[int, float], source: SourceText = SOURCE) -> Recording:
    """Return a run that finds zones not flown on these lines [m]; 0 for a via point that is not passed by."""
    findings = [ZONE_STOPS.at(source.span(line, 1, 1), "", data={"zone_m": zone}) for line, zone in places]
    return replace(pick_and_place(1), findings=tuple(findings))


def test_a_run_that_does_not_say_so_has_not_looked_at_collisions() -> None:
    assert line_of(with_facts()) == "not checked: collisions, rated payload"


def test_what_a_run_has_looked_at_is_not_called_unchecked() -> None:
    text = line_of(with_facts(fidelity=Fidelity.KINEMATIC, checked=("collisions", "rated payload")))
    assert text == "not checked: torques, drives, servo"


def test_a_run_that_leaves_nothing_open_has_no_such_line() -> None:
    recording = with_facts(checked=("collisions", "rated payload"))
    assert line_of(recording) == ""
    page = html_report(recording, summarize(recording), {})
    assert 'class="unchecked"' not in page
    assert "not checked" not in terminal_report(summarize(recording), Style.PLAIN)


def test_estimates_are_told_where_everything_was_looked_at() -> None:
    text = line_of(with_facts("motor constants", checked=("collisions", "rated payload")))
    assert text == "estimated: motor constants"


def test_a_kinematic_run_has_not_looked_at_torques_drives_and_servo() -> None:
    text = line_of(with_facts(fidelity=Fidelity.KINEMATIC))
    assert text == "not checked: collisions, rated payload, torques, drives, servo"


def test_few_estimates_are_named() -> None:
    text = line_of(with_facts("motor constants"))
    assert text.endswith(" · estimated: motor constants")


def test_many_estimates_are_counted_so_that_the_line_stays_one() -> None:
    names = [f"parameters of kind {k}" for k in range(9)]
    text = line_of(with_facts(*names))
    assert text.endswith(" · estimated: 9 groups of parameters")
    assert len(", ".join(names)) > SHORT


def test_of_many_estimates_those_with_an_accuracy_are_named_and_the_others_counted() -> None:
    """How far torques and lags may be off is said in the line of the verdict, not hidden in a number."""
    names = ["home position", "masses (loads ±12 %)", "shapes", "torque limits (×1.7)", "friction (×3)"]
    text = line_of(with_facts(*names))
    named = "masses (loads ±12 %), torque limits (×1.7), friction (×3)"
    assert text.endswith(f" · estimated: {named}, 2 other groups of parameters")
    text = line_of(with_facts("masses (loads ±12 %)", "torque limits (×1.7)", "friction (×3)"))
    assert text.endswith(" · estimated: masses (loads ±12 %), torque limits (×1.7), friction (×3)")


def test_each_line_with_a_zone_counts_once_and_lines_without_do_not() -> None:
    assert summarize(zoned((3, 0.05), (3, 0.05), (7, 0.01), (9, 0.0))).unchecked.fine_stops == (3, 7)
    assert line_of(zoned((3, 0.05))).endswith("zones not flown (fine stop) on 1 line")
    assert "zones" not in line_of(zoned((9, 0.0)))


def test_lines_of_two_texts_with_one_number_are_two() -> None:
    program, tasks = (zoned((3, 0.05), source=one) for one in (SOURCE, SourceText("kb/tasks.pl", "\n\nx")))
    both = replace(program, findings=(*program.findings, *tasks.findings))
    assert line_of(both).endswith("zones not flown (fine stop) on 2 lines")


def test_a_zone_of_which_less_is_flown_is_no_stop() -> None:
    clipped = ZONE_CLIPPED.at(SOURCE.span(3, 1, 1), "", data={"zone_m": 0.05, "flown_m": 0.01})
    assert "zones" not in line_of(replace(pick_and_place(1), findings=(clipped,)))


def test_names_from_a_model_file_cannot_break_the_line() -> None:
    assert "\n" not in line_of(with_facts("motor\nconstants\x1b[2J"))
    assert "\x1b" not in line_of(with_facts("motor\nconstants\x1b[2J"))


def test_terminal_and_page_say_it_right_after_the_verdict() -> None:
    recording = with_facts("motor constants")
    summary = summarize(recording)
    lines = terminal_report(summary, Style.PLAIN).splitlines()
    assert lines[1].startswith("ran to the end")
    assert lines[2] == summary.unchecked.text
    page = html_report(recording, summary, {})
    head = page[: page.index("</header>")]
    assert head.index("ran to the end") < head.index(summary.unchecked.text)


def test_what_was_done_by_hand_stands_first() -> None:
    about = replace(
        facts(checked=("collisions", "rated payload")),
        inputs=(InputChange(1.0, "start", 1.0), InputChange(2.0, "start", 0.0)),
        overrides=(OverrideChange(1.5, 0.5), OverrideChange(2.0, 0.0), OverrideChange(2.25, 1.0)),
        stopped=3.25,
    )
    recording = replace(pick_and_place(1), facts=about)
    assert (
        line_of(recording).split(" · ")[0]
        == "by hand: 2 inputs, override down to 50\u00a0%, held 0.25 s, stopped at 3.25 s"
    )
    assert result_figures(summarize(recording)).given == summarize(recording).unchecked.given


@pytest.mark.parametrize(
    ("override", "said"),
    [
        (1.0, ""),
        (0.9999, "override down to 99.9\u00a0%"),
        (0.5, "override down to 50\u00a0%"),
        (0.125, "override down to 12.5\u00a0%"),
        (0.001, "override down to 0.1\u00a0%"),
        (0.000999, "held 1.00 s"),
        (0.0, "held 1.00 s"),
    ],
)
def test_an_override_is_told_where_it_slowed_something(override: float, said: str) -> None:
    changes = (OverrideChange(1.5, override), OverrideChange(2.5, 1.0))
    given = given_text(facts(overrides=changes), by_hand(changes, 9.0, 9.0))
    assert given == (f"by hand: {said}" if said else "")


def test_a_hold_behind_the_end_of_the_cycle_does_not_lengthen_it() -> None:
    changes = (OverrideChange(2.0, 0.5), OverrideChange(4.0, 0.0), OverrideChange(9.0, 1.0))
    behind = by_hand(changes, 3.0, 8.0)
    assert behind == ByHand(held=0.0, slowed=1.0, slowest=0.5, is_held=True, held_in_all=4.0)
    within = by_hand(changes, 5.0, 8.0)
    assert within == ByHand(held=1.0, slowed=2.0, slowest=0.5, is_held=True, held_in_all=4.0)
    assert by_hand(changes[::-1], 5.0, 8.0) == within  # in whatever order they are kept
    assert by_hand((), 5.0, 8.0).mark == by_hand(changes[1:], 4.0, 8.0).mark == ""


def test_a_run_that_was_ended_while_it_was_held_says_for_how_long_it_was() -> None:
    changes = (OverrideChange(2.0, 0.0),)  # in the first move: nothing has come to its end
    given = given_text(facts(overrides=changes, stopped=6.5), by_hand(changes, 0.0, 6.5))
    assert given == "by hand: held 4.50 s, stopped at 6.50 s"


def test_the_cycle_time_is_marked_wherever_it_stands_as_not_that_of_the_program() -> None:
    overrides = (OverrideChange(1.0, 0.0), OverrideChange(2.25, 0.5), OverrideChange(2.75, 1.0))
    recording = replace(pick_and_place(1), facts=facts(overrides=overrides))
    summary = summarize(recording)
    mark = "held for 1.25 s and slowed for 0.50 s by hand"
    assert result_figures(summary).cycle_time_by_hand == mark
    lines = terminal_report(summary, Style.PLAIN).splitlines()
    (line,) = (one for one in lines if one.startswith("cycle time"))
    assert line.endswith(f" s  ! {mark}")
    page = html_report(recording, summary, {})
    assert mark in page[page.index("cycle time") :]
    assert result_figures(summarize(pick_and_place(1))).cycle_time_by_hand == ""
