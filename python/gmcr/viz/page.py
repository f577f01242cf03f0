"""One self-contained HTML page of an outcome: no network, no other file."""

from __future__ import annotations

from html import escape
from pathlib import Path

import plotly.graph_objects as go  # type: ignore[import-untyped]
from plotly.offline import get_plotlyjs  # type: ignore[import-untyped]

from . import words
from .figures import (
    clouds_figure,
    distances_figure,
    graph_figure,
    pose_figure,
    residuals_figure,
    stages_figure,
)
from .outcome import OtherPose, Outcome
from .scene import Scene

_MOST_POSES = 4  # side by side
# Pictures are made before the columns of the page have their widths, and plotly's camera stands
# where it stands for any shape: it is moved, along its line of sight, to where the whole box is
# seen. Again where box or width change, but not after the reader has turned or zoomed.
_FIT = """
const halfHeight = Math.tan(Math.PI / 8);  // of what plotly's camera sees at distance 1
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = a => a.map(value => value / Math.hypot(...a));
const cross = (a, b) => [0, 1, 2].map(i =>
  a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
const xyz = point => [point.x, point.y, point.z];

function fit(picture) {
  const space = picture._fullLayout.scene;
  const place = space && space._scene && space._scene.container.getBoundingClientRect();
  if (!place || !place.width || !place.height) return;
  const half = xyz(space.aspectratio).map(length => length / 2);
  const seen = [...half, place.width, place.height].map(value => value.toFixed(3)).join();
  if (picture.dataset.seen === seen) return;
  picture.dataset.seen = seen;
  const centre = xyz(space.camera.center);
  const back = unit(xyz(space.camera.eye).map((value, i) => value - centre[i]));
  const right = unit(cross(xyz(space.camera.up), back)), up = cross(back, right);
  let distance = 0;
  for (let corner = 0; corner < 8; ++corner) {
    const point = half.map((length, i) => (corner >> i & 1 ? length : -length));
    const reach = Math.max(Math.abs(dot(point, up)),
                           Math.abs(dot(point, right)) * place.height / place.width);
    distance = Math.max(distance, dot(point, back) + reach / halfHeight);
  }
  const [x, y, z] = back.map((value, i) => centre[i] + 1.06 * distance * value);
  Plotly.relayout(picture, {"scene.camera.eye": {x, y, z}});
}

addEventListener("load", () => {
  for (const picture of document.querySelectorAll(".plotly-graph-div")) {
    picture.on("plotly_afterplot", () => fit(picture));
    if (picture._fullLayout) fit(picture);
  }
  dispatchEvent(new Event("resize"));
});
"""

_STYLE = """
body { font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; color: #202124; background: #f6f7f9;
       margin: 0 auto; max-width: 1280px; padding: 20px 28px 40px; }
h1 { font-size: 20px; margin: 0 12px 0 0; overflow-wrap: anywhere; }
h2 { font-size: 16px; margin: 0 0 8px; }
header { display: flex; flex-wrap: wrap; align-items: center; gap: 6px 0; margin-bottom: 14px; }
section { background: #fff; border: 1px solid #e0e3e7; border-radius: 8px; padding: 14px 18px;
          min-width: 0; }
.badge { border-radius: 12px; padding: 2px 12px; font-weight: 600; color: #fff; }
.good { background: #188038; } .fair { background: #b06000; } .bad { background: #c5221f; }
.poses { display: grid; gap: 14px; margin-top: 8px;
         grid-template-columns: repeat(auto-fit, minmax(min(260px, 100%), 1fr)); }
.poses figure { margin: 0; min-width: 0; }
.tiles { display: grid; gap: 14px;
         grid-template-columns: repeat(auto-fit, minmax(min(160px, 45%), 1fr));
         margin-bottom: 14px; }
.tile b { display: block; font-size: 19px; }
.grid { display: grid; gap: 14px;
        grid-template-columns: repeat(auto-fit, minmax(min(460px, 100%), 1fr));
        align-items: start; margin-top: 14px; }
.stack { display: grid; gap: 14px; min-width: 0; }
.note { color: #5f6368; font-size: 13px; margin: 6px 0 0; }
table { border-collapse: collapse; width: 100%; }
th { text-align: left; font-weight: 500; color: #5f6368; vertical-align: top; white-space: nowrap;
     padding: 3px 18px 3px 0; width: 1%; }
td { padding: 3px 0; overflow-wrap: anywhere; }
.matrix { font-family: "DejaVu Sans Mono", monospace; margin: 10px 0 0; overflow-x: auto;
          font-size: min(13px, calc((100vw - 52px) / var(--columns) * 1.62)); }
table + h2, .note + h2 { margin-top: 16px; }
.reason { flex-basis: 100%; margin: 0; }
details { margin-top: 10px; } summary { cursor: pointer; color: #5f6368; }
@media (max-width: 600px) {
  body { padding: 12px 10px 30px; } section { padding: 10px 12px; }
  th { white-space: normal; padding-right: 10px; width: 30%; }
}
footer { color: #5f6368; font-size: 13px; margin-top: 16px; }
"""


