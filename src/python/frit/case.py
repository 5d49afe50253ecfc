"""Cases: what shall be simulated."""

from __future__ import annotations

import json
import os
import pathlib
import shutil
import tempfile
import tomllib
import weakref
from typing import Any, Mapping, Optional, Union

import numpy
from numpy.typing import ArrayLike

from . import _frit
from ._frit import InputError

PathLike = Union[str, os.PathLike]
Overrides = Mapping[str, Any]


def _toml(value: Any) -> str:
    """The value as TOML; NumPy's numbers and arrays too, paths made absolute."""
    if isinstance(value, (numpy.generic, numpy.ndarray)):
        value = value.tolist()
    if isinstance(value, pathlib.PurePath):
        value = os.path.abspath(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{key} = {_toml(item)}" for key, item in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_toml, value)) + "]"
    raise TypeError(f"{value!r} cannot be a value of a case; allowed: text, numbers, bool, lists, dicts, paths")


def _override_texts(overrides: Overrides) -> list[str]:
    return [f"{key}={_toml(value)}" for key, value in overrides.items()]


def _array(name: str, values: ArrayLike, shape: tuple[Optional[int], ...], kind: type,
           faults: list[str]) -> numpy.ndarray:
    """The values as an array of `kind`; None in `shape` is any length. What does not fit goes to `faults`."""
    array = numpy.asarray(values)
    fits = array.ndim == len(shape) and all(want in (None, have) for want, have in zip(shape, array.shape))
    wanted = ", ".join("any" if length is None else str(length) for length in shape)
    trailing = "," if len(shape) == 1 else ""
    if not fits:
        faults.append(f"{name}: the shape is {array.shape}; allowed: ({wanted}{trailing})")
    elif not numpy.can_cast(array.dtype, kind, "same_kind"):
        faults.append(f"{name}: numbers of type {array.dtype}; allowed: {numpy.dtype(kind)}")
    else:
        return array.astype(kind)
    return numpy.zeros([length or 0 for length in shape], kind)


class Packing:
    """Particles from arrays, for `parse_case`.

    positions: (N, 3) [m], centres. radii: (N,) [m], or one number for all. size: (3,) [m], edges of a periodic cell;
    None: a free body. contacts: (K, 2), rows of the particles that touch at the start; None: those that the geometry gives.
    neck_radii: (K,) [m], of these contacts; None: as the case says.

    Raises InputError where shapes or types do not fit; what is wrong with the numbers, `Simulation` tells.
    """

    def __init__(self, positions: ArrayLike, radii: ArrayLike, *, size: Optional[ArrayLike] = None,
                 contacts: Optional[ArrayLike] = None, neck_radii: Optional[ArrayLike] = None):
        faults: list[str] = []
        self.positions = _array("positions", positions, (None, 3), float, faults)
        count = len(self.positions)
        spread = numpy.full(count, radii) if numpy.ndim(radii) == 0 else radii
        self.radii = _array("radii", spread, (count,), float, faults)
        self.size = None if size is None else _array("size", size, (3,), float, faults)
        self.contacts = None if contacts is None else _array("contacts", contacts, (None, 2), numpy.int64, faults)
        self.neck_radii = None
        if neck_radii is not None:
            count = 0 if self.contacts is None else len(self.contacts)
            self.neck_radii = _array("neck_radii", neck_radii, (count,), float, faults)
        if faults:
            error = InputError("\n".join(faults))
            error.faults = faults
            raise error

    def save(self, folder: PathLike) -> None:
        """Writes packing.csv and, with contacts, contacts.csv into the folder; reading them gives the same bits."""
        os.makedirs(folder, exist_ok=True)
        _frit.write_packing(os.path.join(folder, "packing.csv"), self.positions, self.radii)
        if self.contacts is None:
            return
        columns = [self.contacts[:, 0].tolist(), self.contacts[:, 1].tolist()]
        names = ["i", "j"]
        if self.neck_radii is not None:
            names.append("neck_radius [m]")
            columns.append([repr(radius) for radius in self.neck_radii.tolist()])
        rows = [",".join(map(str, row)) for row in zip(*columns)]
        pathlib.Path(folder, "contacts.csv").write_text("\n".join([",".join(names), *rows]) + "\n")

    def overrides(self, folder: PathLike) -> dict[str, Any]:
        """The keys of a case that name the files of `save`."""
        keys: dict[str, Any] = {"packing.file": pathlib.Path(folder, "packing.csv")}
        if self.contacts is not None:
            keys["packing.contacts"] = pathlib.Path(folder, "contacts.csv")
        if self.size is not None:
            keys.update({"cell.kind": "periodic", "cell.size": self.size})
        return keys


class Case:
    """A case as its text and overrides say, checked: InputError with all faults at once.

    Made by `load_case` or `parse_case`; never changes. case["contact.sliding_resistance"] is the resolved value of a key,
    numbers in SI; KeyError where the case has no such key.
    """

    def __init__(self, text: str, name: str, overrides: Overrides, packing: Optional[Packing] = None):
        self._text, self._name, self._overrides, self._packing = text, name, dict(overrides), packing
        self._temporary = "."
        if packing is not None:
            self._temporary = tempfile.mkdtemp(prefix="frit-")
            weakref.finalize(self, shutil.rmtree, self._temporary, ignore_errors=True)
        self._resolved = self.resolve_in(None)

    def with_overrides(self, overrides: Overrides) -> "Case":
        """A new case with these keys replaced: case.with_overrides({"contact.sliding_resistance": 0.1})."""
        return Case(self._text, self._name, {**self._overrides, **overrides}, self._packing)

    def to_toml(self) -> str:
        """The resolved case: every key, every default, in SI."""
        return self._resolved.to_toml()

    def __getitem__(self, key: str) -> Any:
        value: Any = tomllib.loads(self.to_toml())
        for name in key.split("."):
            if not isinstance(value, dict) or name not in value:
                raise KeyError(key)
            value = value[name]
        return value

    def resolve_in(self, folder: Optional[PathLike]) -> _frit.Case:
        """The case for a run; a packing from arrays is written to `folder`, or to one that lives as long as this."""
        if self._packing is None:
            return _frit.Case(self._text, self._name, _override_texts(self._overrides))
        target = os.path.abspath(folder if folder is not None else self._temporary)
        case = _frit.Case(self._text, self._name,
                          _override_texts({**self._overrides, **self._packing.overrides(target)}))
        self._packing.save(target)
        return case


def load_case(path: PathLike, overrides: Optional[Overrides] = None) -> Case:
    """The case in a TOML file, with keys replaced: load_case("case.toml", {"stop.time": "2 h", "packing.seed": 3}).

    Values are those of a case file: "2 h" with a unit, or a number in SI. InputError with all faults.
    """
    file = pathlib.Path(path)
    _frit.load_case(file, _override_texts(overrides or {}))  # tells what is wrong with the file itself
    return Case(file.read_text(encoding="utf-8"), str(file), overrides or {})


def parse_case(text: str, overrides: Optional[Overrides] = None, *, packing: Optional[Packing] = None,
               folder: PathLike = ".") -> Case:
    """The case in a text (TOML), with keys replaced as in `load_case`.

    packing: particles from arrays, in place of a [packing] in the text. Relative paths in the text are relative to `folder`.
    """
    return Case(text, os.path.join(folder, "case.toml"), overrides or {}, packing)
