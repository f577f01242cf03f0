"""Time, memory and success over the number of correspondences and the share of outliers."""

import math

from reports.markdown import bounds_note, count_cell, hardware, limits_note, milliseconds, number, table
from reports.records import by_method, group_by, median_of, methods_in, quantile_of, values_of

# scenario, N, outlier rate: the most milliseconds and megabytes that the project allows itself
BUDGETS = {
    ("known scale", 1000, 0.95): (2, None),
    ("known scale", 5000, 0.95): (20, None),
    ("known scale", 10000, 0.99): (100, None),
    ("known scale", 50000, 0.99): (3000, None),
    ("known scale", 100000, 0.99): (15000, 2000),
    ("unknown scale", 200, 0.95): (3, None),
    ("unknown scale", 500, 0.95): (20, None),
    ("unknown scale", 1000, 0.98): (120, None),
    ("unknown scale", 1000, 0.9): (50, None),
    ("unknown scale", 10000, 0.9): (3000, 500),
}
SWEPT_SIZE = 5000  # correspondences of the sweep over the outlier rate
MEGABYTE = 1e6


def report(records, before):
    text = "# Time and memory over the number of correspondences\n\n" + hardware(records)
    text += (
        "Uniform points in a unit cube, noise 0.01, random outliers in the bounding ball. Right: 5 degrees, 0.1 m, 5 % of "
        "the scale. Certified: proven that no pose has more inliers (count), or more evidence. Memory: peak of the "
        "process, which draws the problem too and may keep what an earlier one took.\n\n"
    )
    text += "## Budgets\n\n" + budget_table(records, before) + "\n" + sweep_note(records)
    text += "\n## Stages, ms\n\n" + stage_table(records) + "\n"
    for (scenario,), group in group_by(records, "scenario").items():
        text += f"## {scenario}\n\n" + scenario_table(group) + "\n"
    return text + bounds_note(records) + limits_note(records)


def default_method(records):
    return [record for record in records if record["method"] == "gmcr"]


def cases_of(records):
    return group_by(default_method(records), "scenario", "num_correspondences", "outlier_rate")


def megabytes(records):
    peak = max(values_of(records, "peak_memory_bytes"), default=None)
    return "-" if peak is None else f"{peak / MEGABYTE:.0f}"


def budget_table(records, before):
    """What the default method took against what it may take, and what it took before."""
    cases, cases_before = cases_of(records), cases_of(before)
    header = ["scenario", "N", "outliers %", "budget ms", "ms", "budget MB", "MB", "right"]
    header += ["before: ms", "MB", "times faster"] if before else []
    rows = []
    for case, (most_ms, most_mb) in BUDGETS.items():
        mine = cases.get(case, [])
        if not mine:
            continue
        took = median_of(mine, "wall_ms")
        row = [case[0], f"{case[1]:,}", f"{100 * case[2]:g}", f"{most_ms:,}", milliseconds(took)]
        row += [f"{most_mb:,}" if most_mb else "-", megabytes(mine), count_cell(mine, "success")]
        if before:
            old = cases_before.get(case, [])
            took_before = median_of(old, "wall_ms")
            ratio = took_before / took if took_before else None
            row += [milliseconds(took_before), megabytes(old), number(ratio, 2)]
        rows.append(row)
    return table(header, rows)


def sweep(records):
    """Outlier rates of the sweep, percent, and the quartiles of the time at each."""
    group = [r for r in default_method(records) if r["scenario"] == "known scale"]
    group = [r for r in group if r["num_correspondences"] == SWEPT_SIZE]
    points = []
    for (rate,), mine in sorted(group_by(group, "outlier_rate").items()):
        points.append((100 * rate, *(quantile_of(mine, share, "wall_ms") for share in (0.25, 0.5, 0.75))))
    return points


def sweep_note(records):
    times = [middle for _, _, middle, _ in sweep(records)]
    if not times:
        return ""
    return (
        f"N = {SWEPT_SIZE:,}, known scale, from 0 to 99 % outliers: {milliseconds(min(times))} to "
        f"{milliseconds(max(times))} ms, slowest over fastest {max(times) / min(times):.1f}.\n"
    )


