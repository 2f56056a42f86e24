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
from .loading import load_files

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["STAGE", "Emission", "publish"]

STAGE = "MMSGEN_STAGE"
"""Environment variable: the folder in which the pipeline expects an emission."""


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
    """

    model: str
    cases: Sequence[Expansion]
    samples: Callable[[Expansion], Mapping[Any, float]]
    numbers: Mapping[Any, float] = field(default_factory=dict)
    derivation: str = ""
    source: str = ""

    def _render(self, cases: Sequence[Expansion]) -> dict[str, str]:
        return render(cases, model=self.model, derivation=self.derivation, source=self.source)

    @cached_property
    def _rendered(self) -> dict[str, str]:
        """The files of all cases, before any is certified."""
        return self._render(self.cases)

    @cached_property
    def certificates(self) -> dict[str, Certificate]:
        """The certificate of every case, by the name of its module."""
        names = [case_name(case) for case in self.cases]
        modules = load_files(self._rendered, names)
        return {
            name: certify(case, self.samples(case), functions=modules[name], numbers=self.numbers)
            for name, case in zip(names, self.cases, strict=True)
        }

    @property
    def failures(self) -> tuple[str, ...]:
        """What fails, one line for each case that may not be emitted."""
        return tuple(c.failure for c in self.certificates.values() if not c.passed)

    def files(self) -> dict[str, str]:
        """The files of the emitted package, certificates included: relative path → text.

        Only cases whose certificates hold.

        Raises
        ------
        CertificateError
            If no case holds.
        """
        held = [case for case in self.cases if self.certificates[case_name(case)].passed]
        if not held:
            raise CertificateError("no case has a certificate that holds: nothing is emitted")
        files = dict(self._rendered) if len(held) == len(self.cases) else self._render(held)
        for case in held:
            name = case_name(case)
            path = f"mms_functions/{self.model}/{name}.certificate.json"
            files[path] = self.certificates[name].to_json()
        return dict(sorted(files.items()))


def publish(emission: Emission, figures: Mapping[str, Any] | None = None) -> str:
    """Hand an emission over to the pipeline, if one is listening.

    Parameters
    ----------
    emission : Emission
    figures : mapping, optional
        Name → Matplotlib figure, for the documentation.

    Returns
    -------
    str
        What has been handed over, or would be.
    """
    files = emission.files()
    stage = os.environ.get(STAGE)
    if stage:
        folder = Path(stage)
        for name, figure in sorted((figures or {}).items()):
            figure.savefig(folder / f"{name}.png", dpi=150, metadata={"Software": None})
        text = json.dumps({"files": files, "failures": emission.failures}, ensure_ascii=False)
        write_atomically(folder / "emission.json", text)
    lines = [f"{len(files)} files for {emission.model}, {len(emission.cases)} cases"]
    lines += [f"not emitted: {failure}" for failure in emission.failures]
    return "\n".join(lines)
