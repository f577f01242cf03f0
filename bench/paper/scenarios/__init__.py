"""The experiments, one file each; importing this package registers all of them."""

from paper.scenarios import synthetic, structured, objects, lidar, real, noise, scaling  # noqa: F401, I001 (order of the report)
from paper.scenarios.registry import EXPERIMENTS, Case, Experiment, is_success

__all__ = ["EXPERIMENTS", "Case", "Experiment", "is_success"]
