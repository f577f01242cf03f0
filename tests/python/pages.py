"""Runs what the pages of the documentation show, and compares what is printed with what they say.

In a fenced block ``python`` is run in the namespace of its page, ``sh`` by bash in a folder that
has the files of `prepare`; a ``text`` block that follows is what has to be printed, with ``...``
for anything. ``console`` is not run, ``cpp`` has to be part of an example. A comment ``<!-- run``
holds what the reader would bring along.
"""

from __future__ import annotations

import contextlib
import doctest
import io
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import gmcr
import gmcr.io
import numpy as np
from towns import pose_at, sweep, town_points

ROOT = Path(__file__).parents[2]
_BLOCK = re.compile(
    r"^```(?P<language>\w*)\n(?P<code>.*?)^```$|^<!-- run\n(?P<hidden>.*?)^-->$",
    re.DOTALL | re.MULTILINE,
)
#: What the reader of a page has at hand.
PRELUDES = {
    "python": """
import gmcr, gmcr.io, gmcr.viz, numpy as np
source = gmcr.io.read_points("scan_2.ply")
target = source @ gmcr.make_synthetic(num_correspondences=3, seed=9).target_from_source.rotation.T
source_features = np.random.default_rng(1).normal(size=(len(source), 16))
target_features = source_features
paths = ["scan_1.ply", "scan_2.ply"]
"""
}
_FLAGS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE


@dataclass(frozen=True)
class Block:
    """A piece of code, or what the piece before it has to print."""

    language: str
    code: str
    line: int


def blocks_of(page: str) -> Iterator[Block]:
    """The blocks of a page, in their order."""
    for found in _BLOCK.finditer(page):
        line = page.count("\n", 0, found.start()) + 1
        if found["hidden"] is not None:
            yield Block("python", found["hidden"], line)
        else:
            yield Block(found["language"], found["code"], line)


def run_page(path: Path, folder: Path, tool: Path) -> int:
    """Runs a page.

    Parameters
    ----------
    path, folder, tool : Path
        The page; where to run it; the command-line tool.

    Returns
    -------
    int
        The number of blocks that were run.

    Raises
    ------
    AssertionError
        naming page and line, where a block fails or prints something else.
    """
    names: dict[str, Any] = {"__name__": path.stem}
    exec(PRELUDES.get(path.stem, ""), names)
    printed: str | None = None
    num_run = 0
    for block in blocks_of(path.read_text()):
        place = f"{path.name}:{block.line}"
        if block.language == "python":
            printed = _run_python(block.code, names, place)
        elif block.language == "sh" and all(map(_installs, block.code.splitlines())):
            printed = ""
        elif block.language == "sh":
            printed = _run_shell(block.code, folder, tool, place)
        else:
            if block.language == "text" and printed is not None:
                is_same = doctest.OutputChecker().check_output(block.code, printed, _FLAGS)
                assert is_same, f"{place}: printed\n{printed}"
            printed = None
            continue
        num_run += 1
    if "server" in names:
        names["server"].stop()
    return num_run


def _installs(line: str) -> bool:
    return line.startswith("pip install ")


def _run_python(code: str, names: dict[str, Any], place: str) -> str:
    output = io.StringIO()
    try:
        with contextlib.redirect_stdout(output):
            exec(compile(code, place, "exec"), names)
    except Exception as error:
        raise AssertionError(f"{place}: {type(error).__name__}: {error}") from error
    return output.getvalue()


def _run_shell(code: str, folder: Path, tool: Path, place: str) -> str:
    python = Path(sys.executable).parent
    done = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", code], cwd=folder, capture_output=True, text=True,
        env={**os.environ, "PATH": f"{tool.parent}:{python}:{os.environ['PATH']}",
             "GMCR_PYTHON": sys.executable},
    )  # fmt: skip
    assert done.returncode == 0, f"{place}: exit code {done.returncode}\n{done.stderr}"
    return done.stdout


