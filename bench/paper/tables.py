"""Tables of the experiments, from the records only."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from statistics import median

from reports.markdown import milliseconds, table
from reports.records import group_by

from paper.figures.style import methods_of
from paper.methods import look_of
from paper.statistics import (
    errors,
    mean_and_deviation,
    quartiles,
    success_rate,
    times_ms,
)

Records = Sequence[dict]


def of_method(records: Records, method: str) -> list[dict]:
    return [record for record in records if record["method"] == method]


def label_of(method: str) -> str:
    return look_of(method).label


def number(value: float, digits: int = 3) -> str:
    """A number for a cell; "none" where most runs have no pose."""
    if math.isnan(value):
        return "-"
    return "none" if math.isinf(value) else f"{value:.{digits}g}"


def success_cell(records: Records) -> str:
    """Success in per cent with its Wilson interval."""
    if not records:
        return "-"
    rate = success_rate(records)
    return f"{100 * rate.share:.0f} ({100 * rate.low:.0f}-{100 * rate.high:.0f})"


def time_cell(records: Records) -> str:
    """Median and quartiles in milliseconds, "> limit" where the run was ended."""
    if not records:
        return "-"
    limit = 1e3 * max(record["time_limit"] for record in records)
    summary = quartiles(times_ms(records))
    low, middle, high = (
        f"> {milliseconds(limit)}" if math.isinf(value) else milliseconds(value)
        for value in (summary.low, summary.median, summary.high)
    )
    return f"{middle} ({low}-{high})"


def spread_cell(records: Records, name: str) -> str:
    """Mean and standard deviation of an error over the runs with a pose, and how many have one."""
    if not records:
        return "-"
    values = errors(records, name)
    mean, deviation = mean_and_deviation(values)
    if math.isnan(mean):
        return "none"
    with_pose = sum(map(math.isfinite, values))
    count = "" if with_pose == len(values) else f" ({with_pose} of {len(values)})"
    return f"{number(mean)} ± {number(deviation, 2)}{count}"


def quartiles_cell(records: Records, name: str) -> str:
    """Median and quartiles of an error over all runs, infinite where there is no pose."""
    if not records:
        return "-"
    summary = quartiles(errors(records, name))
    return f"{number(summary.median)} ({number(summary.low, 2)}-{number(summary.high, 2)})"


def point_cell(records: Records) -> str:
    return quartiles_cell(records, "mean_point")


def over_field(
    records: Records, field: str, header: str, shown: Callable[[float], str], cell: Callable
) -> str:
    """A row a value of the field, a column a method."""
    methods = methods_of(records)
    rows = [
        [shown(value), *(cell(of_method(group, method)) for method in methods)]
        for (value,), group in sorted(group_by(records, field).items())
    ]
    return table([header, *map(label_of, methods)], rows)


def percent(value: float) -> str:
    return f"{100 * value:g}"


def synthetic(records: Records) -> str:
    text = ""
    for (count,), group in sorted(group_by(records, "num_correspondences").items()):
        text += f"N = {count}: success in per cent, with its Wilson interval at 95 %.\n\n"
        text += over_field(group, "outlier_rate", "outliers %", percent, success_cell) + "\n"
        text += f"N = {count}: mean point error in m, median (quartiles).\n\n"
        text += over_field(group, "outlier_rate", "outliers %", percent, point_cell) + "\n"
        text += f"N = {count}: time in ms, median (quartiles).\n\n"
        text += over_field(group, "outlier_rate", "outliers %", percent, time_cell) + "\n"
    return text + exactness(records)


def exactness(records: Records) -> str:
    """How often the exact search proved its consensus a maximum, and who reached it."""
    exact = {record["input_hash"]: record for record in of_method(records, "gmcr-exact")}
    proven = {
        key: r for key, r in exact.items() if r["certificate"] and r["certificate"]["certified"]
    }
    if not exact:
        return ""
    text = (
        f"The exact search proved its consensus a maximum one in {len(proven)} of {len(exact)} "
        "problems. Share of these in which a method's pose has as many inliers:\n\n"
    )
    rows = []
    for method in methods_of(records, ["gmcr-exact"]):
        mine = [r for r in of_method(records, method) if r["input_hash"] in proven]
        reached = sum(
            (r["num_inliers"] or 0) >= proven[r["input_hash"]]["num_inliers"] for r in mine
        )
        if mine:
            rows.append([label_of(method), f"{reached} of {len(mine)}"])
    return text + table(["method", "maximum reached"], rows) if rows else text


def structured(records: Records) -> str:
    text = ""
    for (kind,), group in group_by(records, "kind").items():
        text += f"{kind.capitalize()} outliers: success in per cent.\n\n"
        text += over_field(group, "outlier_rate", "outliers %", percent, success_cell) + "\n"
        text += f"{kind.capitalize()} outliers: mean point error in m, median (quartiles).\n\n"
        text += over_field(group, "outlier_rate", "outliers %", percent, point_cell) + "\n"
    mine = [record for record in records if record["kind"] == "structured"]
    text += "Structured outliers: time in ms, median (quartiles).\n\n"
    return text + over_field(mine, "outlier_rate", "outliers %", percent, time_cell)


def objects(records: Records) -> str:
    text = ""
    for (setting,), group in group_by(records, "setting").items():
        methods = methods_of(group)
        text += f"{setting}: ADD, mean ± standard deviation over the runs with a pose.\n\n"
        rows = [
            [
                f"{set_name}/{name}",
                right_matches(mine),
                *(spread_cell(of_method(mine, m), "mean_point") for m in methods),
            ]
            for (set_name, name), mine in group_by(group, "set", "object").items()
        ]
        rows.append(["success %", "", *(success_cell(of_method(group, m)) for m in methods)])
        rows.append(["time ms", "", *(time_cell(of_method(group, m)) for m in methods)])
        text += table(["object", "right matches", *map(label_of, methods)], rows) + "\n"
    return text


def right_matches(records: Records) -> str:
    """Median number of right matches of all, over the problems."""
    problems = list({record["input_hash"]: record for record in records}.values())
    right, total = (
        median(record[field] for record in problems)
        for field in ("num_true_inliers", "num_correspondences")
    )
    return f"{right:g} of {total:g}"


def lidar(records: Records) -> str:
    header = ["method", "R [deg]", "t [m]", "R, all runs", "t, all runs", "success %", "time ms"]
    rows = []
    for method in methods_of(records):
        mine = of_method(records, method)
        right = [record for record in mine if record["success"]]
        rows.append(
            [
                label_of(method),
                spread_cell(right, "rotation_deg"),
                spread_cell(right, "translation"),
                quartiles_cell(mine, "rotation_deg"),
                quartiles_cell(mine, "translation"),
                success_cell(mine),
                time_cell(mine),
            ]
        )
    text = "R and t: mean ± standard deviation of the successes; all runs: median (quartiles).\n\n"
    text += table(header, rows) + "\nTranslation error in m by scan, median (quartiles).\n\n"
    return text + over_field(
        records, "scan", "scan", str, lambda mine: quartiles_cell(mine, "translation")
    )


def real(records: Records) -> str:
    header = ["set", "method", "success %", "R [deg], all runs", "time ms"]
    rows = []
    for (set_name,), group in group_by(records, "set").items():
        for method in methods_of(group):
            mine = of_method(group, method)
            error = quartiles_cell(mine, "rotation_deg")
            rows.append([set_name, label_of(method), success_cell(mine), error, time_cell(mine)])
    return table(header, rows)


def noise(records: Records) -> str:
    text = ""
    for (set_name,), group in group_by(records, "set").items():
        text += f"{set_name}: success in per cent.\n\n"
        text += over_field(group, "bound_factor", "bound / customary", "{:g}".format, success_cell)
        text += "\n"
    return text


def scaling(records: Records) -> str:
    methods = methods_of(records)
    rows = []
    groups = sorted(group_by(records, "num_correspondences", "outlier_rate").items())
    for (count, rate), group in groups:
        row = [f"{count:,}", percent(rate)]
        for method in methods:
            mine = of_method(group, method)
            right = sum(record["success"] for record in mine)
            row.append(f"{time_cell(mine)}; {right} of {len(mine)}" if mine else "-")
        rows.append(row)
    text = "Time in ms, median (quartiles); right poses.\n\n"
    return text + table(["N", "outliers %", *map(label_of, methods)], rows)


TABLES = {
    "synthetic": synthetic,
    "structured": structured,
    "objects": objects,
    "lidar": lidar,
    "real": real,
    "noise": noise,
    "scaling": scaling,
}
