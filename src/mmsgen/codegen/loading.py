"""Load the emitted functions of a case that has not been written: to certify it first."""

from __future__ import annotations

import sys
import tempfile
from importlib import import_module
from pathlib import Path
from types import ModuleType

from ..expansion import Expansion
from .case_module import case_text, digest_of
from .emission import emitted_functions, runtime_text
from .setting import Setting
from .writing import write_files

__all__ = ["load"]


def load(case: Expansion) -> ModuleType:
    """The module that `generate` would write for a case, imported from a temporary directory.

    Parameters
    ----------
    case : Expansion

    Returns
    -------
    module
        Its functions are those of the emitted file; the file itself is gone.

    Raises
    ------
    EmissionError
        As for `render`.
    """
    setting = Setting(case)
    functions = emitted_functions(setting)
    package = f"_mmsgen_loaded_{digest_of(functions)[:16]}"
    files = {
        f"{package}/__init__.py": "",
        f"{package}/_runtime.py": runtime_text(),
        f"{package}/model/__init__.py": "",
        f"{package}/model/{setting.name}.py": case_text(
            setting, functions, "model", "a case in memory", ""
        ),
    }
    with tempfile.TemporaryDirectory() as folder:
        write_files(Path(folder), files)
        sys.path.insert(0, folder)
        try:
            return import_module(f"{package}.model.{setting.name}")
        finally:
            sys.path.remove(folder)
            for name in [n for n in sys.modules if n.split(".")[0] == package]:
                del sys.modules[name]
