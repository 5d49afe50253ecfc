"""Writes cases, runs the program on them and reads what it wrote."""
import copy
import csv
import dataclasses
import json
import math
import pathlib
import subprocess

from .law import RADIUS
from .vtp import read_vtp

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build/release/src/app/frit"
LONGEST_RUN = 120.0  # [s], a run that takes longer has failed; free bodies ask for more
NEVER = 2_000_000_000  # output.every_steps: first and last state only


class RunFailed(RuntimeError):
    """The program did not end with exit code 0."""


def base_case():
    """Copper at 1050 degC without sliding resistance; the caller adds packing, steps and stop."""
    return {
        "packing": {}, "cell": {"kind": "free"}, "material": {"use": "copper"},
        "contact": {"sliding_resistance": 0.0}, "temperature": {"start": "1050 degC"},
        "method": {}, "stop": {}, "output": {"every_steps": NEVER},
    }


def with_keys(case, **sections):
    """A copy of the case with further keys; a section is given as a dictionary."""
    changed = copy.deepcopy(case)
    for section, keys in sections.items():
        if isinstance(keys, list):
            changed[section] = keys
        else:
            changed.setdefault(section, {}).update(keys)
    return changed


def toml_value(value):
    if isinstance(value, list):
        return "[" + ", ".join(toml_value(item) for item in value) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml_value(item)}" for key, item in value.items()) + " }"
    return json.dumps(value) if isinstance(value, (bool, str)) else repr(value)


def write_case(path, case):
    lines = []
    for section, keys in case.items():
        if isinstance(keys, list):
            lines.append(f"{section} = {toml_value(keys)}")
    for section, keys in case.items():
        if isinstance(keys, dict):
            lines.append(f"[{section}]")
            lines += [f"{key} = {toml_value(value)}" for key, value in keys.items()]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def write_packing(path, spheres):
    """spheres: (x, y, z, radius) [m]."""
    rows = [",".join(repr(float(number)) for number in sphere) for sphere in spheres]
    path.write_text("x,y,z,radius\n" + "\n".join(rows) + "\n", encoding="utf-8")


def read_packing(path):
    """(x, y, z, radius) [m] of each row; columns in SI as the program writes them."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = csv.DictReader(file)
        return [tuple(float(row[name]) for name in ("x [m]", "y [m]", "z [m]", "radius [m]")) for row in rows]


@dataclasses.dataclass
class Result:
    folder: pathlib.Path

    def rows(self):
        """series.csv as dictionaries of numbers; empty cells are NaN."""
        with open(self.folder / "series.csv", newline="", encoding="utf-8") as file:
            return [{name: float(text) if text else math.nan for name, text in row.items()}
                    for row in csv.DictReader(file)]

    def final(self):
        return self.rows()[-1]

    def summary(self):
        return json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))

    def snapshot(self, kind, number=-1):
        """Arrays of a snapshot; kind: particles or contacts; number: 0 the first, -1 the last."""
        return read_vtp(sorted((self.folder / "snapshots").glob(f"{kind}_*.vtp"))[number])


class Workshop:
    """Runs cases in a temporary folder, one subfolder each."""

    def __init__(self, folder, threads=1):
        self.folder, self.threads, self.count = pathlib.Path(folder), threads, 0

    def new_folder(self):
        self.count += 1
        folder = self.folder / f"{self.count:03}"
        folder.mkdir()
        return folder

    def call(self, command, longest=LONGEST_RUN):
        try:
            done = subprocess.run([str(PROGRAM), *map(str, command)], capture_output=True, text=True, check=False,
                                  timeout=longest)
        except subprocess.TimeoutExpired:
            raise RunFailed(f"stopped after {longest:g} s") from None
        if done.returncode != 0:
            said = (done.stderr.strip() or done.stdout.strip()).splitlines()
            raise RunFailed(f"exit code {done.returncode}: {said[-1] if said else 'nothing said'}")

    def run(self, case, spheres=None, threads=None, longest=LONGEST_RUN):
        """Runs the case, on these spheres if given, and returns the result. Throws RunFailed."""
        folder = self.new_folder()
        if spheres is not None:
            write_packing(folder / "packing.csv", spheres)
            case = with_keys(case, packing={"file": "packing.csv"})
        write_case(folder / "case.toml", case)
        threads = self.threads if threads is None else threads
        self.call(["run", folder / "case.toml", "-o", folder / "out", "--quiet", "--threads", threads], longest)
        return Result(folder / "out")

    def pack(self, case):
        """Spheres of the packing that a case describes."""
        folder = self.new_folder()
        write_case(folder / "case.toml", with_keys(case, stop={"time": 1.0}))
        self.call(["pack", folder / "case.toml", "-o", folder / "packing.csv"])
        return read_packing(folder / "packing.csv")


def random_dense(count, **sections):
    """A case with a random dense packing of equal spheres."""
    packing = {"generate": "random-dense", "count": count, "radius": RADIUS}
    return with_keys(base_case(), packing=packing, contact={"sliding_resistance": 0.01}, **sections)


def fixed_steps(total, steps, **method):
    """Keys for `steps` equal steps that end at `total` [s], and further keys of [method]."""
    return {"method": {"time_step": total / steps, **method}, "stop": {"time": total}}
