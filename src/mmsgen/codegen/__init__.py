"""Plain NumPy functions from solved cases.

`render` makes the text of the files, `generate` writes them. One file for each idea: what is
emitted (`growth`, `boundaries`, `speeds`, `matrices`, `modulation`), as records (`kernels`); the
target language (`numpy_target`); the files (`case_module`, `model_module`, `reference`). What all
emitted modules share is in `mmsgen.runtime`.
"""

from __future__ import annotations

from .emission import emitted_functions, generate, render
from .naming import case_name

__all__ = ["case_name", "emitted_functions", "generate", "render"]
