"""Two runs of bench_micro side by side."""

import statistics
from dataclasses import dataclass

from .markdown import table as markdown_table

SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
LEAST_DIFFERENCE = 0.02  # relative: the same program differs by as much from run to run
SPREADS = 3


@dataclass(frozen=True)
class Row:
    name: str
    old: float | None  # seconds, median of the repetitions; None: not in that run
    new: float | None
    noise: float = 0.0  # relative

    @property
    def ratio(self):
        return self.new / self.old if self.old and self.new else float("nan")

    @property
    def is_beyond_noise(self):
        return abs(self.ratio - 1) > max(LEAST_DIFFERENCE, SPREADS * self.noise)


def samples(run, metric):
    """Times of all repetitions, in seconds, by benchmark."""
    times = {}
    for entry in run["benchmarks"]:
        if entry.get("run_type", "iteration") == "iteration" and not entry.get("error_occurred"):
            seconds = entry[metric] * SECONDS[entry["time_unit"]]
            times.setdefault(entry.get("run_name", entry["name"]), []).append(seconds)
    return times


def spread(times):
    """Median absolute deviation relative to the median."""
    median = statistics.median(times)
    return statistics.median(abs(time - median) for time in times) / median


def compare(old, new, metric="cpu_time"):
    """A row for each benchmark of either run, in the order of the new one."""
    before, after = samples(old, metric), samples(new, metric)
    rows = []
    for name in list(after) + [name for name in before if name not in after]:
        both = name in before and name in after
        rows.append(
            Row(
                name,
                statistics.median(before[name]) if name in before else None,
                statistics.median(after[name]) if name in after else None,
                spread(before[name]) + spread(after[name]) if both else 0.0,
            )
        )
    return rows


def time_text(seconds):
    if seconds is None:
        return "-"
    unit = next((unit for unit in ("s", "ms", "us") if seconds >= SECONDS[unit]), "ns")
    return f"{seconds / SECONDS[unit]:.3g} {unit}"


def verdict(row):
    if row.old is None or row.new is None:
        return "only in one"
    if not row.is_beyond_noise:
        return ""
    return "slower" if row.ratio > 1 else "faster"


def table(rows):
    """Markdown table of the rows."""
    return markdown_table(
        ["benchmark", "old", "new", "new / old", "noise", ""],
        [
            [
                row.name,
                time_text(row.old),
                time_text(row.new),
                f"{row.ratio:.2f}" if row.old and row.new else "-",
                f"{100 * row.noise:.1f} %",
                verdict(row),
            ]
            for row in rows
        ],
    )


def report(run):
    """Kernels by instruction set, in nanoseconds a pair (or word, or point), and stages."""
    kernels, stages = {}, {}
    for name, times in samples(run, "real_time").items():
        first, _, last = name.rpartition("/")
        if name.startswith(("stage/", "solve/")):
            stages[name] = statistics.median(times)
        else:
            kernels.setdefault(first, {})[last] = 1e9 * per_pair(run, name)
    isas = list(dict.fromkeys(isa for times in kernels.values() for isa in times))
    cells = [[name, *(f"{times[isa]:.3g}" if isa in times else "-" for isa in isas)] for name, times in kernels.items()]
    text = "# Kernels and stages\n\nNanoseconds of one thread a pair (a point, a word of bits), by instruction set.\n\n"
    text += markdown_table(["kernel", *isas], cells)
    text += "\nStages and whole solves, all cores.\n\n"
    return text + markdown_table(["stage / N", "time"], [[name, time_text(seconds)] for name, seconds in stages.items()])


def per_pair(run, name):
    """Seconds a pair, median of the repetitions."""
    return statistics.median(
        entry["time/pair"]
        for entry in run["benchmarks"]
        if entry.get("run_name", entry["name"]) == name and entry.get("run_type", "iteration") == "iteration"
    )
