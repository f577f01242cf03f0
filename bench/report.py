#!/usr/bin/python3
"""Turns the records of the benchmarks (*.jsonl) into Markdown tables (*.md) and figures (*.png)."""

import argparse
import json
import math
import statistics
import sys
from collections import defaultdict
from pathlib import Path

METHOD_ORDER = ["gmcr", "gmcr-count", "paper"]


def read_records(path):
    """Records of a file, [] where it is absent."""
    if not path.exists():
        print(f"skipped: {path} is absent", file=sys.stderr)
        return []
    with path.open() as lines:
        return [json.loads(line) for line in lines]


def group_by(records, *fields):
    """Records by the values of the fields, in order of first appearance."""
    groups = defaultdict(list)
    for record in records:
        groups[tuple(record[field] for field in fields)].append(record)
    return groups


def wilson(successes, total):
    """Wilson interval of a success rate at 95 %."""
    z = 1.96
    rate = successes / total
    middle = (rate + z * z / (2 * total)) / (1 + z * z / total)
    half = z * math.sqrt(rate * (1 - rate) / total + z * z / (4 * total * total)) / (1 + z * z / total)
    return max(0.0, middle - half), min(1.0, middle + half)


def success_cell(records):
    successes = sum(record["success"] for record in records)
    low, high = wilson(successes, len(records))
    return f"{100 * successes / len(records):.0f} ({100 * low:.0f}-{100 * high:.0f})"


def median_of(records, *path):
    """Median of a nested field over the records that have it, None where none has."""
    values = []
    for record in records:
        for key in path:
            record = record.get(key) if isinstance(record, dict) else None
        if record is not None:
            values.append(record)
    return statistics.median(values) if values else None


def number(value, digits=3):
    return "-" if value is None else f"{value:.{digits}g}"


def milliseconds(value):
    return "-" if value is None else f"{value:.3g}" if value < 1000 else f"{value:,.0f}"


def table(header, rows):
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines) + "\n"


def hardware(records):
    first = records[0]
    threads = sorted({record["threads"] for record in records if "threads" in record})
    return (
        f"gmcr {first['version']}; {first['cpu']}, {first['isa']}, {first['cores']} cores; "
        f"threads: {', '.join(map(str, threads)) or 'default'}.\n"
    )


def methods_in(records):
    present = {record["method"] for record in records}
    return [m for m in METHOD_ORDER if m in present] + sorted(present - set(METHOD_ORDER))


def limits_note(records):
    bound = sum(bool(record.get("limits_hit")) for record in records)
    return f"A budget bound in {bound} of {len(records)} runs.\n" if bound else ""


def report_correspondences(records):
    methods = methods_in(records)
    text = "# Real correspondences, known scale\n\n" + hardware(records)
    repetitions = records[0].get("repetitions", 1)
    text += (
        "Success: 5 degrees and 0.6 m (kitti_fpfh, noise bound 0.6 m); 5 degrees (gore, noise bound 2 x the listed "
        f"resolution). The source is first turned by a random rotation. Median time of {repetitions} solves.\n\n"
    )
    summary = []
    for (name,), group in group_by(records, "set").items():
        for method in methods:
            mine = [r for r in group if r["method"] == method]
            right = sum(r["success"] for r in mine)
            certified = sum(r.get("certificate", {}).get("certified", False) for r in mine)
            summary.append(
                [name, method, f"{right} of {len(mine)}", f"{certified} of {len(mine)}", milliseconds(median_of(mine, "wall_ms"))]
            )
    text += table(["set", "method", "right", "certified", "median ms"], summary) + "\n"
    rows = []
    for record in records:
        certificate = record.get("certificate", {})
        rows.append(
            [
                record["scenario"],
                record["num_correspondences"],
                record["num_true_inliers"],
                record["method"],
                "right" if record["success"] else f"**wrong** ({record['status']})",
                number(record.get("errors", {}).get("rotation_deg")),
                number(record.get("errors", {}).get("translation")),
                record.get("num_inliers", "-"),
                f"{certificate.get('lower', '-')} / {certificate.get('upper', '-')}",
                milliseconds(record.get("wall_ms")),
            ]
        )
    header = ["pair", "N", "true inliers", "method", "pose", "rotation deg", "translation", "inliers", "lower / upper", "ms"]
    return text + table(header, rows) + "\n" + limits_note(records)


def report_paper_synthetic(records):
    text = "# The paper's synthetic benchmarks, unknown scale\n\n" + hardware(records)
    methods = methods_in(records)
    seeds = len({record["seed"] for record in records})
    models = ", ".join(sorted({record["model"] for record in records}))
    text += f"Models: {models}; {seeds} seeds each. Success: mean point error < 0.3 m; Wilson intervals at 95 %.\n\n"
    for (kind,), group in group_by(records, "scenario").items():
        text += f"## {kind} outliers, N = {group[0]['num_correspondences']}\n\n"
        header = ["outliers %"]
        for method in methods:
            header += [f"{method}: success %", "median error", "median ms"]
        rows = []
        for (rate,), at_rate in sorted(group_by(group, "outlier_rate").items()):
            row = [f"{100 * rate:.0f}"]
            for method in methods:
                mine = [r for r in at_rate if r["method"] == method]
                row += [
                    success_cell(mine) if mine else "-",
                    number(median_of(mine, "errors", "mean_point")),
                    milliseconds(median_of(mine, "wall_ms")),
                ]
            rows.append(row)
        text += table(header, rows) + "\n"
    return text + limits_note(records)


