"""The paper's synthetic benchmarks: what is proven, and whose failure a failure is."""

from reports.markdown import (
    bounds_note,
    hardware,
    limits_note,
    milliseconds,
    number,
    percent,
    table,
)
from reports.records import (
    by_method,
    count_of,
    group_by,
    mean_gap,
    median_of,
    methods_in,
    quantile_of,
)

COUNTING = {"gmcr-count", "paper"}  # their evidence is the number of inliers

NOTE = (
    "Certified: proven that no pose has more inliers / more evidence; gap: mean of upper - lower "
    "where not. Wrong: a mean point error of 0.3 m or more. Truth beaten: the pose is wrong and "
    "has at least the evidence of the truth, by the method's own objective, so it is the "
    "objective that fails. Missed: the truth has more evidence than the pose, so the search fell "
    "short of the maximum; in brackets those of them where the pose is wrong.\n"
)


def report(records):
    text = "# As it comes\n\n" + hardware(records) + f"{protocol(records)}\n{NOTE}\n"
    return text + tables(records, with_time=False)


def report_certified(records):
    """The same problems with the time that is left spent on the certificate."""
    limits = {r.get("time_limit") for r in records if r["method"] == "gmcr-certify"} - {None}
    limit = number(max(limits, default=None))
    text = "# With certify\n\n" + hardware(records)
    text += (
        f"{protocol(records)} `gmcr-certify` spends what the search leaves of {limit} s on the "
        "certificate.\n\n"
    )
    return text + tables(records, with_time=True)


def tables(records, with_time):
    text = ""
    for (kind,), group in group_by(records, "scenario").items():
        text += f"## {kind} outliers, N = {group[0]['num_correspondences']}\n\n"
        text += certificate_table(group, with_time) + "\n"
    return text + bounds_note(records) + limits_note(records)


def protocol(records):
    seeds = len({record["seed"] for record in records})
    models = ", ".join(sorted({record["model"] for record in records}))
    return f"Models: {models}; {seeds} seeds each."


def time_cell(records):
    late = quantile_of(records, 0.9, "wall_ms")
    return f"{milliseconds(median_of(records, 'wall_ms'))} ({milliseconds(late)})"


def certificate_table(records, with_time):
    """What was proven, whose failure the failures are and, where `with_time`, what that takes."""
    methods = methods_in(records)
    header = ["outliers %"]
    for method in methods:
        header += [f"{method}: certified %", "gap", "truth beaten %", "missed % (wrong)"]
        header += ["median ms (p90)"] if with_time else []
    rows = []
    for (rate,), at_rate in sorted(group_by(records, "outlier_rate").items()):
        row = [f"{100 * rate:.0f}"]
        for method, mine in zip(methods, by_method(at_rate, methods), strict=True):
            row += certificate_cells(mine, both=method not in COUNTING) if mine else ["-"] * 4
            row += [time_cell(mine)] if with_time else []
        rows.append(row)
    return table(header, rows)


def certificate_cells(records, both):
    """Of inliers and, where `both`, of evidence: share certified and gap; beaten; missed."""
    total = len(records)
    certified = [percent(count_of(records, "certificate", "certified"), total)]
    gaps = [number(mean_gap(records, "certificate"), 2)]
    if both:
        certified.append(percent(count_of(records, "certificate", "evidence", "certified"), total))
        gaps.append(number(mean_gap(records, "certificate", "evidence"), 2))
    wrong = [record for record in records if not record["success"]]
    missed = percent(count_of(records, "missed"), total)
    return [
        " / ".join(certified),
        " / ".join(gaps),
        percent(count_of(records, "truth_is_beaten"), total),
        f"{missed} ({percent(count_of(wrong, 'missed'), total)})",
    ]
