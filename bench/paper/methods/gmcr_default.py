"""This library with its default options."""

from paper.methods.gmcr_solver import GmcrSolver
from paper.methods.registry import Look, register


@register
class GmcrDefault(GmcrSolver):
    name = "gmcr"
    look = Look("gmcr", 10, "#000000", "o", "-")
    settings = "default options: many candidates, distinct evidence"
