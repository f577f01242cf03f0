"""Cells and tables."""

from reports.records import count_of, nested


def table(header, rows):
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines) + "\n"


def number(value, digits=3):
    return "-" if value is None else f"{value:.{digits}g}"


def milliseconds(value):
    return "-" if value is None else f"{value:.3g}" if value < 1000 else f"{value:,.0f}"


def percent(part, total):
    return f"{100 * part / total:.0f}"


def count_cell(records, *path):
    """How many of the records have a true field: "3 of 7", or "-" without records."""
    return f"{count_of(records, *path)} of {len(records)}" if records else "-"


def errors_cell(record):
    """Of rotation and translation, bold where the pose is wrong."""
    if "errors" not in record:
        return f"**{record['status']}**"
    cell = f"{number(nested(record, 'errors', 'rotation_deg'))}, {number(nested(record, 'errors', 'translation'))}"
    return cell if record["success"] else f"**{cell}**"


def bounds_cell(certificate):
    """[lower, upper] of a certificate."""
    if certificate is None:
        return "-"
    return f"[{number(certificate['lower'])}, {number(certificate['upper'])}]"


def hardware(records):
    first = records[0]
    threads = sorted({record["threads"] for record in records if "threads" in record})
    return (
        f"gmcr {first['version']}; {first['cpu']}, {first['isa']}, {first['cores']} cores; "
        f"threads: {', '.join(map(str, threads)) or 'default'}.\n"
    )


def limits_note(records):
    """How often a budget bound, by method; "" where none did."""
    bound = {}
    for record in records:
        if record.get("limits_hit"):
            bound[record["method"]] = bound.get(record["method"], 0) + 1
    if not bound:
        return ""
    methods = ", ".join(f"{method} {count}" for method, count in bound.items())
    return f"A budget bound in {sum(bound.values())} of {len(records)} runs ({methods}).\n"


def bounds_note(records):
    """Whether the truth, which is one pose of all, keeps below the upper bounds."""
    judged = [record for record in records if "truth_inliers" in record]
    broken = [record for record in judged if exceeds_bounds(record)]
    return f"The truth lies above a proven upper bound in {len(broken)} of {len(judged)} runs.\n" if judged else ""


def exceeds_bounds(record):
    certificate = record["certificate"]
    upper = certificate["evidence"]["upper"]
    return record["truth_inliers"] > certificate["upper"] or record["truth_evidence"] > upper + 1e-9 * upper
