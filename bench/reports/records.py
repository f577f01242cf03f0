"""Records of the benchmarks and statistics over them."""

import json
import math
import statistics
import sys
from collections import defaultdict

METHOD_ORDER = ["gmcr", "gmcr-count", "paper", "gmcr-certify", "gmcr-gravity", "gmcr-auto-noise"]


def read_records(path):
    """Records of a file, [] where it is absent."""
    if not path.exists():
        print(f"skipped: {path} is absent", file=sys.stderr)
        return []
    with path.open() as lines:
        return [json.loads(line) for line in lines]


def group_by(records, *fields):
    """Records by the values of the fields, in order of first appearance."""
    groups = defaultdict(list)
    for record in records:
        groups[tuple(record[field] for field in fields)].append(record)
    return groups


def by_method(records, methods):
    """Records of each of the methods, [] where it has none."""
    groups = group_by(records, "method")
    return [groups.get((method,), []) for method in methods]


def methods_in(records):
    present = {record["method"] for record in records}
    return [m for m in METHOD_ORDER if m in present] + sorted(present - set(METHOD_ORDER))


def nested(record, *path):
    """A nested field, None where it is absent."""
    for key in path:
        record = record.get(key) if isinstance(record, dict) else None
    return record


def values_of(records, *path):
    """A nested field of the records that have it."""
    values = (nested(record, *path) for record in records)
    return [value for value in values if value is not None]


def quantile_of(records, share, *path):
    """Quantile of a nested field over the records that have it, interpolated; None where none has."""
    values = sorted(values_of(records, *path))
    if not values:
        return None
    position = share * (len(values) - 1)
    below = int(position)
    above = min(below + 1, len(values) - 1)
    return values[below] + (position - below) * (values[above] - values[below])


def median_of(records, *path):
    return quantile_of(records, 0.5, *path)


def count_of(records, *path):
    """How many records have a true nested field."""
    return sum(bool(value) for value in values_of(records, *path))


def mean_gap(records, *path):
    """Mean of upper - lower over the certificates at `path` that are open, None where none is."""
    open_ones = [c for c in values_of(records, *path) if not c["certified"]]
    return statistics.mean(c["upper"] - c["lower"] for c in open_ones) if open_ones else None


def wilson(successes, total):
    """Wilson interval of a success rate at 95 %."""
    z = 1.96
    rate = successes / total
    middle = (rate + z * z / (2 * total)) / (1 + z * z / total)
    half = z * math.sqrt(rate * (1 - rate) / total + z * z / (4 * total * total)) / (1 + z * z / total)
    return max(0.0, middle - half), min(1.0, middle + half)
