"""The cards with the key figures in the HTML report."""

from typing import TypeAlias

from ropsim.core import plural
from ropsim.flow import SLOW
from ropsim.views.html.tables import marked
from ropsim.views.markup.markup import text
from ropsim.views.summary.device_summary import DeviceSummary
from ropsim.views.summary.findings import place_text
from ropsim.views.summary.joint_summary import (
    JointSummary,
    closest_to_position_limit,
    closest_to_speed_limit,
    closest_to_torque_limit,
)
from ropsim.views.summary.station_summary import Figures, StationSummary
from ropsim.views.summary.summary import Summary
from ropsim.views.words.figures import (
    MILLIMETRES,
    PERCENT,
    UNKNOWN,
    coordinate_scale,
    digits,
    energy,
    percent,
    power,
    seconds,
    with_unit,
)

Card: TypeAlias = tuple[str, str, str]
"""Name, value and a few words below it."""

OF_CYCLE = "of the cycle time"
OF_CYCLES = "of the sum of the cycle times"
"""Reference of shares, of one station and of several together."""


def key_figures(summary: Summary) -> str:
    """Return the cards with the key figures of a run."""
    return _cards(
        [
            _cycle_time(summary, summary),
            *_settling_figure(summary, _cycle_words(summary)),
            *(_waiting_figure(summary) if len(summary.stations) == 1 else ()),
            *_work(summary, _cycle_words(summary)),
            *(card for one in summary.stations if len(summary.stations) == 1 for card in _energy_figure(one)),
            *(
                card
                for one in summary.stations
                if len(summary.stations) == 1
                for card in _contact_figure(one)
            ),
            *_destinations_figure(summary),
            *_device_figures(summary.devices),
            *_path_figure(summary),
            *_joint_figures(summary.joints),
        ],
        "key figures",
    )


def station_figures(station: StationSummary, summary: Summary) -> str:
    """Return the cards with the key figures of one of several stations."""
    return _cards(
        [
            _cycle_time(station, summary),
            *_settling_figure(station, OF_CYCLE),
            *_waiting_figure(station),
            *_work(station, OF_CYCLE),
            *_energy_figure(station),
            *_contact_figure(station),
            *_path_figure(station),
            *_joint_figures(station.joints),
        ],
        f"key figures of {text(station.facts.name)}",
    )


def _cycle_time(figures: Figures, summary: Summary) -> Card:
    detail = summary.by_hand.mark or "settling included"
    detail = detail if summary.cycle_time_valid else "not valid: see above"
    return "cycle time", f"{seconds(figures.cycle_time)} s", detail


def _cycle_words(summary: Summary) -> str:
    """Return the time that shares of a whole run refer to."""
    return OF_CYCLE if len(summary.stations) == 1 else OF_CYCLES


def _work(figures: Figures, of_cycle: str) -> list[Card]:
    moves = ", ".join(f"{count} {text(kind)}" for kind, count in figures.moves.items()) or "none"
    empty = f"{figures.empty_grips} empty, " if figures.empty_grips else ""
    return [
        ("in motion", percent(figures.share_in_motion), of_cycle),
        ("moves", str(sum(figures.moves.values())), moves),
        ("gripper", str(figures.grips), f"grips, {empty}{figures.releases} releases"),
    ]


def _device_figures(devices: tuple[DeviceSummary, ...]) -> list[Card]:
    return [
        (text(one.name), with_unit(one.travel, coordinate_scale(one.type), 1), "travelled") for one in devices
    ]


def _cards(figures: list[Card], label: str) -> str:
    cells = "".join(
        f"<div><dl><dt>{name}</dt><dd>{value}<small>{detail}</small></dd></dl></div>\n"
        for name, value, detail in figures
    )
    return f'<section class="figures" aria-label="{label}">\n{cells}</section>\n'


def _settling_figure(figures: Figures, of_cycle: str) -> list[Card]:
    settling = figures.settling
    if not figures.is_driven:
        return [("settling", UNKNOWN, "without drives")]
    share = f"{with_unit(settling.share, PERCENT, 1)} {of_cycle}"
    place = place_text(settling.line, settling.visit)
    longest = f"; longest {settling.longest:.3f} s{place}" if settling.longest > 0.0 else ""
    slow = f"; {plural(settling.slow, 'move')} longer than {SLOW * 1e3:g} ms" if settling.slow else ""
    return [("settling", f"{seconds(settling.total)} s", share + longest + slow)]


def _waiting_figure(figures: Figures) -> list[Card]:
    waiting = figures.waiting
    if not waiting.total > 0.0:
        return []
    longest = f"longest {seconds(waiting.longest)} s{place_text(waiting.line, waiting.visit)}"
    return [
        ("waiting", f"{seconds(waiting.total)} s", f"{percent(waiting.share)} of the cycle time; {longest}")
    ]


def _energy_figure(station: StationSummary) -> list[Card]:
    found = station.energy
    if found is None:
        return [] if station.is_driven else [("energy", UNKNOWN, "without drives")]
    detail = f"drawn, {energy(found.given_back)} given back; at most {power(found.peak.value)}"
    bound = f"; {text(found.bound)}" if found.bound else ""
    return [("energy", energy(found.drawn), detail + bound)]


def _contact_figure(station: StationSummary) -> list[Card]:
    peak = station.contact
    if peak is None:
        return []
    return [
        (
            "contact force, max",
            f"{digits(peak.value)} N",
            f"at {seconds(peak.time)} s{place_text(peak.line, 0)}",
        )
    ]


def _destinations_figure(summary: Summary) -> list[Card]:
    if summary.destinations is None:
        return []
    count = f"{summary.destinations.reached} of {summary.destinations.wanted}"
    return [("parts", count, "at their destination")]


def _path_figure(figures: Figures) -> list[Card]:
    if not figures.path.moves:
        return []
    title, path = "path error of tool paths, max", figures.path
    if path.worst is None:
        return [(title, UNKNOWN, "without drives")]
    mean = with_unit(path.mean_error, MILLIMETRES, 3)
    detail = f"mean {mean}"
    if figures.contours:
        whole = with_unit(max(one.path_max for one in figures.contours), MILLIMETRES, 3)
        detail += f"; each move against its own part of the path, contours as a whole: max {whole}"
    return [(title, with_unit(path.max_error, MILLIMETRES, 3), detail)]


def _joint_figures(joints: tuple[JointSummary, ...]) -> list[Card]:
    result = []
    torque, speed = closest_to_torque_limit(joints), closest_to_speed_limit(joints)
    if torque is not None:
        result.append(("peak torque", percent(torque.effort_share), _of_the_limit(torque)))
    if speed is not None:
        result.append(("peak speed", percent(speed.speed_share), _of_the_limit(speed)))
    closest = closest_to_position_limit(joints)
    if closest is not None:
        margin = marked(
            with_unit(closest.nearest.margin, coordinate_scale(closest.facts.type), 1),
            closest.margin_closeness,
        )
        result.append(("closest to a limit", margin, f"{text(closest.words)}, {closest.nearest.side}"))
    return result


def _of_the_limit(joint: JointSummary) -> str:
    return f"of the limit, {text(joint.words)}"
