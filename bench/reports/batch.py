"""Throughput of gmcr.batch, and what a million and a billion pairs take at that cost."""

from reports.markdown import milliseconds, number, table
from reports.records import group_by, median_of

MARGIN = 1.25  # cores that wait for files, chunks and the last pair
SHARD = 1e6  # pairs that one driver takes; the drivers of all shards work at a time
PLANS = {"10^6": 1e6, "10^9": 1e9}
TERABYTE, GIGABYTE = 1e12, 1e9


def report(records):
    first = records[0]
    loads = [record["load"] for record in records]
    text = "# Many pairs\n\n"
    text += (
        f"gmcr {first['version']}; {first['cpu']}, {first['isa']}, {first['cores']} cores, {first['date']}; "
        f"load average {min(loads):.1f} to {max(loads):.1f} (other programs ran where it is above the workers).\n\n"
    )
    return text + throughput(records) + "\n" + plan(records)


def throughput(records):
    header = [
        "pairs", "backend", "workers", "pairs/s", "scaling", "busy %", "ms a pair", "CPU ms a pair",
        "pairs a CPU second", "reading ms", "driver CPU ms",
    ]
    rows = []
    for (scenario, _), group in group_by(records, "scenario", "backend").items():
        has_work = scenario != "nothing"
        base = group[0]["pairs_per_second"] / group[0]["workers"]
        for record in group:
            rate = record["pairs_per_second"]
            rows.append([
                scenario, record["backend"], record["workers"], milliseconds(rate), number(rate / base),
                f"{100 * record['busy_share']:.0f}", milliseconds(record["pair_ms"]),
                milliseconds(record["pair_cpu_ms"]),
                milliseconds(1000 / record["pair_cpu_ms"]) if has_work else "-",
                milliseconds(record["read_ms"]), number(record["driver_cpu_us"] / 1000, 2),
            ])
    return table(header, rows)


def plan(records):
    header = [
        "pairs", "", "core-hours", "on 100 cores", "on 1,000 cores", "files read", "rows written", "MB a worker",
    ]
    rows = []
    groups = group_by(records, "scenario")
    driver_rate = median_of(groups.pop(("nothing",)), "pairs_per_second")
    for (scenario,), group in groups.items():
        core_ms = MARGIN * median_of(group, "pair_cpu_ms")
        for name, count in PLANS.items():
            hours = count * core_ms / 3.6e6
            least = min(count, SHARD) / driver_rate / 3600
            rows.append([
                scenario, name, f"{hours:,.1f}", duration(max(least, hours / 100)),
                duration(max(least, hours / 1000)),
                size(count * group[0]["input_bytes"]), size(count * group[0]["row_bytes"]),
                f"{group[0]['worker_mb']:.0f}",
            ])
    return table(header, rows)


def duration(hours):
    for unit, length in (("d", 24), ("h", 1), ("min", 1 / 60)):
        if hours >= length:
            return f"{hours / length:.1f} {unit}"
    return f"{3600 * hours:.1f} s"


def size(num_bytes):
    return f"{num_bytes / TERABYTE:,.1f} TB" if num_bytes >= TERABYTE else f"{num_bytes / GIGABYTE:,.1f} GB"
