"""The paper's method, with this library's graphs and clique solver."""

from typing import ClassVar

from paper.methods.gmcr_solver import GmcrSolver
from paper.methods.registry import register


@register
class GmcrPaper(GmcrSolver):
    name = "gmcr-paper"
    settings = '`method="paper"`: the stages of the paper, one maximum clique each'
    options: ClassVar = {"method": "paper", "evidence": "count"}