def page(outcome: Outcome, scene: Scene, title: str) -> str:
    """HTML page of an outcome.

    Parameters
    ----------
    outcome, scene : Outcome, Scene
        What to show.
    title : str
        Heading, such as the names of the clouds.

    Returns
    -------
    str
        About 5 MB of it the script that draws, and what it draws.
    """
    name = escape(title)
    sections = [
        _clouds(outcome, scene),
        _other_poses(outcome, scene),
        '<div class="grid">',
        _section("Result", _table(words.result_rows(outcome))),
        '<div class="stack">',
        _section("Transform, target from source", _pose(outcome)),
        _section("In use", _options(outcome)),
        "</div>",
        *_surfaces(outcome, scene),
        _section("Residuals of all correspondences", _residuals(outcome, scene)),
        _section(
            "Consensus graph",
            _draw(graph_figure(scene), "graph") + _note(_sentence(words.agreement(scene))),
        ),
        _section("Time of each stage", _draw(stages_figure(outcome), "stages")),
        "</div>",
    ]
    return "\n".join(
        [
            '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            f'<title>gmcr: {name}</title>\n<link rel="icon" href="data:,">',
            f"<style>{_STYLE}</style>\n<script>{get_plotlyjs()}</script>\n</head>\n<body>",
            f"<header><h1>{name}</h1>{_badge(outcome)}{_reason(outcome)}</header>",
            _tiles(outcome),
            *sections,
            f"<footer>gmcr {escape(outcome.version)}, instruction set "
            f"{escape(outcome.instruction_set)}</footer>\n<script>{_FIT}</script>\n</body>\n</html>\n",
        ]
    )


def _badge(outcome: Outcome) -> str:
    line = words.headline(outcome)
    return f'<span class="badge {line.tone}" id="verdict">{escape(line.text)}</span>'


def _reason(outcome: Outcome) -> str:
    return f'<p class="reason" id="reason">{escape(_sentence(words.reason(outcome)))}</p>'


def _tiles(outcome: Outcome) -> str:
    evidence, most = outcome.pose_evidence, f"{outcome.evidence.upper:,.1f}"
    found = f"{outcome.evidence.lower:,.1f}"
    said = f"evidence, of at most {most}"
    if found != f"{evidence:,.1f}":  # the likeliest pose need not hold the most
        said = f"evidence; at most {most}, {found} held by another pose"
    num_inliers, total = len(outcome.inliers), outcome.num_correspondences
    percentage = 100 * num_inliers / max(total, 1)
    tiles = [
        ("num_inliers", f"{num_inliers:,} of {total:,}", f"inliers ({percentage:.1f} %)"),
        ("upper", *_proven(outcome)),
        ("evidence", f"{evidence:,.1f}", said),
        ("time", words.duration(outcome.total_seconds), words.count(outcome.num_threads, "thread")),
    ]
    cells = (
        f'<section class="tile"><b id="{key}">{escape(value)}</b>{escape(label)}</section>'
        for key, value, label in tiles
    )
    return f'<div class="tiles">{"".join(cells)}</div>'


def _proven(outcome: Outcome) -> tuple[str, str]:
    bounds = outcome.certificate
    if bounds.certified and outcome.has_pose:
        return "proven optimal", f"no pose has more than {int(bounds.upper):,} inliers"
    return f"at most {int(bounds.upper):,}", "inliers, whatever the pose"


