"""Folders of results."""

from __future__ import annotations

import functools
import json
import os
import pathlib
import tomllib
from typing import Any, Dict, List, Tuple, Union

from . import _frit
from .series import Series

PathLike = Union[str, os.PathLike]


class Snapshot:
    """One output of a run; files are read when first asked for. InputError where they are damaged."""

    def __init__(self, time: float, particles: pathlib.Path, contacts: pathlib.Path):
        self.time = time  # [s]
        self._particles_file, self._contacts_file = particles, contacts

    @functools.cached_property
    def _particles(self) -> Tuple[Series, Dict[str, Any]]:
        return read_particles(self._particles_file)

    @property
    def particles(self) -> Series:
        """Name to (N,) or (N, 3) array: id, position [m], radius [m], and what docs/observables.md lists."""
        return self._particles[0]

    @property
    def whole(self) -> Dict[str, Any]:
        """Of the whole: time [s], cell_size (3,) [m] or None, temperature, theta, cell_rate."""
        return self._particles[1]

    @functools.cached_property
    def contacts(self) -> Series:
        """Name to (K,) or (K, 3) array: i and j (ids), neck_radius [m], and what docs/observables.md lists."""
        return Series(_frit.read_contacts(self._contacts_file))


class Result:
    """What a run left in its folder. InputError where a part is missing or damaged, when it is asked for."""

    def __init__(self, folder: PathLike):
        self.folder = pathlib.Path(folder)
        self.series = Series(_frit.read_series(self.folder / "series.csv"))

    @functools.cached_property
    def case(self) -> Dict[str, Any]:
        """The resolved case: result.case["contact"]["sliding_resistance"]; SI."""
        return tomllib.loads(self._read("case.toml"))

    @functools.cached_property
    def summary(self) -> Dict[str, Any]:
        """summary.json: cost, accuracy, ending, machine."""
        return json.loads(self._read("summary.json"))

    @functools.cached_property
    def snapshots(self) -> List[Snapshot]:
        """In order of time."""
        return [Snapshot(*entry) for entry in _frit.list_snapshots(self.folder)]

    def _read(self, name: str) -> str:
        file = self.folder / name
        if not file.is_file():
            raise _frit.InputError(f"{file}: there is no such file; allowed: the folder of a result")
        return file.read_text(encoding="utf-8")


def read_result(folder: PathLike) -> Result:
    """The folder of a run. InputError where its series.csv is missing or damaged."""
    return Result(folder)


def read_particles(path: PathLike) -> Tuple[Series, Dict[str, Any]]:
    """Particles of a file (.csv, .xyz, .dump, .vtp): arrays a particle (id, position [m], radius [m], ...), and of the whole
    time [s] and cell_size (3,) [m] or None. InputError with the file's faults."""
    arrays, whole = _frit.read_particles(pathlib.Path(path))
    return Series(arrays), whole
