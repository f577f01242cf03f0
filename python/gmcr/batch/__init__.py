"""Many pairs: on all cores of this machine, or on a Ray cluster; resumable, one row a pair.

>>> from gmcr import batch
>>> summary = batch.run("pairs.csv", "results", options={"noise_bound": 0.05})
>>> rows = list(batch.read_results("results"))

From the shell: ``python -m gmcr.batch pairs.csv --out results --noise-bound 0.05``.
``pip install gmcr[batch]`` brings what Parquet, the progress bar and Ray need.
"""

from .matches import read_matches
from .options import OPTION_NAMES
from .pairs import Pair, PairsError, read_pairs
from .registration import register_pair
from .row import Row
from .run import Summary, run
from .sink import SinkError, read_results

__all__ = [
    "OPTION_NAMES",
    "Pair",
    "PairsError",
    "Row",
    "SinkError",
    "Summary",
    "read_matches",
    "read_pairs",
    "read_results",
    "register_pair",
    "run",
]
