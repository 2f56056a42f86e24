"""From solved cases to the files of the emitted package."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path, PurePath

from .. import runtime
from ..errors import EmissionError
from ..expansion import Expansion
from ..files import write_atomically
from .boundaries import boundary_function
from .case_module import case_text
from .evolution import evolution_functions
from .growth import growth_function
from .initial import initial_function
from .kernels import SHARED, EmittedFunction
from .kinds import kinds_of
from .matrices import characteristic_function, matrix_function
from .modal import modes_function
from .model_module import PACKAGE_TEXT, model_text
from .modulation import modulation_function
from .motion import motion_function
from .naming import check_module_name
from .nonlinear import COEFFICIENTS, TABLE, flow_functions
from .reference import reference_text
from .setting import Setting
from .speeds import speed_function

__all__ = ["emitted_functions", "generate", "render"]

Cases = Expansion | Iterable[Expansion]


def emitted_functions(setting: Setting) -> tuple[EmittedFunction, ...]:
    """All functions of a case, in the order in which they are emitted.

    All have `slow_flow`, `response` and `initial_amplitudes`. A linear slow flow has what follows
    from its matrix; one that is nonlinear, or driven, what follows from its equilibria, if a frame
    makes it autonomous.
    A case whose boundary is not known as the zero of a polynomial has no `boundaries` and no
    `critical_speeds`; one whose mode shapes change with the detuned frequency has none of these
    either. Where modes are named quantities, `modes` computes these.
    """
    modes = modes_function(setting)
    named = () if modes is None else (modes,)
    flow, start = modulation_function(setting), initial_function(setting)
    if setting.linear is None:
        if setting.flow.frame is None:
            return (flow, motion_function(setting, None), start, *named)
        rest = flow_functions(setting)
        return (flow, *rest, motion_function(setting, (TABLE, COEFFICIENTS)), start, *named)
    edges: tuple[EmittedFunction, ...] = ()
    if not setting.no_boundary:
        boundaries = boundary_function(setting)
        edges = (boundaries,)
        if not setting.moving_modes:
            edges = (*edges, speed_function(setting, next(iter(boundaries.kernels), None)))
    return (
        growth_function(setting),
        *edges,
        matrix_function(setting),
        characteristic_function(setting),
        flow,
        *evolution_functions(setting, flow.kernels[0]),
        motion_function(setting, None),
        start,
        *named,
    )


def render(
    cases: Cases,
    *,
    package: str = "mms_functions",
    model: str = "ground_resonance",
    derivation: str | PurePath | None = None,
    source: str = "",
) -> dict[str, str]:
    """The files of the emitted package, without writing them.

    Parameters
    ----------
    cases : Expansion or iterable of Expansion
    package, model : str
        Names of the import package and of its subpackage.
    derivation : path, optional
        The derivation that the cases come from, relative to the project; of an absolute path the
        file name alone is used.
    source : str
        Where the method and the model are from: a reference for the docstrings.

    Returns
    -------
    dict
        Path relative to the directory of the package, with ``/`` → text.

    Raises
    ------
    EmissionError
        If a name cannot be imported, two cases are the same, or a formula cannot be emitted.
    """
    check_module_name(package, "package")
    check_module_name(model, "model")
    settings = _settings(cases)
    kinds = kinds_of(settings)
    origin = _origin(derivation)
    files = {
        f"{package}/__init__.py": PACKAGE_TEXT,
        **{f"{package}/{name}.py": _shared_text(name) for name in SHARED},
    }
    solved = [(setting, emitted_functions(setting)) for setting in settings]
    files[f"{package}/{model}/__init__.py"] = model_text(
        solved, kinds, package, model, origin, source
    )
    for setting, functions in solved:
        path = f"{package}/{model}/{setting.name}"
        files[f"{path}.py"] = case_text(setting, functions, model, origin, source)
        files[f"{path}.reference.json"] = reference_text(setting, functions)
    return files


def _shared_text(name: str) -> str:
    """The text of a module that emitted modules share."""
    return (Path(runtime.__file__).parent / f"{name}.py").read_text("utf-8")


def _settings(cases: Cases) -> list[Setting]:
    if not isinstance(cases, Iterable):
        cases = (cases,)
    chosen = tuple(cases)
    if not chosen:
        raise EmissionError("there is nothing to emit: pass at least one case")
    settings: dict[str, Setting] = {}
    for case in chosen:
        if not isinstance(case, Expansion):
            raise EmissionError(
                f"{case!r} is not a solved case: pass what ScaledSystem.expand returns"
            )
        setting = Setting(case)
        if setting.name in settings:
            raise EmissionError(
                f"two cases are called {setting.name}: emit each relation and order once"
            )
        settings[setting.name] = setting
    return list(settings.values())


def _origin(derivation: str | PurePath | None) -> str:
    if derivation is None:
        return "an interactive session"
    path = PurePath(derivation)
    text = path.name if path.is_absolute() or ".." in path.parts else path.as_posix()
    if not text or "\n" in text:
        raise EmissionError(f"{derivation!r} names no derivation")
    return text


def generate(
    cases: Cases,
    *,
    package: str = "mms_functions",
    model: str = "ground_resonance",
    directory: str | Path = "generated",
    derivation: str | PurePath | None = None,
    source: str = "",
    update: bool = True,
    prune: bool = False,
) -> tuple[Path, ...]:
    """Emit plain NumPy functions for solved cases.

    Nothing is written if any case fails, every file is written whole or not at all, and one that
    has not changed is left alone. The table of the model names the cases of this call.

    Parameters
    ----------
    cases, package, model, derivation, source
        As for `render`.
    directory : path
        Where the package is.
    update : bool
        Write what has changed; if False, compare only.
    prune : bool
        Remove the files of cases of this model that are not among these.

    Returns
    -------
    tuple of pathlib.Path
        The files of this call, whether they have changed or not.

    Raises
    ------
    EmissionError
        As for `render`; with ``update=False`` also if a file is not as it should be.
    """
    files = render(cases, package=package, model=model, derivation=derivation, source=source)
    root = Path(directory)
    shared = f"{package}/__init__.py"
    if (root / shared).exists():
        del files[shared]
    stale = _stale(root / package / model, files) if prune else ()
    if update:
        for path, text in files.items():
            write_atomically(root / path, text)
        for old in stale:
            old.unlink()
    else:
        wrong = [path for path, text in files.items() if not _holds(root / path, text)]
        wrong += [p.relative_to(root).as_posix() for p in stale]
        if wrong:
            raise EmissionError(f"not what is emitted now: {', '.join(wrong)}; generate them again")
    return tuple(root / path for path in files)


def _holds(path: Path, text: str) -> bool:
    return path.is_file() and path.read_bytes() == text.encode()


def _stale(folder: Path, files: Sequence[str] | dict[str, str]) -> tuple[Path, ...]:
    """Case files in the folder of a model that are not among the files of this call."""
    names = {PurePath(path).name for path in files}
    found = []
    for path in sorted(folder.glob("*_order_*.reference.json")):
        module = path.with_name(path.name.removesuffix(".reference.json") + ".py")
        found += [p for p in (module, path) if p.name not in names and p.exists()]
    return tuple(found)
