"""The command `mmsgen`: `make` runs derivations and brings what they make up to date."""

from __future__ import annotations

import time
from typing import Annotated

import typer
from rich.console import Console
from rich.status import Status

from .errors import MmsgenError
from .pipeline import demand, find_project
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
        for name in derivations or project.names():
            project.script(name)
        different = False
        for name in derivations or project.names():
            start = time.perf_counter()
            with console.status(f"{name}: starting") as status:

                def show(cell: int, cells: int, name: str = name, status: Status = status) -> None:
                    status.update(f"{name}: cell {cell + 1} of {cells}")

                outcome = make_one(project, name, check=check, progress=show)
            word = "differ" if check else "changed"
            seconds = time.perf_counter() - start
            console.print(f"{name}: {len(outcome.changed)} files {word}, {seconds:.0f} s")
            for path in outcome.changed:
                console.print(f"  {path}", soft_wrap=True)
            demand(outcome)
            different |= bool(outcome.changed)
    except MmsgenError as error:
        console.print(f"mmsgen: {error}", markup=False)
        raise typer.Exit(1) from None
    if check and different:
        console.print("the committed output differs from fresh output: run make and commit it")
        raise typer.Exit(1)
