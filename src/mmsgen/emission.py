"""`Emission`: what a derivation hands over, cases with their certificates, and how it does so.

A derivation ends by publishing its emission. Run by hand, it only says what would be emitted. Run
by `mmsgen make`, which names a folder in the environment, it leaves the files there for the
pipeline, so that what is emitted comes from the very run that the notebook shows.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .certificate import Certificate
from .certify import certify
from .codegen import case_name, render
from .errors import CertificateError
from .files import write_atomically
from .keeping import certificate_key, kept
from .loading import load_files
from .steady import Steady

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["KEPT", "STAGE", "Emission", "publish"]

STAGE = "MMSGEN_STAGE"
"""Environment variable: the folder in which the pipeline expects an emission."""

KEPT = "MMSGEN_KEPT"
"""Environment variable: the folder in which certificates are kept between runs."""


@dataclass(frozen=True)
class Emission:
    """Cases to be emitted as one model, with what is needed to certify them.

    Attributes
    ----------
    model : str
        Name of the module in the emitted package.
    cases : sequence of Expansion
    samples : callable
        Case → values at ε = 1, generic ones, for its certificate.
    numbers : mapping, optional
        Values of the independent parameters at which critical speeds are compared as well.
    derivation : str
        File name of the derivation.
    source : str
        The publication behind the model.
    amplitudes : callable, optional
        Case → starting values of B_j at ε = 1 and the time in s over which its motions are compared
        with exact ones, for cases with a nonlinear slow flow; see `certify`.
    steady : callable, optional
        Case → steady motions to be compared with periodic orbits, none or several; see `certify`.
    """

    model: str
    cases: Sequence[Expansion]
    samples: Callable[[Expansion], Mapping[Any, float]]
    numbers: Mapping[Any, float] = field(default_factory=dict)
    derivation: str = ""
    source: str = ""
    amplitudes: Callable[[Expansion], tuple[Sequence[complex], float]] | None = None
    steady: Callable[[Expansion], Sequence[Steady]] | None = None

    def _render(self, cases: Sequence[Expansion]) -> dict[str, str]:
        return render(cases, model=self.model, derivation=self.derivation, source=self.source)

    @cached_property
    def _rendered(self) -> dict[str, str]:
        """The files of all cases, before any is certified."""
        return self._render(self.cases)

    @cached_property
    def _judged(self) -> dict[str, Certificate | CertificateError]:
        """The certificate of every case, or why there is none, by the name of its module."""
        names = [case_name(case) for case in self.cases]
        modules = load_files(self._rendered, names)
        folder = os.environ.get(KEPT)
        judged: dict[str, Certificate | CertificateError] = {}
        for name, case in zip(names, self.cases, strict=True):
            try:
                judged[name] = self._certificate(
                    case, modules[name], Path(folder) if folder else None
                )
            except CertificateError as error:
                judged[name] = error
        return judged

    def _certificate(self, case: Expansion, module: Any, folder: Path | None) -> Certificate:
        """The certificate of one case, kept in a folder if there is one."""
        samples = {str(getattr(k, "name", k)): float(v) for k, v in self.samples(case).items()}
        numbers = {str(getattr(k, "name", k)): float(v) for k, v in self.numbers.items()}
        own = f"{case_name(case)}.py"
        texts = {
            path: text
            for path, text in self._rendered.items()
            if Path(path).name == own or Path(path).name.startswith("_")
        }
        # What is certified, and what it is compared with.
        texts["exact"] = str(case.weak.scaled.eom)
        texts["scaling"] = str(case.weak.scaled.orders)
        start, span = (None, 1.0) if self.amplitudes is None else self.amplitudes(case)
        texts["motions"] = f"{start} {span}"
        steady = () if self.steady is None else tuple(self.steady(case))
        texts["steady"] = str(steady) if steady else ""
        key = certificate_key(texts, samples, numbers)
        return kept(
            folder,
            key,
            lambda: certify(
                case,
                samples,
                functions=module,
                numbers=numbers,
                amplitudes=start,
                span=span,
                steady=steady,
            ),
        )

    @cached_property
    def certificates(self) -> dict[str, Certificate]:
        """The certificates, by the name of the module; of a case without one see `failures`."""
        return {name: c for name, c in self._judged.items() if isinstance(c, Certificate)}

    @property
    def failures(self) -> tuple[str, ...]:
        """What fails, one line for each case that may not be emitted."""
        return tuple(
            str(c) if isinstance(c, CertificateError) else c.failure
            for c in self._judged.values()
            if isinstance(c, CertificateError) or not c.passed
        )

    @property
    def held(self) -> tuple[Expansion, ...]:
        """The cases whose certificates hold: those that are emitted."""
        passed = {name for name, c in self.certificates.items() if c.passed}
        return tuple(case for case in self.cases if case_name(case) in passed)

    def files(self) -> dict[str, str]:
        """The files of the emitted package, certificates included: relative path → text.

        Only cases whose certificates hold.

        Raises
        ------
        CertificateError
            If no case holds, with what fails.
        """
        held = self.held
        if not held:
            reasons = "; ".join(self.failures)
            raise CertificateError(f"no case has a certificate that holds: {reasons}")
        files = dict(self._rendered) if len(held) == len(self.cases) else self._render(held)
        for case in held:
            name = case_name(case)
            path = f"mms_functions/{self.model}/{name}.certificate.json"
            files[path] = self.certificates[name].to_json()
        return dict(sorted(files.items()))


def publish(emission: Emission | None = None, figures: Mapping[str, Any] | None = None) -> str:
    """Hand an emission over to the pipeline, if one is listening.

    Parameters
    ----------
    emission : Emission, optional
        None for a derivation that shows what others emit.
    figures : mapping, optional
        Name → Matplotlib figure, for the documentation.

    Returns
    -------
    str
        What has been handed over, or would be.
    """
    files = {} if emission is None else emission.files()
    failures = () if emission is None else emission.failures
    stage = os.environ.get(STAGE)
    if stage:
        folder = Path(stage)
        for name, figure in sorted((figures or {}).items()):
            figure.savefig(folder / f"{name}.png", dpi=150, metadata={"Software": None})
        text = json.dumps({"files": files, "failures": failures}, ensure_ascii=False)
        write_atomically(folder / "emission.json", text)
    if emission is None:
        return f"nothing is emitted; figures: {', '.join(sorted(figures or {})) or 'none'}"
    own = [path for path in files if Path(path).parent.name == emission.model]
    lines = [f"{len(own)} files for {emission.model}, {len(emission.held)} cases"]
    lines += [f"not emitted: {failure}" for failure in failures]
    return "\n".join(lines)
