"""Raw clouds with default options."""

from reports.markdown import count_cell, hardware, milliseconds, number, table
from reports.records import group_by


def report(records):
    text = "# Raw clouds, default options\n\n" + hardware(records)
    text += (
        "`gmcr register SOURCE TARGET` on each pair. Right: 5 degrees and a mean point error within 5 % of the target's "
        "extent (its largest side). Pairs that hardly move are turned first. "
        "`time` is the tool's own, `wall` that of the process.\n\n"
    )
    summary = []
    for (refine, name), group in sorted(group_by(records, "refine", "set").items()):
        trusted = [r for r in group if r.get("verdict") == "trusted"]
        wrong_trusted = sum(not r["success"] for r in trusted)
        strict = count_cell(group, "success_of_translation")
        summary.append([refine, name, count_cell(group, "success"), strict, len(trusted), wrong_trusted])
    header = ["refine", "set", "right", "right by translation", "trusted", "trusted but wrong"]
    text += table(header, summary) + "\n"
    refined = [record for record in records if record["refine"] != "none"]
    rows = [cloud_row(record) for record in refined or records]
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
