"""The paper's method, with this library's graphs and clique solver."""

from typing import ClassVar

from paper.methods.gmcr_solver import GmcrSolver
from paper.methods.registry import Look, register


@register
class GmcrPaper(GmcrSolver):
    name = "gmcr-paper"
    look = Look("gmcr-paper", 21, "#d55e00", "^", (0, (3, 1, 1, 1)))
    settings = '`method="paper"`: the stages of the paper, one maximum clique each'
    options: ClassVar = {"method": "paper", "evidence": "count"}
