"""This library with plain counting of inliers."""

from typing import ClassVar

from paper.methods.gmcr_solver import GmcrSolver
from paper.methods.registry import Look, register


@register
class GmcrCount(GmcrSolver):
    name = "gmcr-count"
    look = Look("gmcr-count", 20, "#0072b2", "s", (0, (5, 1)))
    settings = '`evidence="count"`: plain maximum consensus'
    options: ClassVar = {"evidence": "count"}
