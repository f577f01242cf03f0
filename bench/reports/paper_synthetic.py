"""The paper's synthetic benchmarks: success, certificates, and whose failure a failure is."""

from reports.markdown import bounds_note, hardware, limits_note, milliseconds, number, percent, success_cell, table
from reports.records import by_method, count_of, group_by, mean_gap, median_of, methods_in, quantile_of, wilson

COUNTING = {"gmcr-count", "paper"}  # their evidence is the number of inliers

SUCCESS_NOTE = "Success: mean point error < 0.3 m; Wilson intervals at 95 %."
CERTIFICATE_NOTE = (
    "Certified: proven that no pose has more inliers / more evidence; gap: mean of upper - lower where not. "
    "Truth beaten: the pose is wrong and has at least the evidence of the truth, by the method's own objective, so it is "
    "the objective that fails. Missed: the truth has more evidence than the pose, so the search fell short of the "
    "maximum; in brackets those of them where the pose is wrong.\n"
)


def report(records):
    text = "# The paper's synthetic benchmarks, unknown scale\n\n" + hardware(records)
    text += f"{protocol(records)} {SUCCESS_NOTE}\n"
    text += CERTIFICATE_NOTE + "\n"
    for (kind,), group in group_by(records, "scenario").items():
        text += f"## {kind} outliers, N = {group[0]['num_correspondences']}\n\n"
        text += success_table(group) + "\n" + certificate_table(group) + "\n"
    return text + bounds_note(records) + limits_note(records)


def report_certified(records):
    """The same problems with the time that is left spent on the certificate."""
    limits = {r.get("time_limit") for r in records if r["method"] == "gmcr-certify"} - {None}
    text = "# The paper's synthetic benchmarks, certified\n\n" + hardware(records)
    text += (
        f"{protocol(records)} `gmcr-certify` spends what the search leaves of {number(max(limits, default=None))} s on "
        f"the certificate. {SUCCESS_NOTE}\n{CERTIFICATE_NOTE}\n"
    )
    for (kind,), group in group_by(records, "scenario").items():
        text += f"## {kind} outliers, N = {group[0]['num_correspondences']}\n\n"
        text += success_table(group) + "\n" + certificate_table(group) + "\n"
    return text + bounds_note(records) + limits_note(records)


def protocol(records):
    seeds = len({record["seed"] for record in records})
    models = ", ".join(sorted({record["model"] for record in records}))
    return f"Models: {models}; {seeds} seeds each."


def success_table(records):
    methods = methods_in(records)
    header = ["outliers %"]
    for method in methods:
        header += [f"{method}: success %", "median error", "median ms (p90)"]
    rows = []
    for (rate,), at_rate in sorted(group_by(records, "outlier_rate").items()):
        row = [f"{100 * rate:.0f}"]
        for mine in by_method(at_rate, methods):
            row += [success_cell(mine), number(median_of(mine, "errors", "mean_point")), time_cell(mine)]
        rows.append(row)
    return table(header, rows)


def time_cell(records):
    return f"{milliseconds(median_of(records, 'wall_ms'))} ({milliseconds(quantile_of(records, 0.9, 'wall_ms'))})"


def certificate_table(records):
    """What was proven, and whose failure the failures are."""
    methods = methods_in(records)
    header = ["outliers %"]
    for method in methods:
        header += [f"{method}: certified %", "gap", "truth beaten %", "missed % (wrong)"]
    rows = []
    for (rate,), at_rate in sorted(group_by(records, "outlier_rate").items()):
        row = [f"{100 * rate:.0f}"]
        for method, mine in zip(methods, by_method(at_rate, methods)):
            row += certificate_cells(mine, both=method not in COUNTING) if mine else ["-"] * 4
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


def draw_success(records, path):
    """Success over the outlier rate with Wilson intervals, one panel a benchmark."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    kinds = group_by(records, "scenario")
    figure, panels = pyplot.subplots(1, len(kinds), figsize=(5.5 * len(kinds), 4), squeeze=False)
    for panel, ((kind,), group) in zip(panels[0], kinds.items()):
        methods = methods_in(group)
        for method, mine in zip(methods, by_method(group, methods)):
            rates, middles, lows, highs = success_curve(mine)
            panel.plot(rates, middles, marker="o", markersize=3, label=method)
            panel.fill_between(rates, lows, highs, alpha=0.15)
        runs = len(group) // len({(r["outlier_rate"], r["method"]) for r in group})
        panel.set_title(f"{kind} outliers, N = {group[0]['num_correspondences']}, {runs} runs a point")
        panel.set_xlabel("outliers, %")
        panel.set_ylabel("success, %")
        panel.set_ylim(-3, 103)
        panel.grid(alpha=0.3)
        panel.legend()
    figure.text(0.01, 0.01, f"{protocol(records)} {hardware(records).strip()}", fontsize=6)
    figure.tight_layout(rect=(0, 0.03, 1, 1))
    figure.savefig(path, dpi=150)


def success_curve(records):
    """Rates, success rates and the ends of their Wilson intervals, percent."""
    points = []
    for (rate,), mine in sorted(group_by(records, "outlier_rate").items()):
        successes = count_of(mine, "success")
        low, high = wilson(successes, len(mine))
        points.append((100 * rate, 100 * successes / len(mine), 100 * low, 100 * high))
    return zip(*points)