def stage_table(records):
    """Median times of the stages of the default method for the cases that have a budget."""
    cases = {case: mine for case, mine in cases_of(records).items() if case in BUDGETS}
    stages = list(dict.fromkeys(name for mine in cases.values() for r in mine for name in r.get("stages_ms", {})))
    rows = []
    for (scenario, count, rate), mine in cases.items():
        row = [scenario, f"{count:,}", f"{100 * rate:g}"]
        rows.append(row + [milliseconds(median_of(mine, "stages_ms", stage)) for stage in stages])
    return table(["scenario", "N", "outliers %", *stages], rows)


def scenario_table(records):
    """A row a problem size and outlier rate."""
    methods = methods_in(records)
    header = ["N", "outliers %"]
    for method in methods:
        header += [f"{method}: median ms (p90)", "MB", "right", "certified: count", "evidence"]
    rows = []
    for (count, rate), group in group_by(records, "num_correspondences", "outlier_rate").items():
        row = [f"{count:,}", f"{100 * rate:g}"]
        for mine in by_method(group, methods):
            row += [
                f"{milliseconds(median_of(mine, 'wall_ms'))} ({milliseconds(quantile_of(mine, 0.9, 'wall_ms'))})",
                megabytes(mine),
                count_cell(mine, "success"),
                count_cell(mine, "certificate", "certified"),
                count_cell(mine, "certificate", "evidence", "certified"),
            ]
        rows.append(row)
    return table(header, rows)


def draw(records, path):
    """Time and memory over N, both axes logarithmic, and time over the outlier rate."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (times, memory, rates) = pyplot.subplots(1, 3, figsize=(14, 4.2))
    curves = [("known scale", 0.9, "o-"), ("known scale", 0.99, "s--"), ("unknown scale", 0.9, "^:")]
    for scenario, rate, style in curves:
        mine = [r for r in default_method(records) if r["scenario"] == scenario and r["outlier_rate"] == rate]
        points = [
            (n, median_of(group, "wall_ms"), max(values_of(group, "peak_memory_bytes"), default=math.nan) / MEGABYTE)
            for (n,), group in sorted(group_by(mine, "num_correspondences").items())
        ]
        if not points:
            continue
        sizes, milliseconds_taken, peaks = zip(*points)
        label = f"{scenario}, {100 * rate:g} % outliers"
        times.loglog(sizes, milliseconds_taken, style, markersize=4, label=label + slope_label(points))
        memory.loglog(sizes, peaks, style, markersize=4, label=label)
    points = sweep(records)
    if points:
        shares, lows, middles, highs = zip(*points)
        rates.plot(shares, middles, "o-", markersize=4)
        rates.fill_between(shares, lows, highs, alpha=0.2)
        rates.set_ylim(bottom=0)
        rates.set_title(f"N = {SWEPT_SIZE:,}, known scale")
    for panel, across, up in ((times, "correspondences", "ms"), (memory, "correspondences", "MB"), (rates, "outliers, %", "ms")):
        panel.set_xlabel(across)
        panel.set_ylabel(up)
        panel.grid(alpha=0.3, which="both")
    times.legend(fontsize=7)
    memory.legend(fontsize=7)
    times.set_title("time")
    memory.set_title("peak memory of the process")
    figure.text(0.01, 0.01, hardware(records).strip(), fontsize=6)
    figure.tight_layout(rect=(0, 0.03, 1, 1))
    figure.savefig(path, dpi=150)


def slope_label(points):
    """Slope of the logarithm of the time over that of N, by least squares from N = 1,000 on."""
    large = [(math.log(point[0]), math.log(point[1])) for point in points if point[0] >= 1000]
    if len(large) < 2:
        return ""
    mean_x, mean_y = (sum(values) / len(large) for values in zip(*large))
    slope = sum((x - mean_x) * (y - mean_y) for x, y in large) / sum((x - mean_x) ** 2 for x, _ in large)
    return f" (slope {slope:.2f} from 1,000 on)"
