"""The figures, one file each, drawn from the records only."""

from importlib import import_module
from pkgutil import iter_modules

from paper.figures.registry import FIGURES

for _module in sorted(module.name for module in iter_modules(__path__)):
    import_module(f"{__name__}.{_module}")

__all__ = ["FIGURES"]