def prepare(folder: Path) -> None:
    """Files as a reader has them: scans, a map, an object and a scene, a mesh, matches."""
    rng = np.random.default_rng(5)
    motion = gmcr.make_synthetic(num_correspondences=3, outlier_rate=0, seed=9).target_from_source

    def moved(points: np.ndarray) -> np.ndarray:
        return points @ motion.rotation.T + motion.translation

    def hills(xy: np.ndarray) -> np.ndarray:
        height = 0.3 * np.sin(4 * xy[:, 0]) * np.cos(3 * xy[:, 1])
        peak = 0.2 * np.exp(-20 * ((xy - [0.4, -0.3]) ** 2).sum(axis=1))
        return np.column_stack([xy, height + peak + 0.1 * np.sin(5 * xy.sum(axis=1))])

    scan = hills(rng.uniform(-1, 1, (4000, 2)))
    gmcr.io.write_points(folder / "scan_2.ply", scan)
    gmcr.io.write_points(folder / "scan_1.ply", moved(hills(rng.uniform(-1, 1.2, (4000, 2)))))
    gmcr.io.write_points(folder / "scan_3.ply", moved(hills(rng.uniform(-1.1, 1, (4000, 2)))))
    gmcr.io.write_points(folder / "scan.ply", scan)
    angle = 0.5  # the map is level, and not far off
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0]])
    level = np.vstack([turn, [0, 0, 1]])
    wide = hills(rng.uniform(-2, 2, (16000, 2)))
    gmcr.io.write_points(folder / "map.ply", wide @ level.T + [1, 2, 0.3])
    town = town_points()
    gmcr.io.write_points(folder / "town.ply", town)
    gmcr.io.write_points(folder / "sweep.ply", sweep(town, pose_at(31, 27, 2.1)))
    problem = gmcr.make_synthetic(num_correspondences=300, outlier_rate=0.9, seed=1)
    np.savetxt(
        folder / "matches.csv", np.hstack([problem.source, problem.target]), delimiter=",",
        header="ax,ay,az,bx,by,bz", comments="",
    )  # fmt: skip
    (folder / "pairs.csv").write_text("id,matches\none,matches.csv\ntwo,matches.csv\n")
    (folder / "docs").mkdir(exist_ok=True)
    shutil.copy(ROOT / "docs/result.schema.json", folder / "docs")
    part, triangles = _bumpy_ball()
    _write_stl(folder / "part.stl", 100 * part, triangles)
    dense = _points_on(part, triangles, rng, 20000)
    seen = moved(0.1 * dense[dense[:, 2] > -0.1])
    gmcr.io.write_points(folder / "scan_of_part.ply", seen)
    gmcr.io.write_points(folder / "object.ply", 0.1 * _points_on(part, triangles, rng, 6000))
    floor = np.column_stack([rng.uniform(-0.4, 0.4, (6000, 2)), np.full(6000, -0.13)])
    gmcr.io.write_points(folder / "scene.ply", moved(np.vstack([0.1 * dense[::3], floor])))


def _bumpy_ball() -> tuple[np.ndarray, np.ndarray]:
    """Vertices and triangles of a closed surface without symmetry, radius about 1."""
    rings, sectors = 60, 120
    polar = np.pi * np.repeat((np.arange(rings) + 0.5) / rings, sectors)
    around = 2 * np.pi * np.tile(np.arange(sectors) / sectors, rings)
    unit = np.column_stack(
        [np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.cos(polar)]
    )
    radius = 1 + 0.25 * np.sin(3 * unit[:, 0] + 1) * np.cos(4 * unit[:, 1])
    radius += 0.2 * np.sin(5 * unit[:, 2] + unit[:, 0])
    ring, sector = np.divmod(np.arange((rings - 1) * sectors), sectors)
    a = ring * sectors + sector
    b = ring * sectors + (sector + 1) % sectors
    triangles = np.vstack(
        [np.column_stack([a, a + sectors, b]), np.column_stack([b, a + sectors, b + sectors])]
    )
    return unit * radius[:, None], triangles


def _points_on(
    vertices: np.ndarray, triangles: np.ndarray, rng: np.random.Generator, count: int
) -> np.ndarray:
    """Points spread over a mesh, more on larger triangles."""
    corners = vertices[triangles]
    areas = np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    chosen = corners[rng.choice(len(corners), count, p=areas / areas.sum())]
    weights = rng.dirichlet(np.ones(3), count)
    points: np.ndarray = np.einsum("nk,nkd->nd", weights, chosen)
    return points


def _write_stl(path: Path, vertices: np.ndarray, triangles: np.ndarray) -> None:
    kind = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    faces = np.zeros(len(triangles), kind)
    faces["corners"] = vertices[triangles]
    header = b"gmcr".ljust(80) + np.uint32(len(faces)).tobytes()
    path.write_bytes(header + faces.tobytes())
