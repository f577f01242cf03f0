"""This library with its default options."""

from paper.methods.gmcr_solver import GmcrSolver
from paper.methods.registry import register


@register
class GmcrDefault(GmcrSolver):
    name = "gmcr"
    settings = "default options: many candidates, distinct evidence"
