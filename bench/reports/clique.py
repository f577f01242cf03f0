"""Time of maximum clique solvers on the same graphs."""

from reports.markdown import hardware, milliseconds, table
from reports.records import by_method, group_by, values_of

METHODS = ["gmcr", "gmcr-1", "igraph", "igraph-largest", "cliquer"]


def report(records):
    text = "# Maximum clique\n\n" + hardware(records)
    text += (
        "Milliseconds, median of up to 9 runs in a process of its own, without the conversion of the graph; "
        "`>`: ended at its time limit. gmcr: all cores, gmcr-1: one thread. Bold: the fastest.\n\n"
    )
    for (scenario,), group in group_by(records, "scenario").items():
        text += f"## {scenario}\n\n" + scenario_table(group) + "\n"
    return text + disagreements(records)


def scenario_table(records):
    present = {record["method"] for record in records}
    methods = [method for method in METHODS if method in present]
    rows = []
    for (name, count, edges), group in group_by(records, "graph", "num_vertices", "num_edges").items():
        density = 2 * edges / max(1, count * (count - 1))
        sizes = sorted(set(values_of(group, "clique_size")))
        row = [name, f"{count:,}", f"{density:.3f}", ", ".join(map(str, sizes)) or "-"]
        fastest = min(values_of(group, "wall_ms"), default=None)
        for mine in by_method(group, methods):
            row.append(time_cell(mine[0], fastest) if mine else "-")
        rows.append(row)
    return table(["graph", "vertices", "density", "clique", *methods], rows)


def time_cell(record, fastest):
    if record["status"] == "time limit":
        return f"> {milliseconds(1e3 * record['time_limit'])}"
    if "wall_ms" not in record:
        return record["status"]
    cell = milliseconds(record["wall_ms"])
    return f"**{cell}**" if record["wall_ms"] == fastest else cell


def disagreements(records):
    """Whether the solvers that ended found cliques of the same size."""
    groups = group_by(records, "scenario", "graph")
    differ = [name for (_, name), group in groups.items() if len(set(values_of(group, "clique_size"))) > 1]
    if differ:
        return f"The solvers disagree on: {', '.join(differ)}.\n"
    return f"All solvers that ended agree on the clique number, on each of {len(groups)} graphs.\n"
