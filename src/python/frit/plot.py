"""Plots with matplotlib, which is imported when it is used."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Iterable, Optional, Sequence, Union

from ._frit import InputError
from .result import Result, read_result
from .series import Series
from .simulation import Simulation

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Run = Union[Simulation, Result, Series, str, os.PathLike]


def _series_of(run: Run) -> Series:
    if isinstance(run, Series):
        return run
    return run.series if isinstance(run, (Simulation, Result)) else read_result(run).series


def _name_of(run: Run) -> Optional[str]:
    if isinstance(run, Result):
        return run.folder.name
    return os.path.basename(os.fspath(run)) if isinstance(run, (str, os.PathLike)) else None


def plot(runs: Union[Run, Iterable[Run]], y: str = "relative_density", x: str = "time", *,
         labels: Optional[Sequence[str]] = None, ax: Optional["Axes"] = None, **line: Any) -> "Axes":
    """Draws column y against column x for one or several runs (Simulation, Result, Series or folder).

    labels: one a run; default: names of folders. ax: axes to draw into; default: new ones. Further arguments go to
    matplotlib's plot. Returns the axes: plot(run).figure.savefig("density.png").
    """
    from matplotlib import pyplot

    single = isinstance(runs, (Simulation, Result, Series, str, os.PathLike))
    several: list[Run] = [runs] if single else list(runs)  # type: ignore[list-item, arg-type]
    if labels is not None and len(labels) != len(several):
        raise InputError(f"labels: there are {len(labels)}; allowed: {len(several)}, one a run")
    if ax is None:
        ax = pyplot.subplots(layout="constrained")[1]
    for index, run in enumerate(several):
        series = _series_of(run)
        label = labels[index] if labels is not None else _name_of(run)
        ax.plot(series[x], series[y], label=label, **{"marker": ".", **line})
        ax.set_xlabel(series.full_name(x).replace("_", " "))
        ax.set_ylabel(series.full_name(y).replace("_", " "))
    if ax.get_legend_handles_labels()[1]:
        ax.legend()
    return ax
