"""This library's default, then the least-squares fit to the inliers."""

from typing import ClassVar

from paper.methods.gmcr_solver import GmcrSolver
from paper.methods.registry import register


@register
class GmcrFit(GmcrSolver):
    name = "gmcr-fit"
    settings = "`least_squares=True`: the pose of the default, fitted to its inliers"
    options: ClassVar = {"least_squares": True}
