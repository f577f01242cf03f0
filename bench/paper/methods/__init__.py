"""The methods, one file each; importing this package registers all of them."""

from importlib import import_module
from pkgutil import iter_modules

from paper.methods.registry import METHODS, Method, Outcome, in_order, look_of

for _module in sorted(module.name for module in iter_modules(__path__)):
    import_module(f"{__name__}.{_module}")

__all__ = ["METHODS", "Method", "Outcome", "in_order", "look_of"]
