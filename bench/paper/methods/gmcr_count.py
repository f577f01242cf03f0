"""This library with plain counting of inliers."""

from typing import ClassVar

from paper.methods.gmcr_solver import GmcrSolver
from paper.methods.registry import register


@register
class GmcrCount(GmcrSolver):
    name = "gmcr-count"
    settings = '`evidence="count"`: plain maximum consensus'
    options: ClassVar = {"evidence": "count"}
