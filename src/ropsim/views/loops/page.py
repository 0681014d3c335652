"""Responses and margins of loops as one HTML page that needs nothing else."""

from ropsim.version import __version__
from ropsim.views.chart.chart import TimeChart, Trace, TraceRow, time_chart
from ropsim.views.chart.frequency import FrequencyChart, frequency_chart
from ropsim.views.loops.records import LoopPage, LoopTable, SineCurves, TimeCurves
from ropsim.views.markup.markup import table, text
from ropsim.views.markup.theme import stylesheet

_KEYS = '<span class="key"><i></i>{one}</span><span class="key"><i class="c2"></i>{two}</span>'
HALF_POWER = -3.0103
"""Gain at which the bandwidth ends [dB]."""


def response_page(page: LoopPage) -> str:
    """Return the page: tables, answers in time, answers to sines, notes."""
    times = "".join(_in_time(one, k) for k, one in enumerate(page.times))
    sines = "".join(_to_sines(one, k) for k, one in enumerate(page.sines))
    notes = "".join(f"<p>{text(note)}</p>\n" for note in page.notes)
    body = [
        f'<header>\n<h1>{text(page.title)}</h1>\n<p class="quiet">{text(page.subtitle)}</p>\n</header>\n',
        f"<section><h2>Figures</h2>\n{''.join(map(_table, page.tables))}</section>\n",
        f"<section><h2>In time</h2>\n{times}</section>\n" if times else "",
        f"<section><h2>Sines of the reference</h2>\n{sines}</section>\n" if sines else "",
        f"<section><h2>Conditions</h2>\n{notes}</section>\n" if notes else "",
        f"<footer>ropsim {text(__version__)}</footer>\n",
    ]
    policy = "default-src &#39;none&#39;; style-src &#39;unsafe-inline&#39;"
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f"<title>{text(page.title)} – responses</title>\n"
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        f"<style>\n{stylesheet()}</style>\n</head>\n<body>\n<main>\n{''.join(body)}</main>\n"
        "</body>\n</html>\n"
    )


def _table(one: LoopTable) -> str:
    header = tuple("<br>".join(map(text, title.split("\n"))) for title in one.header)
    return table(text(one.caption), header, [tuple(map(text, row)) for row in one.rows])


def _in_time(one: TimeCurves, number: int) -> str:
    rows = (
        TraceRow(
            "coordinate",
            one.unit,
            (Trace("reference", one.reference, "c2"), Trace("attained", one.moved)),
            height=130.0,
        ),
        TraceRow("drive", one.effort_unit, (Trace("effort", one.effort),), height=60.0),
    )
    what = "Reference and attained coordinate from where the axis was, and what its drive gives at the joint."
    chart = TimeChart(f"time-{number}", f"Answer of axis {one.name}", what, one.time, rows)
    return _figure(f"axis {one.name}", _KEYS.format(one="attained", two="reference"), time_chart(chart))


def _to_sines(one: SineCurves, number: int) -> str:
    rows = (
        TraceRow("gain", "dB", (Trace("gain", one.gain),), (HALF_POWER,), height=90.0),
        TraceRow("phase", "°", (Trace("phase", one.phase),), height=70.0),
    )
    what = "Amplitude over that of the reference, and lead over it; the dashed line is at -3 dB."
    chart = FrequencyChart(f"sines-{number}", f"Axis {one.name} under sines", what, one.hz, rows)
    return _figure(f"axis {one.name}", "", frequency_chart(chart))


def _figure(title: str, keys: str, body: str) -> str:
    caption = f"<figcaption><strong>{text(title)}</strong>{keys}</figcaption>"
    return f'<figure>{caption}\n<div class="scroll" tabindex="0">{body}</div></figure>\n'
