"""Real correspondences with known scale: errors, certificates, priors and the estimated noise."""

from reports.markdown import bounds_cell, bounds_note, count_cell, errors_cell, hardware, limits_note
from reports.markdown import milliseconds, number, table
from reports.records import by_method, group_by, median_of, methods_in, nested

COMPARED = ["gmcr", "gmcr-count", "paper"]  # right how often and how fast: bench/paper has them beside others


def report(records):
    text = "# Real correspondences, known scale\n\n" + hardware(records)
    repetitions = max(record.get("repetitions", 1) for record in records)
    text += (
        "Success: 5 degrees and 0.6 m (kitti_fpfh, noise bound 0.6 m); 5 degrees (gore, noise bound 2 x the listed "
        f"resolution). The source is first turned by a random rotation. Times: median of {repetitions} solves, one of "
        "`gmcr-certify`. Errors: rotation in degrees, translation in the units of the data (kitti_fpfh: metres); bold "
        "where wrong. Certified: proven that no pose has more inliers (count), or more evidence.\n\n"
    )
    text += summary(records) + comparison(records) + certified(records) + gravity(records) + noise(records)
    return text + bounds_note(records) + limits_note(records)


def summary(records):
    """What priors, the estimated bound and certificates come to, a row a set and method."""
    records = [record for record in records if record["method"] not in COMPARED]
    if not records:
        return ""
    rows = []
    for (name,), group in group_by(records, "set").items():
        for method, mine in zip(methods_in(group), by_method(group, methods_in(group))):
            rows.append(
                [
                    name,
                    method,
                    count_cell(mine, "success"),
                    count_cell(mine, "certificate", "certified"),
                    count_cell(mine, "certificate", "evidence", "certified"),
                    milliseconds(median_of(mine, "wall_ms")),
                ]
            )
    return table(["set", "method", "right", "certified: count", "certified: evidence", "median ms"], rows) + "\n"


def comparison(records):
    """The methods side by side, a row a pair."""
    methods = [method for method in methods_in(records) if method in COMPARED]
    if not methods:
        return ""
    columns = {
        "N": lambda group: group[0]["num_correspondences"],
        "true inliers": lambda group: group[0]["num_true_inliers"],
    }
    return side_by_side(records, methods, columns)


def side_by_side(records, methods, columns):
    """Errors, inliers and time of each method, a row a pair, behind columns of what a pair's records say."""
    header = ["pair", *columns]
    for method in methods:
        header += [f"{method}: errors", "inliers [lower, upper]", "ms"]
    rows = []
    for (pair,), group in group_by(records, "scenario").items():
        row = [pair, *(value(group) for value in columns.values())]
        for mine in by_method(group, methods):
            record = mine[0] if mine else {"status": "not run"}
            row += [errors_cell(record), inliers_cell(record), milliseconds(record.get("wall_ms"))]
        rows.append(row)
    return table(header, rows) + "\n"


def inliers_cell(record):
    return f"{record.get('num_inliers', '-')} {bounds_cell(record.get('certificate'))}"


def certified(records):
    """What the rest of the time budget proves, beside the default."""
    mine = [record for record in records if record["method"] == "gmcr-certify"]
    if not mine:
        return ""
    header = [
        "pair", "inliers", "[lower, upper]", "certified", "evidence [lower, upper]", "certified", "errors", "seconds",
    ]
    rows = []
    for record in mine:
        certificate = record.get("certificate", {})
        rows.append(
            [
                record["scenario"],
                record.get("num_inliers", "-"),
                bounds_cell(record.get("certificate")),
                yes(certificate.get("certified")),
                bounds_cell(certificate.get("evidence")),
                yes(nested(certificate, "evidence", "certified")),
                errors_cell(record),
                number(record.get("wall_ms", 0) / 1000),
            ]
        )
    text = f"## Certified solves, at most {number(mine[0].get('time_limit'))} s each\n\n"
    text += (
        "`gmcr-certify` spends what the search leaves of the time on the certificate. A certified pose that is bold is "
        "a wrong one that truly has the most evidence.\n\n"
    )
    return text + table(header, rows) + "\n"


def yes(value):
    return "yes" if value else "no"


def gravity(records):
    """The default with and without the direction of gravity."""
    tilts = {
        record["scenario"]: record.get("true_tilt_deg") for record in records if record["method"] == "gmcr-gravity"
    }
    if not tilts:
        return ""
    mine = [record for record in records if record["scenario"] in tilts]
    columns = {"true tilt deg": lambda group: number(tilts[group[0]["scenario"]])}
    return "## With gravity known to 3 degrees\n\n" + side_by_side(mine, ["gmcr", "gmcr-gravity"], columns)


def noise(records):
    """The bound that the data suggests beside the one that was given to the others."""
    mine = [record for record in records if record["method"] == "gmcr-auto-noise"]
    if not mine:
        return ""
    header = [
        "pair", "given bound", "chosen bound", "stable from - to", "log10 false alarms", "inliers", "errors", "ms",
    ]
    rows = []
    for record in mine:
        estimate = record.get("noise_estimate", {})
        rows.append(
            [
                record["scenario"],
                number(record["noise_bound"]),
                number(estimate.get("noise_bound")),
                f"{number(estimate.get('stable_min'))} - {number(estimate.get('stable_max'))}",
                number(estimate.get("log10_false_alarms")),
                record.get("num_inliers", "-"),
                errors_cell(record),
                milliseconds(record.get("wall_ms")),
            ]
        )
    text = "## Noise bound estimated from the data\n\n"
    text += "`gmcr-auto-noise` is not told the bound that all others are given.\n\n"
    return text + table(header, rows) + "\n"
