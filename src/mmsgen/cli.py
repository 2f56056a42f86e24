"""The command `mmsgen`: `make` runs derivations and brings what they make up to date."""

from __future__ import annotations

import os
import time
from typing import Annotated

import typer
from rich.console import Console

from .errors import MmsgenError
from .pipeline import Outcome, Project, find_project
from .pipeline import make as make_one

__all__ = ["app"]

app = typer.Typer(no_args_is_help=True, add_completion=False, pretty_exceptions_enable=False)
console = Console(stderr=True, highlight=False)


@app.callback()
def main() -> None:
    """Derive, emit and certify by the method of multiple scales."""


@app.command()
def make(
    derivations: Annotated[list[str] | None, typer.Argument(help="Names; all by default.")] = None,
    check: Annotated[
        bool, typer.Option(help="Only compare; fail where something differs.")
    ] = False,
) -> None:
    """Run derivations: execute the notebook, certify, emit; write only what has changed."""
    try:
        project = find_project()
        names = derivations or list(project.names())
        if not names:
            raise MmsgenError(f"there is no derivation in {project.derivations}")
        for name in names:
            project.script(name)
    except MmsgenError as error:
        _say(f"mmsgen: {error}")
        raise typer.Exit(1) from None
    different, failures = False, []
    try:
        for name in names:
            # Whatever one leads to, the other derivations are made all the same.
            try:
                outcome = _make(project, name, check)
            except (MmsgenError, OSError) as error:
                failures.append(str(error))
                _say(f"{name}: failed")
                continue
            different |= bool(outcome.changed)
            failures += [f"not emitted: {failure}" for failure in outcome.failures]
    except KeyboardInterrupt:
        _say("mmsgen: interrupted; what was made before is whole")
        raise typer.Exit(130) from None
    for failure in failures:
        _say(f"mmsgen: {failure}")
    if check and different:
        _say("the committed output differs from fresh output: run make and commit it")
    if failures or (check and different):
        raise typer.Exit(1)


def _make(project: Project, name: str, check: bool) -> Outcome:
    """Make one derivation, and say what has changed."""
    start = time.perf_counter()
    if "-j" in os.environ.get("MAKEFLAGS", ""):
        # Several at once would write over one another's line.
        outcome = make_one(project, name, check=check, progress=lambda cell, cells: None)
    else:
        with console.status(f"{name}: starting") as status:

            def show(cell: int, cells: int) -> None:
                status.update(f"{name}: cell {cell + 1} of {cells}")

            outcome = make_one(project, name, check=check, progress=show)
    word = "differ" if check else "changed"
    seconds = time.perf_counter() - start
    _say(f"{name}: {len(outcome.changed)} files {word}, {seconds:.0f} s")
    for path in outcome.changed:
        _say(f"  {path}")
    return outcome


def _say(text: str) -> None:
    """A line on standard error, as it is, however long."""
    console.print(text, markup=False, soft_wrap=True)
