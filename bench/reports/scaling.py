"""Time and success over the number of correspondences."""

from reports.markdown import bounds_note, count_cell, hardware, limits_note, milliseconds, table
from reports.records import by_method, group_by, median_of, methods_in, quantile_of


def report(records):
    text = "# Time and success over the number of correspondences\n\n" + hardware(records)
    text += (
        "Uniform points in a unit cube, noise 0.01, random outliers in the bounding ball. Right: 5 degrees, 0.1 m, 5 % of "
        "the scale. Certified: proven that no pose has more inliers (count), or more evidence.\n\n"
    )
    for (scenario,), group in group_by(records, "scenario").items():
        text += f"## {scenario}\n\n" + scenario_table(group) + "\n"
    return text + bounds_note(records) + limits_note(records)


def scenario_table(records):
    """A row a problem size and outlier rate."""
    methods = methods_in(records)
    header = ["N", "outliers %"]
    for method in methods:
        header += [f"{method}: median ms (p90)", "right", "certified: count", "evidence"]
    rows = []
    for (count, rate), group in group_by(records, "num_correspondences", "outlier_rate").items():
        row = [f"{count:,}", f"{100 * rate:g}"]
        for mine in by_method(group, methods):
            row += [
                f"{milliseconds(median_of(mine, 'wall_ms'))} ({milliseconds(quantile_of(mine, 0.9, 'wall_ms'))})",
                count_cell(mine, "success"),
                count_cell(mine, "certificate", "certified"),
                count_cell(mine, "certificate", "evidence", "certified"),
            ]
        rows.append(row)
    return table(header, rows)
