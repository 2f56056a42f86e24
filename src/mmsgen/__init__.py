"""From a Lagrangian to certified stability boundaries by the method of multiple scales."""

from __future__ import annotations

from ._version import __version__

__all__ = ["__version__"]
