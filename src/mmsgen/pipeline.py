"""The stages of `make`, in order.

    execute    derivations/NAME.py                  -> executed notebook, staged emission
    read       staged emission                      -> files of the cases whose certificates hold
    compare    files, notebook, figures             -> those that differ from what is committed
    write      what differs                         -> generated/, derivations/, docs/figures/

Cases are certified inside the derivation, before anything is written. Every file is written whole
or not at all, and one that has not changed keeps its time stamp.
"""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from .emission import KEPT, STAGE
from .errors import MmsgenError
from .files import write_atomically
from .notebook import execute, images_agree, keep_images, read, text_of

__all__ = ["Outcome", "Project", "make"]


INLINE = "module://matplotlib_inline.backend_inline"
"""The backend that puts figures into notebooks."""


@dataclass(frozen=True)
class Project:
    """Where things are.

    Attributes
    ----------
    root : pathlib.Path
        The folder of pyproject.toml.
    """

    root: Path

    @property
    def derivations(self) -> Path:
        """The scripts, and the notebooks beside them."""
        return self.root / "derivations"

    @property
    def generated(self) -> Path:
        """The emitted package."""
        return self.root / "generated"

    @property
    def figures(self) -> Path:
        """The figures of README and documentation."""
        return self.root / "docs" / "figures"

    def script(self, name: str) -> Path:
        """The script of a derivation.

        Raises
        ------
        MmsgenError
            If there is none of that name.
        """
        path = self.derivations / f"{name}.py"
        if not path.is_file() or b"# %%" not in path.read_bytes():
            known = ", ".join(self.names()) or "none"
            raise MmsgenError(f"there is no derivation {name!r}; known are {known}")
        return path

    def names(self) -> tuple[str, ...]:
        """The derivations: scripts with cells. Other modules beside them are shared code."""
        scripts = sorted(self.derivations.glob("*.py"))
        return tuple(p.stem for p in scripts if b"# %%" in p.read_bytes())


@dataclass(frozen=True)
class Outcome:
    """What one derivation has led to.

    Attributes
    ----------
    name : str
    changed : tuple of str
        Paths that differ, or differed, from what was there.
    failures : tuple of str
        Cases that were not emitted, and why.
    """

    name: str
    changed: tuple[str, ...]
    failures: tuple[str, ...]


def make(
    project: Project,
    name: str,
    *,
    check: bool = False,
    progress: Callable[[int, int], None] | None = None,
) -> Outcome:
    """Run one derivation and bring what it makes up to date.

    Parameters
    ----------
    project : Project
    name : str
        Of the derivation.
    check : bool
        Only compare; write nothing.
    progress : callable, optional
        Called with the number of cells executed and the number of all.

    Raises
    ------
    MmsgenError
        If the derivation fails.
    """
    script = project.script(name)
    with tempfile.TemporaryDirectory(prefix="mmsgen-") as folder:
        stage = Path(folder)
        environment = {
            **os.environ,
            STAGE: str(stage),
            # What is compared has to be fresh.
            KEPT: "" if check else str(project.root / "build" / "certificates"),
            "MPLBACKEND": INLINE,
        }
        search = [str(project.derivations), environment.get("PYTHONPATH", "")]
        environment["PYTHONPATH"] = os.pathsep.join(filter(None, search))
        notebook = execute(script, environment, project.derivations, progress)
        target = script.with_suffix(".ipynb")
        keep_images(notebook, read(target))
        staged = stage / "emission.json"
        if not staged.is_file():
            raise MmsgenError(f"{script.name} publishes nothing: end it with mmsgen.publish(...)")
        emission = json.loads(staged.read_text(encoding="utf-8"))
        contents: dict[Path, str | bytes] = {
            project.generated / path: text for path, text in emission["files"].items()
        }
        contents[target] = text_of(notebook)
        contents.update(_figures(project, stage))
        contents = dict(sorted(contents.items()))
        stale = sorted(_stale(project, name, contents))
        changed = [path for path, content in contents.items() if check and _differs(path, content)]
        if not check:
            changed = [p for p, content in contents.items() if write_atomically(p, content)]
            for path in stale:
                path.unlink()
    paths = tuple(str(p.relative_to(project.root)) for p in (*changed, *stale))
    return Outcome(name, paths, tuple(emission["failures"]))


def _differs(path: Path, content: str | bytes) -> bool:
    data = content.encode() if isinstance(content, str) else content
    return not path.is_file() or path.read_bytes() != data


def _figures(project: Project, stage: Path) -> Iterator[tuple[Path, bytes]]:
    """The figures of a run, those that agree with the present ones left out."""
    for png in sorted(stage.glob("*.png")):
        target, data = project.figures / png.name, png.read_bytes()
        if target.is_file() and images_agree(data, target.read_bytes()):
            continue
        yield target, data


def _stale(project: Project, name: str, contents: dict[Path, str | bytes]) -> Iterator[Path]:
    """Emitted files of this model that the derivation makes no longer."""
    models = {p.parent for p in contents if p.is_relative_to(project.generated)}
    package = project.generated / "mms_functions"
    for folder in sorted(m for m in models - {package, project.generated} if m.is_dir()):
        for path in sorted(folder.iterdir()):
            if path.is_file() and path not in contents:
                yield path


def find_project(start: Path | None = None) -> Project:
    """The project that holds a folder, by default the present one.

    Raises
    ------
    MmsgenError
        If no folder above holds pyproject.toml and derivations/.
    """
    here = (start or Path.cwd()).resolve()
    for folder in (here, *here.parents):
        if (folder / "pyproject.toml").is_file() and (folder / "derivations").is_dir():
            return Project(folder)
    raise MmsgenError("no project here: a folder with pyproject.toml and derivations/ is needed")
