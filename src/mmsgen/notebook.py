"""Notebooks: a percent-format script executed into an .ipynb that is the same on every run.

Needs the extra ``notebook``. What a run adds by accident (times, identifiers, versions) is taken
out, and a figure that differs from the committed one by less than a tolerance keeps its bytes.
"""

from __future__ import annotations

import base64
import io
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from .errors import MmsgenError

__all__ = ["execute", "images_agree"]

IMAGE_TOLERANCE = 0.02
"""Root mean square difference, of 1, below which two figures count as the same.

Fonts and anti-aliasing differ between machines by about 0.01; a curve that moves by its own
width over a tenth of a figure differs by more than 0.02.
"""

_COLOURS = re.compile(r"\x1b\[[0-9;]*m")
"""How a traceback is coloured for a terminal."""

TIMEOUT = 600
"""Seconds for one cell."""


def execute(
    script: Path,
    environment: dict[str, str],
    folder: Path,
    progress: Callable[[int, int], None] | None = None,
) -> Any:
    """Execute a percent-format script as a notebook.

    Parameters
    ----------
    script : pathlib.Path
    environment : dict
        Environment of the kernel.
    folder : pathlib.Path
        Its working directory.
    progress : callable, optional
        Called before each cell with its index and the number of all cells.

    Returns
    -------
    nbformat.NotebookNode
        With outputs, normalised.

    Raises
    ------
    MmsgenError
        If a cell fails, the message holding its traceback, or the kernel does; if the script is
        not UTF-8; or if the extra ``notebook`` is not installed.
    KeyboardInterrupt
        If the execution is interrupted; the kernel has been stopped.
    """
    try:
        import jupytext
        from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError
    except ModuleNotFoundError as error:
        raise MmsgenError(
            f"executing notebooks needs {error.name}: install it with pip install "
            "'mmsgen[notebook]'"
        ) from None

    try:
        notebook = jupytext.read(script, fmt="py:percent")
    except UnicodeDecodeError as error:
        raise MmsgenError(
            f"{script.name} is not UTF-8 text (byte {error.start}): save it in that encoding"
        ) from None
    client = _client(notebook, folder, progress)
    try:
        _run(client, environment)
    except CellExecutionError as error:
        text = _COLOURS.sub("", str(error))
        raise MmsgenError(f"{script.name} fails when executed:\n{text}") from None
    except (CellTimeoutError, DeadKernelError) as error:
        raise MmsgenError(f"{script.name} cannot be executed: {error}") from None
    return _normalised(notebook)


def _client(notebook: Any, folder: Path, progress: Callable[[int, int], None] | None) -> Any:
    """What executes a notebook in a kernel of its own."""
    from nbclient import NotebookClient

    client = NotebookClient(
        notebook,
        timeout=TIMEOUT,
        kernel_name="python3",
        record_timing=False,
        # An orderly shutdown interrupts the cell first, which the kernel reports with a traceback.
        shutdown_kernel="immediate",
        extra_arguments=["--log-level=40"],
        coalesce_streams=True,
        resources={"metadata": {"path": str(folder)}},
    )
    if progress is not None:
        client.on_cell_start = lambda cell, cell_index: progress(cell_index, len(notebook.cells))
    return client


def _run(client: Any, environment: dict[str, str]) -> None:
    """Execute; where that is interrupted, stop the kernel and raise KeyboardInterrupt alone.

    nbclient takes the signal itself: it shuts the kernel down below its own execution, which then
    fails in whatever way the moment brings.
    """
    client.create_kernel_manager()
    manager = client.km
    try:
        client.execute(env=environment)
    except (Exception, KeyboardInterrupt) as error:
        signalled = getattr(client, "_async_cleanup_kernel_future", None) is not None
        if not signalled and not isinstance(error, KeyboardInterrupt):
            raise
        if manager.has_kernel:
            from jupyter_core.utils import run_sync

            run_sync(manager.shutdown_kernel)(now=True)
        raise KeyboardInterrupt from None


def _normalised(notebook: Any) -> Any:
    """A notebook without what a run adds by accident."""
    notebook.metadata = {
        "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
        "language_info": {"name": "python"},
    }
    notebook.nbformat, notebook.nbformat_minor = 4, 5
    for k, cell in enumerate(notebook.cells):
        cell["id"] = f"cell-{k:03d}"
        cell.metadata = {}
        for output in cell.get("outputs", ()):
            output.pop("transient", None)
            if "metadata" in output:
                output["metadata"] = {}
    return notebook


def read(path: Path) -> Any:
    """The notebook of a file; an empty one where there is none that can be read."""
    import nbformat

    try:
        return nbformat.read(path, as_version=4)
    except (OSError, ValueError, TypeError, LookupError, AttributeError, nbformat.ValidationError):
        # Whatever a file holds that no program has written; it is only a source of images.
        return nbformat.v4.new_notebook()


def keep_images(notebook: Any, committed: Any) -> None:
    """Put the committed figures into a notebook where its own agree with them."""
    for cell, old in zip(notebook.cells, committed.cells, strict=False):
        pairs = zip(cell.get("outputs", ()), old.get("outputs", ()), strict=False)
        for output, before in pairs:
            new_data, old_data = output.get("data", {}), before.get("data", {})
            if "image/png" not in new_data or "image/png" not in old_data:
                continue
            png, old_png = (base64.b64decode(d["image/png"]) for d in (new_data, old_data))
            if images_agree(png, old_png):
                new_data["image/png"] = old_data["image/png"]


def images_agree(first: bytes, second: bytes) -> bool:
    """Whether two PNG images show the same within `IMAGE_TOLERANCE`; not so if one is none."""
    if first == second:
        return True
    from matplotlib.image import imread

    try:
        a, b = (imread(io.BytesIO(data), format="png").astype(float) for data in (first, second))
    except (OSError, SyntaxError, ValueError):
        return False
    if a.shape != b.shape:
        return False
    return bool(np.sqrt(np.mean((a - b) ** 2)) < IMAGE_TOLERANCE)


def text_of(notebook: Any) -> str:
    """A notebook as the text of its file."""
    import nbformat

    return str(nbformat.writes(notebook)).rstrip("\n") + "\n"