def _clouds(outcome: Outcome, scene: Scene) -> str:
    notes = ". ".join(words.drawn(outcome, scene))
    hint = "Drag to turn, scroll to zoom; a click in the legend hides or shows what it names."
    body = _draw(clouds_figure(outcome, scene), "clouds") + _note(f"{notes}. {hint}")
    return _section("Clouds and correspondences", body)


def _other_poses(outcome: Outcome, scene: Scene) -> str:
    """The poses that much speaks for, side by side with the one that is returned."""
    if not outcome.others or not outcome.has_pose:
        return ""
    said = f"the returned pose: {outcome.consensus}"
    best = OtherPose(said, outcome.scale, outcome.rotation, outcome.translation)
    shown = [best, *outcome.others[: _MOST_POSES - 1]]
    cells = "".join(
        f"<figure>{_draw(pose_figure(scene, pose), f'pose{index}')}"
        f"<figcaption class='note'>{escape(_sentence(pose.words))}</figcaption></figure>"
        for index, pose in enumerate(shown)
    )
    return (
        '<div class="grid">'
        + _section("Poses side by side", f'<div class="poses" id="poses">{cells}</div>')
        + "</div>"
    )


def _surfaces(outcome: Outcome, scene: Scene) -> list[str]:
    """How far the clouds are apart, and which motions their surfaces leave open."""
    if not outcome.is_of_clouds or not outcome.has_pose:
        return []
    body = _draw(distances_figure(scene), "distances") + _note(words.distances(scene) + ".")
    body += f"<h2>What the surfaces determine</h2>{_table(words.weak_rows(outcome))}"
    return [_section("Distances after alignment", body)]


def _options(outcome: Outcome) -> str:
    defaults = words.default_rows(outcome)
    if not outcome.options:
        return _table(words.in_use_rows(outcome)) + _note(
            "The options of the registration were not given to the report."
        )
    return (
        _table(words.in_use_rows(outcome))
        + f"<details><summary>{len(defaults)} options at their defaults</summary>"
        + f"{_table(defaults)}</details>"
    )


def _pose(outcome: Outcome) -> str:
    table = _table(words.pose_rows(outcome))
    if not outcome.has_pose:
        return table
    numbers = [[f"{value:.8f}" for value in row] for row in outcome.matrix()]
    widths = [max(map(len, column)) for column in zip(*numbers, strict=True)]
    lines = [
        "  ".join(number.rjust(width) for number, width in zip(row, widths, strict=True))
        for row in numbers
    ]
    # the style takes the size of the letters from their number: a phone shows all four columns
    style, text = f"--columns: {len(lines[0])}", "\n".join(lines)
    return f'{table}<pre class="matrix" id="matrix" style="{style}">{text}</pre>'


def _residuals(outcome: Outcome, scene: Scene) -> str:
    if not outcome.has_pose:
        return _note("Not drawn: there is no pose.")
    return _draw(residuals_figure(outcome, scene), "residuals")


def _section(heading: str, body: str) -> str:
    return f"<section><h2>{escape(heading)}</h2>{body}</section>"


def _note(text: str) -> str:
    return f'<p class="note">{escape(text)}</p>'


def _sentence(text: str) -> str:
    return text[0].upper() + text[1:] + "."


def _table(rows: words.Rows) -> str:
    if not rows:
        return ""
    cells = (f"<tr><th>{escape(key)}</th><td>{escape(text)}</td></tr>" for key, text in rows)
    return f"<table>{''.join(cells)}</table>"


def _draw(figure: go.Figure | None, name: str) -> str:
    if figure is None:
        return ""
    config = {"displaylogo": False, "responsive": True, "scrollZoom": True}
    html: str = figure.to_html(config, full_html=False, include_plotlyjs=False, div_id=name)
    return html


def write_page(path: Path, outcome: Outcome, scene: Scene, title: str) -> None:
    """Writes ``page`` to a file; what UTF-8 cannot say in the title becomes '?'."""
    path.write_text(page(outcome, scene, title), encoding="utf-8", errors="replace")
