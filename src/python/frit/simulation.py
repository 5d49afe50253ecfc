"""Runs: from a case to its last state."""

from __future__ import annotations

import os
import signal
import warnings
from typing import Callable, Dict, List, NamedTuple, Optional, Union

from . import _frit
from .case import Case
from .result import Result, read_result
from .series import Series

PathLike = Union[str, os.PathLike]


class Ending(NamedTuple):
    """How a run ended.

    code: as the program's: 0 done, 3 could not be computed, 4 stopped early by its caller, 128 and more by a signal.
    """
    code: int
    reason: str


class Simulation:
    """A run that is set up and has its first row; `step` or `run` take it on.

    case: what to simulate. folder: where to write what `frit run` writes; None: nowhere. replace: results that are in
    the folder already are replaced. InputError with all faults of the packing, or of the folder; MachineError where files
    cannot be written.

    The interpreter is free for other threads while frit computes. Ctrl-C raises KeyboardInterrupt after the step that is
    being made; the run can then go on. Used as a context, a run that has not ended is stopped at the end:

        with frit.Simulation(case, "results/case") as simulation:
            while simulation.step():
                print(simulation.state.time)
    """

    def __init__(self, case: Case, folder: Optional[PathLike] = None, *, replace: bool = False):
        self._folder = None if folder is None else os.path.abspath(folder)
        if self._folder is not None:
            _frit.check_result_folder(self._folder, replace)
        self._case = case  # owns the files of a packing from arrays
        self._session = _frit.Session(case.resolve_in(self._folder), self._folder)

    def step(self) -> bool:
        """Makes one step and writes the row that may be due. True while the run goes on."""
        return self._session.step()

    def run(self, on_step: Optional[Callable[["Simulation"], object]] = None,
            on_row: Optional[Callable[["Simulation"], object]] = None) -> Ending:
        """Steps to the end. on_step is called after each step, on_row after each new row, both with this simulation.

        What they raise comes out and leaves the run where it is. A run that could not be computed is warned of.
        """
        rows = 0
        while True:
            if on_row is not None and self._session.row_count() > rows:
                on_row(self)
            rows = self._session.row_count()
            if self.ending is not None:
                break
            self.step()
            if on_step is not None:
                on_step(self)
        if self.ending.code == 3:
            warnings.warn(self.ending.reason, RuntimeWarning, stacklevel=2)
        return self.ending

    def stop(self, reason: str = "stopped by the caller") -> None:
        """Ends the run here: last row, summary.json, report. A run that has ended stays as it is."""
        self._session.stop(4, reason)

    def __enter__(self) -> "Simulation":
        return self

    def __exit__(self, kind, error, trace) -> None:
        if kind is not None and issubclass(kind, KeyboardInterrupt):
            self._session.stop(128 + signal.SIGINT, f"stopped by signal {int(signal.SIGINT)}")
        else:
            self.stop()

    @property
    def state(self) -> _frit.State:
        """Particles and contacts now. A State never changes: after a step there is a new one, arrays of the old stay good."""
        return self._session.state()

    @property
    def series(self) -> Series:
        """All rows so far, as in series.csv: column to (rows,) array."""
        return Series(self._session.series())

    @property
    def row(self) -> Dict[str, float]:
        """The last row: column to number, NaN for no value. Units may be left out in names, as in `Series`."""
        return Series((name, values[-1]) for name, values in self._session.series().items())

    @property
    def ending(self) -> Optional[Ending]:
        """None while the run goes on."""
        ending = self._session.ending()
        return None if ending is None else Ending(*ending)

    @property
    def counts(self) -> Dict[str, float]:
        """What the run cost so far: steps, rejected_steps, newton_iterations, solver_iterations; accuracy, estimated."""
        return self._session.counts()

    @property
    def warnings(self) -> List[str]:
        """What to know of this case, a sentence each."""
        return self._session.warnings()

    @property
    def time_scale(self) -> float:
        """R^4/(gamma Delta_b) [s] of the mean radius at the hottest temperature."""
        return self._session.time_scale()

    @property
    def result(self) -> Result:
        """The folder of the run, read. ValueError without a folder."""
        if self._folder is None:
            raise ValueError("this run has no folder; give one to Simulation")
        return read_result(self._folder)


def run(case: Case, folder: Optional[PathLike] = None, *, replace: bool = False,
        on_step: Optional[Callable[[Simulation], object]] = None,
        on_row: Optional[Callable[[Simulation], object]] = None) -> Simulation:
    """Runs a case to its end and returns the Simulation, with its series and last state. Arguments as there."""
    with Simulation(case, folder, replace=replace) as simulation:
        simulation.run(on_step, on_row)
    return simulation
