"""Draws two clouds before and after a registration, and the matches that agree with it."""

import argparse
import json
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

# Dark blue and light orange differ in lightness too, so the picture works in grey.
SOURCE_COLOUR = "#f28e2b"
TARGET_COLOUR = "#1f4e79"
INLIER_COLOUR = "#2a7f3f"
PLY_TYPES = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
             "float": "f4", "double": "f8", "float32": "f4", "float64": "f8", "uint8": "u1", "int32": "i4"}


def read_ply(path: Path) -> np.ndarray:
    """Vertices of a PLY file whose first element is the vertices, (N, 3)."""
    data = path.read_bytes()
    header, body = data.split(b"end_header", 1)
    body = body[body.index(b"\n") + 1:]
    lines = header.decode("ascii").split("\n")
    encoding = next(line.split()[1] for line in lines if line.startswith("format"))
    elements = [line.split() for line in lines if line.startswith("element")]
    count = int(elements[0][2])
    start = next(i for i, line in enumerate(lines) if line.startswith("element"))
    fields = []
    for line in lines[start + 1:]:
        if line.startswith("element"):
            break
        if line.startswith("property"):
            fields.append((line.split()[2], PLY_TYPES[line.split()[1]]))
    if encoding == "ascii":
        rows = np.array([line.split() for line in body.decode("ascii").split("\n")[:count]], dtype=float)
        names = [name for name, _ in fields]
        return rows[:, [names.index(axis) for axis in "xyz"]]
    order = "<" if encoding == "binary_little_endian" else ">"
    table = np.frombuffer(body, dtype=[(name, order + kind) for name, kind in fields], count=count)
    return np.stack([table[axis].astype(float) for axis in "xyz"], axis=1)


def view_axes(points: np.ndarray) -> np.ndarray:
    """Two axes to look along the direction in which the points vary least, up as y where it can be, (3, 2)."""
    _, _, directions = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)
    across, up = directions[:2]
    return np.stack([across if across[0] > 0 else -across, up if up[1] > 0 else -up], axis=1)


def draw_cloud(axis, points: np.ndarray, colour: str, label: str) -> None:
    axis.scatter(points[:, 0], points[:, 1], s=2.2, c=colour, linewidths=0, alpha=0.75, label=label, rasterized=True)


def tidy(axis, title: str, subtitle: str) -> None:
    axis.set_aspect("equal")
    axis.margins(0.04)
    axis.axis("off")
    axis.set_title(title, fontsize=15, fontweight="bold", loc="left", pad=26)
    axis.text(0, 1.02, subtitle, transform=axis.transAxes, fontsize=11, color="#444444", va="bottom")


def certificate_words(certificate: dict) -> str:
    if certificate["certified"]:
        return "proven: no pose has more"
    return f"at most {certificate['upper']} can agree"


def draw(source: np.ndarray, target: np.ndarray, result: dict, matches: np.ndarray, output: Path) -> None:
    pose = np.array(result["target_from_source"])
    aligned = source @ pose[:3, :3].T + pose[:3, 3]
    axes_2d = view_axes(target)
    source_2d, target_2d, aligned_2d = (cloud @ axes_2d for cloud in (source, target, aligned))
    # the third panel sets the aligned source beside the target, so that match lines do not collapse
    gap = np.array([1.15 * np.ptp(np.vstack([target_2d, aligned_2d])[:, 0]), 0])

    widths = [np.ptp(np.vstack([target_2d, source_2d])[:, 0]), np.ptp(np.vstack([target_2d, aligned_2d])[:, 0]),
              np.ptp(np.vstack([target_2d, aligned_2d + gap])[:, 0])]
    figure, (before, after, linked) = plt.subplots(
        1, 3, figsize=(17, 6.2), dpi=130, gridspec_kw={"width_ratios": widths, "wspace": 0.08})

    draw_cloud(before, target_2d, TARGET_COLOUR, f"target, {len(target):,} points")
    draw_cloud(before, source_2d, SOURCE_COLOUR, f"source, {len(source):,} points")
    tidy(before, "Before", "as scanned")
    before.legend(loc="upper left", bbox_to_anchor=(0, 0.02), frameon=False, fontsize=11, markerscale=5)

    draw_cloud(after, target_2d, TARGET_COLOUR, "target")
    draw_cloud(after, aligned_2d, SOURCE_COLOUR, "source")
    tidy(after, "After", f"fitness {100 * result['fitness']:.1f} %, overlap RMSE {result['overlap_rmse']:.2g}")

    inliers = np.array(result["inliers"], dtype=int)
    ends_source = (matches[inliers, :3] @ pose[:3, :3].T + pose[:3, 3]) @ axes_2d + gap
    ends_target = matches[inliers, 3:6] @ axes_2d
    draw_cloud(linked, target_2d, TARGET_COLOUR, "target")
    draw_cloud(linked, aligned_2d + gap, SOURCE_COLOUR, "source")
    linked.add_collection(LineCollection(np.stack([ends_target, ends_source], axis=1), colors=INLIER_COLOUR,
                                         linewidths=0.6, alpha=0.55))
    tidy(linked, "Matches that agree", f"{len(inliers)} of {result['num_correspondences']} are inliers; "
         + certificate_words(result["certificate"]))

    output.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(output, bbox_inches="tight", facecolor="white", pad_inches=0.25)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("--source", "--target", "--result", "--matches", "--output"):
        parser.add_argument(name, type=Path, required=True)
    arguments = parser.parse_args()
    draw(read_ply(arguments.source), read_ply(arguments.target), json.loads(arguments.result.read_text()),
         np.loadtxt(arguments.matches, delimiter=",", skiprows=1, ndmin=2), arguments.output)


if __name__ == "__main__":
    main()
