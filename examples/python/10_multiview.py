"""Scans of the Stanford bunny, from no initial guess, to one cloud and a picture.

10_multiview.py [--output FOLDER] [--views VIEW ...]

The scans are those of the Stanford 3D Scanning Repository, in $GMCR_DATA/stanford_scans: by default
four, 90 degrees apart. Every pair is registered. Views from opposite sides hardly overlap, and
their poses are wrong; the cycle of the others gives them away.
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import gmcr
import numpy as np
import numpy.typing as npt
from gmcr.io import read_points, write_points
from gmcr.multiview import MultiviewResult, merge_scans, register_scans

Points = npt.NDArray[np.float64]
DATA = Path(os.environ.get("GMCR_DATA", Path(__file__).parents[3] / "shared/data"))
FILES = {
    "000": "bunny_045_000/target.ply",
    "045": "bunny_045_000/source.ply",
    "090": "bunny_090_000/source.ply",
    "180": "bunny_180_270/source.ply",
    "270": "bunny_180_270/target.ply",
    "top3": "bunny_top3_000/source.ply",
}
VOXEL_SIZE = 0.0007  # metres, about the spacing of the points of one scan
COLOURS = ("#4477aa", "#ee6677", "#228833", "#ccbb44", "#66ccee", "#aa3377")  # Tol's bright
LIGHT = np.array([0.35, 0.55, 0.76])


def print_errors(views: list[str], scans: list[Points], result: MultiviewResult) -> None:
    """Errors against the poses that are known: those of the four pairs of the data."""
    for name in ("045_000", "090_000", "180_270", "top3_000"):
        source, target = name.split("_")
        if source not in views or target not in views:
            continue
        i, j = views.index(source), views.index(target)
        world_from_source, world_from_target = result.poses[i], result.poses[j]
        if world_from_source is None or world_from_target is None:
            print(f"{source} -> {target}: not placed")
            continue
        truth = np.loadtxt(DATA / "stanford_scans" / f"bunny_{name}" / "T_target_source.txt")
        pose = np.linalg.inv(world_from_target) @ world_from_source
        errors = gmcr.evaluate(pose, truth, scans[i])
        print(
            f"{source} -> {target}: {errors.rotation_error_deg:.2f} deg, "
            f"{1e3 * (errors.mean_point_error or 0):.2f} mm off the truth"
        )


def draw(views: list[str], scans: list[Points], result: MultiviewResult, path: Path) -> None:
    """The scans as they came and in one frame, and which pairs agree."""
    import matplotlib.pyplot as plt  # type: ignore[import-not-found, unused-ignore]

    plt.switch_backend("agg")
    moved = [
        None if pose is None else scan @ pose[:3, :3].T + pose[:3, 3]
        for scan, pose in zip(scans, result.poses, strict=True)
    ]
    figure, (before, after, graph) = plt.subplots(
        1, 3, figsize=(15, 5.2), gridspec_kw={"width_ratios": [1, 1, 0.8]}
    )
    draw_clouds(before, scans)
    before.set_title(f"{len(scans)} scans, each in its own frame", loc="left")
    draw_clouds(after, moved)
    after.set_title("In one frame, without an initial guess", loc="left")
    draw_pairs(graph, views, result)
    figure.tight_layout()
    figure.savefig(path, dpi=130)


def draw_clouds(axes: Any, clouds: Sequence[Points | None]) -> None:
    """Shaded points from the front, near ones over far ones, coloured by scan."""
    from matplotlib.colors import to_rgb  # type: ignore[import-not-found, unused-ignore]

    placed = [(cloud, colour_of(i)) for i, cloud in enumerate(clouds) if cloud is not None]
    points = np.concatenate([cloud for cloud, _ in placed])
    colours = np.concatenate([np.outer(shades(cloud), to_rgb(colour)) for cloud, colour in placed])
    order = np.argsort(points[:, 2])  # the camera looks along -z
    axes.scatter(*points[order, :2].T, s=1.2, c=colours[order], linewidths=0, rasterized=True)
    axes.set_aspect("equal", adjustable="datalim")
    axes.axis("off")


def colour_of(scan: int) -> str:
    return COLOURS[scan % len(COLOURS)]


def shades(points: Points) -> npt.NDArray[np.float64]:
    """Brightness of each point of a surface under the light, in [0.35, 1]."""
    import open3d  # type: ignore[import-not-found, unused-ignore]

    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points))
    cloud.estimate_normals(open3d.geometry.KDTreeSearchParamKNN(20))
    return np.asarray(
        0.35 + 0.65 * np.abs(np.asarray(cloud.normals) @ LIGHT) / np.linalg.norm(LIGHT)
    )


def draw_pairs(axes: Any, views: list[str], result: MultiviewResult) -> None:
    """The scans on a circle, and a line for each pair that has a pose."""
    angles = np.pi / 2 - 2 * np.pi * np.arange(len(views)) / len(views)
    places = np.column_stack([np.cos(angles), np.sin(angles)])
    for judged in result.edges:
        if judged.edge.verdict == "untrusted":
            continue
        ends = places[[judged.edge.source, judged.edge.target]].T
        if judged.is_accepted:
            axes.plot(*ends, color="#333333", linewidth=2.5, zorder=1)
        else:
            axes.plot(*ends, color="#cc3311", linewidth=1.5, linestyle=(0, (3, 3)), zorder=0)
    axes.scatter(*places.T, s=1100, c=[colour_of(scan) for scan in range(len(views))], zorder=2)
    for view, place in zip(views, places, strict=True):
        axes.text(*place, view, ha="center", va="center", color="white", fontweight="bold")
    num_accepted = sum(judged.is_accepted for judged in result.edges)
    axes.set_title(
        f"{num_accepted} of {len(result.edges)} pairs agree; the dashed contradict them", loc="left"
    )
    axes.set_aspect("equal", adjustable="datalim")
    axes.margins(0.2)
    axes.axis("off")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=Path, default=Path("out/multiview"))
    parser.add_argument("--views", nargs="+", choices=FILES, default=["000", "090", "180", "270"])
    arguments = parser.parse_args()
    if not (DATA / "stanford_scans").is_dir():
        print(f"skipped: there is no {DATA / 'stanford_scans'}; GMCR_DATA names the folder of data")
        return
    if not (find_spec("open3d") and find_spec("matplotlib")):
        print("skipped: this needs pip install 'gmcr[multiview]' matplotlib")
        return

    views: list[str] = arguments.views
    scans = [read_points(DATA / "stanford_scans" / FILES[view]) for view in views]
    result = register_scans(scans, frontend=gmcr.FrontendOptions(max_attempts=2))
    for index, view in enumerate(views):
        print(f"scan {index} is view {view}")
    print(result.summary())
    print_errors(views, scans, result)

    arguments.output.mkdir(parents=True, exist_ok=True)
    merged = merge_scans(scans, result.poses, VOXEL_SIZE)
    write_points(arguments.output / "bunny.ply", merged)
    draw(views, scans, result, arguments.output / "bunny.png")
    print(f"{len(merged)} points in {arguments.output / 'bunny.ply'}, picture beside it")


if __name__ == "__main__":
    main()
