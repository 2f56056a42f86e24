"""Notebooks that are the same on every run."""

from __future__ import annotations

import base64
import io
import json
import os
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

nbformat = pytest.importorskip("nbformat")
pytest.importorskip("nbclient")
pytest.importorskip("jupytext")
matplotlib = pytest.importorskip("matplotlib")

from matplotlib.figure import Figure  # noqa: E402

from mmsgen.errors import MmsgenError  # noqa: E402
from mmsgen.notebook import (  # noqa: E402
    _normalised,
    execute,
    images_agree,
    keep_images,
    read,
    text_of,
)

SCRIPT = """\
# ---
# jupyter:
#   jupytext:
#     text_representation:
#       jupytext_version: 1.0.0
# ---

# %% [markdown]
# # Title
#
# $\\\\omega$

# %% tags=["some"]
import os
print(os.environ["GREETING"])
print("second line")

# %%
from fractions import Fraction
import matplotlib.pyplot as plt
fig, axes = plt.subplots(figsize=(2, 1))
axes.plot([0, 1], [1, 0]);

# %%
Fraction(1, 3)
"""


def environment(**more: str) -> dict[str, str]:
    backend = "module://matplotlib_inline.backend_inline"
    return {**os.environ, "MPLBACKEND": backend, **more}


def test_two_executions_are_the_same_and_hold_nothing_of_the_run(tmp_path: Path) -> None:
    script = tmp_path / "derivation.py"
    script.write_text(SCRIPT, encoding="utf-8")
    seen: list[tuple[int, int]] = []
    first = execute(
        script, environment(GREETING="hello"), tmp_path, lambda k, n: seen.append((k, n))
    )
    second = execute(script, environment(GREETING="hello", PYTHONHASHSEED="7"), tmp_path)
    text = text_of(first)
    assert text == text_of(second)
    assert text.endswith("}\n")
    assert not text.endswith("\n\n")
    assert [p.name for p in tmp_path.iterdir()] == ["derivation.py"]
    nbformat.validate(first)
    assert seen[-1][1] == len(first.cells)
    # outputs are there
    streams = [o.text for c in first.cells for o in c.get("outputs", ()) if "text" in o]
    assert streams == ["hello\nsecond line\n"]
    assert '"text/plain": [\n       "Fraction(1, 3)"' in text
    assert '"image/png"' in text
    # and nothing else: no versions, machines, folders, times or identifiers that a run makes
    for accident in (str(tmp_path), sys.executable, "iopub", "transient", "jupytext", "tags"):
        assert accident not in text
    assert set(first.metadata) == {"kernelspec", "language_info"}
    assert set(first.metadata.language_info) == {"name"}
    assert [c.id for c in first.cells] == [f"cell-{k:03d}" for k in range(len(first.cells))]
    assert [c.execution_count for c in first.cells if c.cell_type == "code"] == [1, 2, 3]


def test_a_failing_cell_is_an_error_with_its_traceback(tmp_path: Path) -> None:
    script = tmp_path / "derivation.py"
    script.write_text('# %%\nx = 1\n\n# %%\nraise ValueError(f"bad {x}")\n', encoding="utf-8")
    with pytest.raises(MmsgenError, match=r"derivation\.py fails when executed") as info:
        execute(script, environment(), tmp_path)
    text = str(info.value)
    assert "ValueError" in text
    assert "bad 1" in text
    assert 'raise ValueError(f"bad {x}")' in text
    assert "\x1b" not in text
    assert [p.name for p in tmp_path.iterdir()] == ["derivation.py"]


def test_a_kernel_that_dies_is_an_error(tmp_path: Path) -> None:
    script = tmp_path / "derivation.py"
    script.write_text("# %%\nimport os\n\nos._exit(3)\n", encoding="utf-8")
    with pytest.raises(MmsgenError, match=r"derivation\.py cannot be executed"):
        execute(script, environment(), tmp_path)


def test_without_the_extra_there_is_a_remedy(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "jupytext", None)
    with pytest.raises(MmsgenError, match=r"needs jupytext: .*mmsgen\[notebook\]"):
        execute(tmp_path / "derivation.py", {}, tmp_path)


def notebook(*images: bytes) -> Any:
    outputs = [
        nbformat.v4.new_output(
            "display_data",
            {"image/png": base64.b64encode(data).decode(), "text/plain": "<Figure>"},
            metadata={"needs_background": "light"},
        )
        for data in images
    ]
    cells = [
        nbformat.v4.new_markdown_cell("text", metadata={"collapsed": True}),
        nbformat.v4.new_code_cell("1", outputs=outputs, metadata={"execution": {"a": "12:00"}}),
    ]
    return nbformat.v4.new_notebook(cells=cells, metadata={"widgets": {}})


