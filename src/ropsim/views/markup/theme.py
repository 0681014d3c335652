"""Colours and layout of the HTML report.

The two trace colours are a blue and an orange that stay apart for all common kinds of colour blindness; no
information is carried by colour alone. Text has a contrast of at least 4.5 : 1, traces of 3 : 1 (WCAG 2.1
AA), in the light and in the dark scheme.
"""

LIGHT = """
  --page: #f6f7f9; --sheet: #ffffff; --text: #1b2026; --quiet: #56606b; --line: #d5dae0; --grid: #e9ecef;
  --c1: #0a5ea8; --c2: #b8480a; --limit: #9b1c4a; --band: #eef3e2; --bar: #4d7fa8; --lane: #f1f3f5;
  --good: #1d6b38; --doubt: #7a5200; --bad: #a8201a; --code: #f3f4f6;
"""

DARK = """
  --page: #101418; --sheet: #171c22; --text: #e7eaee; --quiet: #a3adb8; --line: #39424d; --grid: #262d35;
  --c1: #6ab4ff; --c2: #ff9d57; --limit: #ff86b3; --band: #253020; --bar: #5f97c6; --lane: #1e242b;
  --good: #63d08a; --doubt: #f0b84a; --bad: #ff8b80; --code: #10151a;
"""

