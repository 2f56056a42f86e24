"""Emitted modules before they are emitted: rendered, written to a temporary folder, imported."""

from __future__ import annotations

import importlib
import itertools
import sys
import tempfile
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import runtime
from .codegen import case_name, render
from .codegen.kernels import SHARED
from .files import write_atomically

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["load", "load_files"]

_counter = itertools.count()


def load(case: Expansion) -> Any:
    """Import the functions that would be emitted for a case.

    Parameters
    ----------
    case : Expansion

    Returns
    -------
    module
        The emitted module, under a name of its own that shadows nothing.
    """
    (module,) = load_files(render(case), [case_name(case)]).values()
    return module


def load_files(files: Mapping[str, str], names: Iterable[str]) -> dict[str, Any]:
    """Import case modules from the text of an emitted package.

    Parameters
    ----------
    files : mapping
        Relative path → text, as `codegen.render` makes it.
    names : iterable of str
        The case modules to import.

    Returns
    -------
    dict
        Name → module.
    """
    package = f"mmsgen_loaded_{next(_counter)}"
    folders = {Path(path).stem: Path(path).parts[1:-1] for path in files if path.endswith(".py")}
    with tempfile.TemporaryDirectory(prefix="mmsgen-") as folder:
        for path, text in files.items():
            if path.endswith(".py"):
                write_atomically(Path(folder, package, *Path(path).parts[1:]), text)
        importlib.invalidate_caches()
        sys.path.insert(0, folder)
        # What all emitted modules share is here already, and stays when the folder has gone.
        for name in SHARED:
            shared = importlib.import_module(f"{runtime.__name__}.{name}")
            sys.modules[f"{package}.{name}"] = shared
        try:
            return {
                name: importlib.import_module(".".join((package, *folders[name], name)))
                for name in names
            }
        finally:
            sys.path.remove(folder)
            for loaded in [m for m in sys.modules if m.split(".")[0] == package]:
                del sys.modules[loaded]