def figure(shift: float = 0.0, size: tuple[float, float] = (3.0, 2.0), label: str = "x") -> bytes:
    x = np.linspace(0, 1, 200)
    drawing = Figure(figsize=size)
    axes = drawing.add_subplot()
    axes.plot(x, np.sin(6 * x) + shift, lw=1.6)
    axes.set_xlabel(label)
    data = io.BytesIO()
    drawing.savefig(data, format="png", dpi=100)
    return data.getvalue()


def copied(png: bytes) -> bytes:
    """The same picture in another file."""
    data, pixels = io.BytesIO(), matplotlib.image.imread(io.BytesIO(png))
    matplotlib.image.imsave(data, pixels, format="png", metadata={"Comment": "a copy"})
    return data.getvalue()


def test_normalised() -> None:
    clean = _normalised(notebook(figure()))
    assert [c.metadata for c in clean.cells] == [{}, {}]
    assert clean.cells[1].outputs[0].metadata == {}
    assert "widgets" not in clean.metadata
    assert json.loads(text_of(clean))["nbformat_minor"] == 5


def test_images_within_the_tolerance_agree_and_others_do_not() -> None:
    plain = figure()
    assert images_agree(plain, plain)
    # another file of the same picture
    assert copied(plain) != plain
    assert images_agree(plain, copied(plain))
    # noise on three of four channels: the root mean square is 0.87 of its level
    rng = np.random.default_rng(1)
    for level, agree in ((0.01, True), (0.04, False)):
        pixels = matplotlib.image.imread(io.BytesIO(plain)).astype(float)
        noisy = io.BytesIO()
        # away from black and white, where clipping would halve it
        pixels[..., :3] = 0.25 + pixels[..., :3] / 2
        base = io.BytesIO()
        matplotlib.image.imsave(base, pixels, format="png")
        pixels[..., :3] += rng.normal(scale=level, size=pixels[..., :3].shape)
        matplotlib.image.imsave(noisy, np.clip(pixels, 0, 1), format="png")
        assert images_agree(base.getvalue(), noisy.getvalue()) is agree
    # a curve that has moved by a tenth of its amplitude, another size, no image at all
    assert not images_agree(plain, figure(shift=0.1, label="x y z" * 4))
    assert not images_agree(plain, figure(size=(3.0, 2.1)))
    assert not images_agree(plain, b"no image")
    assert not images_agree(b"no image", plain)


def test_a_curve_that_moves_by_its_own_width_over_a_tenth_of_a_figure_is_seen() -> None:
    def curve(bump: float) -> bytes:
        x = np.linspace(0, 1, 700)
        drawing = Figure(figsize=(7.0, 3.6))
        axes = drawing.add_axes((0, 0, 1, 1))
        axes.set_axis_off()
        inside = (x > 0.45) & (x < 0.55)
        axes.plot(x, 0.5 + bump * inside, lw=1.6, color="black")
        axes.set(xlim=(0, 1), ylim=(0, 1))
        data = io.BytesIO()
        drawing.savefig(data, format="png", dpi=100)
        return data.getvalue()

    width = 1.6 / 72 / 3.6
    assert not images_agree(curve(0.0), curve(2 * width))
    assert images_agree(curve(0.0), curve(width / 20))


def test_committed_images_are_kept_where_they_agree() -> None:
    old, other = figure(), figure(shift=0.3, label="quite another one")
    committed = notebook(old, old)
    fresh = notebook(copied(old), other)
    keep_images(fresh, committed)
    kept = [base64.b64decode(o.data["image/png"]) for o in fresh.cells[1].outputs]
    assert kept == [old, other]


def test_committed_notebooks_that_have_other_cells_do_no_harm() -> None:
    fresh = notebook(figure())
    before = notebook(figure()).cells[1].outputs
    texts = [nbformat.v4.new_markdown_cell("x") for _ in range(5)]
    others = (nbformat.v4.new_notebook(), notebook(), nbformat.v4.new_notebook(cells=texts))
    for committed in others:
        keep_images(fresh, committed)
        assert fresh.cells[1].outputs == before


@pytest.mark.parametrize("content", [None, "", "no json", "[]", "{}", '{"cells": 3}', b"\xff\xfe"])
def test_a_committed_notebook_that_cannot_be_read_counts_as_none(
    tmp_path: Path, content: str | bytes | None
) -> None:
    path = tmp_path / "derivation.ipynb"
    if content is not None:
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
    assert read(path).cells == []