LAYOUT = """
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--text);
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", "Noto Sans", "DejaVu Sans", sans-serif; }
main { max-width: 1080px; margin: 0 auto; padding: 28px 20px 72px; }
h1 { font-size: 27px; line-height: 1.2; margin: 0 0 4px; letter-spacing: -.01em; }
h2 { font-size: 18px; margin: 0 0 10px; }
h3 { font-size: 15px; margin: 22px 0 6px; }
p { margin: 0 0 10px; max-width: 76ch; }
a { color: var(--c1); }
section { background: var(--sheet); border: 1px solid var(--line); border-radius: 10px; padding: 20px 22px;
  margin: 18px 0 0; }
.quiet { color: var(--quiet); } p.screen { max-width: none; }
.verdict { display: inline-block; margin: 12px 0 0; padding: 6px 12px; border-radius: 8px; font-weight: 600;
  border: 1.5px solid currentColor; }
.unchecked { margin: 8px 0 0; max-width: none; }
.good { color: var(--good); } .doubtful { color: var(--doubt); } .failed { color: var(--bad); }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(210px, 1fr)); padding: 0;
  overflow: hidden; }
.figures div { box-shadow: 0 0 0 .5px var(--line); padding: 14px 18px; }
.figures dl { display: contents; }
.figures dt { color: var(--quiet); font-size: 13px; }
.figures dd { margin: 0; font-size: 22px; line-height: 1.3; font-variant-numeric: tabular-nums; }
.figures dd small { display: block; font-size: 12.5px; color: var(--quiet); }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; font-size: 14px; }
caption { text-align: left; color: var(--quiet); padding: 0 0 6px; font-size: 13.5px; }
th, td { padding: 5px 10px; text-align: right; border-bottom: 1px solid var(--grid); white-space: nowrap; }
th { font-weight: 600; }
thead th { border-bottom: 1.5px solid var(--line); color: var(--quiet); font-size: 13px;
  vertical-align: bottom; }
th:first-child, td.text, th.text { text-align: left; }
td.wrap { text-align: left; white-space: normal; }
td code { font-size: 13px; }
code.source { display: block; max-width: 19ch; overflow: hidden; text-overflow: ellipsis; text-align: left; }
table.words th, table.words td { text-align: left; white-space: normal; }
.mark { font-weight: 700; color: var(--bad); } .near { font-weight: 700; color: var(--doubt); }
code, pre { font-family: ui-monospace, "SF Mono", "Cascadia Mono", "DejaVu Sans Mono", monospace; }
pre { margin: 6px 0 10px; padding: 10px 12px; background: var(--code); border-radius: 6px; overflow-x: auto;
  font-size: 13px; line-height: 1.4; }
.finding { border-left: 4px solid currentColor; padding: 2px 0 2px 14px; margin: 0 0 18px; }
.finding:last-child { margin: 0; } .finding p { margin: 0 0 4px; max-width: none; }
.finding code { font-weight: 500; background: var(--code); padding: 1px 4px; border-radius: 4px; }
.finding > * { color: var(--text); } .finding .head { font-weight: 600; overflow-wrap: anywhere; }
.finding .kind { color: var(--bad); } .finding.warning .kind { color: var(--doubt); }
.finding.hint .kind { color: var(--c1); }
.finding.error { color: var(--bad); } .finding.warning { color: var(--doubt); }
.finding.hint { color: var(--c1); }
figure { margin: 0 0 26px; } figure:last-child { margin-bottom: 0; }
figcaption { margin: 0 0 6px; font-size: 14px; } figcaption strong { margin-right: 14px; }
.key { display: inline-block; margin-right: 14px; color: var(--quiet); font-size: 13px; white-space: nowrap; }
.key i { display: inline-block; width: 22px; height: 0; margin-right: 5px; vertical-align: 4px;
  border-top: 2px solid var(--c1); }
.key i.c2 { border-top-color: var(--c2); } .key i.limit { border-top: 2px dashed var(--limit); }
.key i.band { height: 12px; border: 0; background: var(--band); outline: 1px solid var(--line);
  vertical-align: -1px; }
.key i.dot { width: 8px; height: 8px; border: 1.5px solid var(--text); border-radius: 50%;
  vertical-align: 0; }
.key i.square { width: 8px; height: 8px; border: 1.5px solid var(--text); vertical-align: 0; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(320px, 1fr)); gap: 16px; }
svg { display: block; width: 100%; height: auto; font-size: 11.5px; }
svg.time { min-width: 640px; }
svg.time:focus-visible { outline: 2px solid var(--c1); outline-offset: 2px; border-radius: 4px; }
svg text { fill: var(--text); font-variant-numeric: tabular-nums; }
svg .tick { fill: var(--quiet); font-size: 10.5px; } svg .end { text-anchor: end; }
svg .middle { text-anchor: middle; } svg .name { font-weight: 600; }
svg .plot { fill: none; stroke: var(--line); stroke-width: 1; } svg .lane { fill: var(--lane); }
svg .grid { stroke: var(--grid); stroke-width: 1; } svg .zero, svg .mark { stroke: var(--line);
  stroke-width: 1; }
svg .zero { stroke: var(--quiet); stroke-width: .6; } svg .band { fill: var(--band); }
svg .bar { fill: var(--bar); }
svg .limit { stroke: var(--limit); stroke-width: 1.4; stroke-dasharray: 6 4; }
svg polyline { fill: none; stroke-width: 1.25; stroke-linejoin: round; }
svg.plane polyline { stroke-width: .9; } svg.plane .c2 polyline { stroke-width: 1.8; }
svg .c1 polyline { stroke: var(--c1); } svg .c2 polyline { stroke: var(--c2); }
svg .c1 .value { fill: var(--c1); } svg .c2 .value { fill: var(--c2); }
svg .spot { fill: var(--sheet); stroke: var(--text); stroke-width: 1.5; }
svg .cursor { stroke: var(--text); stroke-width: 1; visibility: hidden; pointer-events: none; }
.reading svg .cursor { visibility: visible; }
#reading { position: fixed; right: 16px; bottom: 16px; padding: 6px 12px; border-radius: 8px;
  background: var(--text);
  color: var(--sheet); font-variant-numeric: tabular-nums; font-size: 14px; visibility: hidden;
  max-width: 90vw; }
.reading #reading { visibility: visible; }
dl.words dt { font-weight: 600; margin-top: 8px; }
dl.words dd { margin: 0; max-width: 80ch; }
footer { color: var(--quiet); font-size: 13px; margin-top: 18px; overflow-wrap: anywhere; }
@media (max-width: 620px) { main { padding: 16px 8px 48px; } section { padding: 14px 12px; } }
@media print {
  :root { color-scheme: light; } @page { margin: 14mm; }
  body { background: none; font-size: 11pt; } main { max-width: none; padding: 0; }
  section { border: 0; border-radius: 0; padding: 0; margin: 0 0 8mm; }
  .figures { border: 1px solid var(--line); }
  figure, tr, .finding { break-inside: avoid; } h2, h3, figcaption { break-after: avoid; }
  #reading, .screen { display: none; } .scroll { overflow: visible; } svg.time { min-width: 0; }
}
"""


def stylesheet() -> str:
    """Return the style sheet: light, dark where the reader prefers it, always light on paper."""
    return (
        f":root {{ color-scheme: light dark; {LIGHT}}}\n"
        f"@media screen and (prefers-color-scheme: dark) {{ :root {{ {DARK}}} }}\n{LAYOUT}"
    )