def report_scaling(records):
    text = "# Time and success over the number of correspondences\n\n" + hardware(records)
    methods = methods_in(records)
    text += (
        "Uniform points in a unit cube, noise 0.01, random outliers in the bounding ball. Median time in ms; right runs "
        "of all in brackets where some fail (5 degrees, 0.1 m, 5 % of the scale).\n\n"
    )
    for (scenario,), group in group_by(records, "scenario").items():
        text += f"## {scenario}\n\n"
        rates = sorted({record["outlier_rate"] for record in group})
        rows = []
        for method in methods:
            for (count,), mine in sorted(group_by([r for r in group if r["method"] == method], "num_correspondences").items()):
                row = [method, f"{count:,}"]
                for rate in rates:
                    cell = [r for r in mine if r["outlier_rate"] == rate]
                    row.append(scaling_cell(cell) if cell else "")
                rows.append(row)
        text += table(["method", "N"] + [f"{100 * rate:g} %" for rate in rates], rows) + "\n"
    return text + limits_note(records)


def scaling_cell(records):
    right = sum(record["success"] for record in records)
    note = "" if right == len(records) else f" ({right} of {len(records)})"
    return milliseconds(median_of(records, "wall_ms")) + note


def report_clouds(records):
    text = "# Raw clouds, default options\n\n" + hardware(records)
    text += (
        "`gmcr register SOURCE TARGET` on each pair. Right: 5 degrees and a mean point error within 5 % of the target's "
        "extent (its largest side). Pairs that hardly move are turned first. "
        "`time` is the tool's own, `wall` that of the process.\n\n"
    )
    summary = []
    for (refine, name), group in sorted(group_by(records, "refine", "set").items()):
        right = sum(record["success"] for record in group)
        strict = sum(record.get("success_of_translation", False) for record in group)
        trusted = [r for r in group if r.get("verdict") == "trusted"]
        wrong_trusted = sum(not r["success"] for r in trusted)
        summary.append([refine, name, f"{right} of {len(group)}", f"{strict} of {len(group)}", len(trusted), wrong_trusted])
    header = ["refine", "set", "right", "right by translation", "trusted", "trusted but wrong"]
    text += table(header, summary) + "\n"
    rows = [cloud_row(record) for record in records]
    header = [
        "pair", "refine", "points", "voxel", "matches", "inliers", "pose", "rotation deg", "translation (% of extent)",
        "point error %", "fitness", "verdict", "time ms", "wall ms",
    ]
    return text + table(header, rows)


def cloud_row(record):
    errors = record.get("errors", {})
    extent_share = errors.get("translation_of_extent")
    point_share = errors.get("mean_point_of_extent")
    return [
        record["scenario"],
        record["refine"],
        f"{record.get('num_source_points', '-')} / {record.get('num_target_points', '-')}",
        number(record.get("voxel_size")),
        record.get("num_correspondences", "-"),
        record.get("num_inliers", "-"),
        "right" if record["success"] else f"**wrong** ({record.get('status', '-')})",
        number(errors.get("rotation_deg")),
        f"{number(errors.get('translation'))} ({number(None if extent_share is None else 100 * extent_share)})",
        number(None if point_share is None else 100 * point_share),
        number(record.get("fitness")),
        record.get("verdict", "-"),
        milliseconds(record.get("time_ms", {}).get("total")),
        milliseconds(record.get("wall_ms")),
    ]


def draw_success(records, path):
    """Success over the outlier rate with Wilson intervals, one panel a benchmark."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    kinds = group_by(records, "scenario")
    figure, panels = pyplot.subplots(1, len(kinds), figsize=(5.5 * len(kinds), 4), squeeze=False)
    for panel, ((kind,), group) in zip(panels[0], kinds.items()):
        for method in methods_in(group):
            rates, middles, lows, highs = [], [], [], []
            for (rate,), mine in sorted(group_by([r for r in group if r["method"] == method], "outlier_rate").items()):
                successes = sum(record["success"] for record in mine)
                low, high = wilson(successes, len(mine))
                rates.append(100 * rate)
                middles.append(100 * successes / len(mine))
                lows.append(100 * low)
                highs.append(100 * high)
            panel.plot(rates, middles, marker="o", markersize=3, label=method)
            panel.fill_between(rates, lows, highs, alpha=0.15)
        runs = len(group) // len({(r["outlier_rate"], r["method"]) for r in group})
        panel.set_title(f"{kind} outliers, N = {group[0]['num_correspondences']}, {runs} runs a point")
        panel.set_xlabel("outliers, %")
        panel.set_ylabel("success, %")
        panel.set_ylim(-3, 103)
        panel.grid(alpha=0.3)
        panel.legend()
    figure.text(0.01, 0.01, hardware(records).strip(), fontsize=6)
    figure.tight_layout(rect=(0, 0.03, 1, 1))
    figure.savefig(path, dpi=150)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, nargs="?", default=Path("out/bench"), help="where the records are")
    folder = parser.parse_args().folder
    reports = {
        "correspondences": report_correspondences,
        "paper_synthetic": report_paper_synthetic,
        "scaling": report_scaling,
        "clouds": report_clouds,
    }
    for name, report in reports.items():
        records = read_records(folder / f"{name}.jsonl")
        if not records:
            continue
        path = folder / f"{name}.md"
        path.write_text(report(records))
        print(path)
        if name == "paper_synthetic":
            draw_success(records, folder / "paper_synthetic.png")
            print(folder / "paper_synthetic.png")


if __name__ == "__main__":
    main()
