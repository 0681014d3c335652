"""Draw docs/images/palletizing.svg, the picture of the README, from a real run of the palletizing cell."""

from pathlib import Path

import numpy as np

import ropsim
from ropsim.flow import Recording
from ropsim.spatial import Array

ROOT = Path(__file__).parents[1]
WIDTH, HEIGHT = 1000, 460
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
STYLE = "font-family:system-ui,sans-serif;font-size:13px;fill:#333"


def polyline(x: Array, y: Array, colour: str, width: float) -> str:
    """Return a line through points."""
    points = " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(x, y, strict=True))
    return f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="{width}"/>'


def label(x: float, y: float, text: str, anchor: str = "start", colour: str = "#333") -> str:
    """Return a text."""
    return f'<text x="{x:.0f}" y="{y:.0f}" text-anchor="{anchor}" style="{STYLE};fill:{colour}">{text}</text>'


def top_view(recording: Recording) -> str:
    """Return the TCP path seen from above: x to the right, y up, equal scales."""
    path = recording.channels["attained_position"].values[::9]
    low, high = path[:, :2].min(axis=0), path[:, :2].max(axis=0)
    scale = min(400 / (high[0] - low[0]), 370 / (high[1] - low[1]))
    middle = (low + high) / 2
    x = 215 + (path[:, 0] - middle[0]) * scale
    y = 225 - (path[:, 1] - middle[1]) * scale
    parts = [label(20, 24, "TCP path from above: infeed and pallet"), polyline(x, y, COLOURS[0], 0.8)]
    for event in recording.events:
        if event.kind == "release":
            row = int(np.searchsorted(recording.time, event.time))
            spot = recording.channels["attained_position"].values[row]
            cx, cy = 215 + (spot[0] - middle[0]) * scale, 225 - (spot[1] - middle[1]) * scale
            half = 0.03 * scale
            parts.append(
                f'<rect x="{cx - half:.1f}" y="{cy - half:.1f}" width="{2 * half:.1f}" '
                f'height="{2 * half:.1f}" fill="#d55e00" fill-opacity="0.25" stroke="#d55e00"/>'
            )
    return "".join(parts)


def torques(recording: Recording, seconds: float = 16.0) -> str:
    """Return the torque of each joint over the first seconds as a share of its limit."""
    until = int(np.searchsorted(recording.time, seconds))
    time = recording.time[:until:6]
    values = recording.channels["tau"].values[:until:6]
    (station,) = recording.facts.stations
    parts = [label(470, 24, f"drive torques over the first {seconds:.0f} s, share of the joint's limit")]
    for joint in range(values.shape[1]):
        middle = 70 + joint * 62
        x = 500 + time / seconds * 470
        y = middle - values[:, joint] / station.axes[joint].max_effort * 29
        parts.append(
            f'<line x1="500" x2="970" y1="{middle}" y2="{middle}" stroke="#ddd"/>'
            + polyline(x, y, COLOURS[joint], 1.2)
            + label(490, middle + 4, str(joint + 1), "end", COLOURS[joint])
        )
    return "".join(parts)


def main() -> None:
    """Run the cell and write the picture."""
    recording = ropsim.open(ROOT / "examples" / "palletizing").simulate()
    caption = (
        f"36 boxes, PUMA 560, true servo and arm dynamics: cycle time {recording.duration:.1f} s, "
        f"path error {1e3 * np.nanmax(recording.channels['path_error'].values):.2f} mm"
    )
    svg = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" role="img">'
        f"<title>{caption}</title>"
        f'<rect width="{WIDTH}" height="{HEIGHT}" rx="10" fill="#fff" stroke="#ddd"/>'
        f"{top_view(recording)}{torques(recording)}{label(WIDTH / 2, HEIGHT - 10, caption, 'middle')}</svg>\n"
    )
    (ROOT / "docs" / "images" / "palletizing.svg").write_text(svg, encoding="utf-8")
    print(f"wrote docs/images/palletizing.svg, {len(svg) / 1000:.0f} kB")


if __name__ == "__main__":
    main()
