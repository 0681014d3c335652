"""The small script of the HTML report: one time cursor over all charts, by pointer or keyboard.

The page is complete without it: every number that matters is in a table.
"""

SCRIPT = """
"use strict";
(() => {
  const charts = [...document.querySelectorAll("svg.time")];
  const reading = document.getElementById("reading");
  if (!charts.length || !reading) return;
  const end = Number(charts[0].dataset.end);
  const left = Number(charts[0].dataset.left), right = Number(charts[0].dataset.right);
  const rows = [];
  for (const chart of charts)
    for (const row of chart.querySelectorAll(".row")) {
      const top = Number(row.dataset.top), height = Number(row.dataset.height);
      const low = Number(row.dataset.low), high = Number(row.dataset.high);
      for (const trace of row.querySelectorAll("[data-decimals]")) {
        const points = [...trace.querySelectorAll("polyline")].map((line) =>
          line.getAttribute("points").split(" ").map((pair) => pair.split(",").map(Number)));
        const shown = trace.querySelector("tspan");
        const value = (y) => (high - (y - top) * (high - low) / height).toFixed(trace.dataset.decimals);
        rows.push({ points, shown, value, peak: shown.textContent });
      }
    }
  const starts = (reading.dataset.starts || "").split(" ").map(Number);
  const lines = (reading.dataset.lines || "").split(" ");
  const before = (list, x, key) => {
    let a = 0, b = list.length;
    while (a < b) { const m = (a + b) >> 1; if (key(list[m]) <= x) a = m + 1; else b = m; }
    return a - 1;
  };
  const at = (pieces, x) => {
    for (const points of pieces) {
      if (x < points[0][0] - 0.5 || x > points[points.length - 1][0] + 0.5) continue;
      const k = Math.max(0, before(points, x, (p) => p[0])), p = points[k], q = points[k + 1] || p;
      const share = q[0] > p[0] ? Math.min(Math.max((x - p[0]) / (q[0] - p[0]), 0), 1) : 0;
      return p[1] + share * (q[1] - p[1]);
    }
    return null;
  };
  let now = 0, asked = false;
  const draw = () => {
    asked = false;
    const x = left + (right - left) * now / end;
    for (const chart of charts) {
      const cursor = chart.querySelector(".cursor");
      cursor.setAttribute("x1", x); cursor.setAttribute("x2", x);
    }
    for (const row of rows) {
      const y = at(row.points, x);
      row.shown.textContent = y === null ? "–" : row.value(y);
    }
    const line = lines[before(starts, now, (t) => t)];
    reading.textContent = `t = ${now.toFixed(2)} s` + (line && line !== "0" ? ` · line ${line}` : "");
    document.body.classList.add("reading");
  };
  const go = (time) => {
    now = Math.min(Math.max(time, 0), end);
    if (!asked) { asked = true; requestAnimationFrame(draw); }
  };
  const rest = () => {
    document.body.classList.remove("reading");
    for (const row of rows) row.shown.textContent = row.peak;
  };
  for (const chart of charts) {
    chart.addEventListener("pointermove", (event) => {
      const box = chart.getBoundingClientRect();
      const x = (event.clientX - box.left) * chart.viewBox.baseVal.width / box.width;
      if (x < left || x > right) rest(); else go((x - left) / (right - left) * end);
    });
    chart.addEventListener("pointerleave", () => { asked = false; rest(); });
    chart.addEventListener("blur", rest);
    chart.addEventListener("keydown", (event) => {
      const step = end / (event.shiftKey ? 20 : 200);
      const to = { ArrowLeft: now - step, ArrowRight: now + step, Home: 0, End: end }[event.key];
      if (to !== undefined) { go(to); event.preventDefault(); }
      else if (event.key === "Escape") rest();
    });
  }
})();
"""
