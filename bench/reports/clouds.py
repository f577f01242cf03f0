"""Raw clouds with default options."""

from reports.markdown import count_cell, hardware, milliseconds, number, table
from reports.records import group_by


def report(records):
    text = "# Raw clouds, default options\n\n" + hardware(records)
    text += (
        "`gmcr register SOURCE TARGET` on each pair. Right: 5 degrees and a mean point error within 5 % of the target's "
        "extent (its largest side). Pairs that hardly move are turned first. "
        "By symmetry: where the posed source lies, whatever of its points: mean distance from the nearest point of the "
        "source at the true pose within 2 % of its diameter, for symmetric objects (a flat scene shifted along itself "
        "counts too). `time` is the tool's own, `wall` that of the process.\n\n"
    )
    summary = []
    for (refine, name), group in sorted(group_by(records, "refine", "set").items()):
        trusted = [r for r in group if r.get("verdict") == "trusted"]
        wrong_trusted = sum(not r["success"] for r in trusted)
        counts = [count_cell(group, by) for by in ("success", "success_of_translation", "success_by_symmetry")]
        summary.append([refine, name, *counts, len(trusted), wrong_trusted])
    header = ["refine", "set", "right", "right by translation", "right by symmetry", "trusted", "trusted but wrong"]
    text += table(header, summary) + "\n"
    refined = [record for record in records if record["refine"] != "none"]
    rows = [cloud_row(record) for record in refined or records]
    header = [
        "pair", "refine", "points", "voxel", "matches", "inliers", "pose", "rotation deg", "translation (% of extent)",
        "point error %", "by symmetry %", "fitness", "verdict", "time ms", "wall ms",
    ]
    return text + table(header, rows)


def cloud_row(record):
    errors = record.get("errors", {})
    extent_share = errors.get("translation_of_extent")
    point_share = errors.get("mean_point_of_extent")
    symmetric_share = errors.get("symmetric_of_diameter")
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
        number(None if symmetric_share is None else 100 * symmetric_share),
        number(record.get("fitness")),
        record.get("verdict", "-"),
        milliseconds(record.get("time_ms", {}).get("total")),
        milliseconds(record.get("wall_ms")),
    ]
