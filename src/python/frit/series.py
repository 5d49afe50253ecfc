"""Columns of numbers by name."""

from __future__ import annotations

import difflib
from typing import Dict

import numpy


class Series(Dict[str, numpy.ndarray]):
    """Columns of series.csv: name, with its unit in brackets, to an array with a number a row (NaN: no value).

    The unit may be left out: series["time"] is series["time [s]"].
    """

    def __missing__(self, name: str) -> numpy.ndarray:
        full = self.full_name(name)
        if full is None:
            near = difflib.get_close_matches(name, list(self), n=3)
            raise KeyError(f"no column {name!r}" + (f"; nearest: {', '.join(near)}" if near else ""))
        return self[full]

    def full_name(self, name: str) -> str | None:
        """The name with its unit, or None where there is no such column."""
        if name in self:
            return name
        return next((column for column in self if column.partition(" [")[0] == name), None)
