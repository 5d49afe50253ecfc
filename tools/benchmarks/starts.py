"""Makes the states that benchmarks start from: packing file, edges of the cell, necks."""
import csv
import dataclasses
import math
import pathlib
import random
import typing

from validation.law import RADIUS
from validation.program import base_case, with_keys, write_case, write_packing

from .cases import USUAL_SLIDING, Start

LONGEST = 24 * 3600.0  # [s] of making one packing
GENERATED_DENSITY = 0.64
DENSE_DENSITY = 0.80
# Loose: radii shrink by more than half the deepest overlap (about 3 % of R), so that every pair parts; two thirds of the
# contacts keep their necks, the others become gaps.
KEPT_SHARE, SHRINKAGE = 2 / 3, 0.98
# Radius ratio 10: log-normal radii from which those below a tenth of the largest are left out (up to one in fifty).
WIDE_SPREAD, WIDE_DENSITY, WIDEST_RATIO = 0.42, 0.66, 10.0
A_MOMENT = 1e-9  # [s], nothing moves


@dataclasses.dataclass(frozen=True)
class StartFiles:
    packing: pathlib.Path
    size: typing.Optional[list] = None  # edges of the periodic cell [m]
    contacts: typing.Optional[pathlib.Path] = None

    def keys(self, case):
        """The case with this start."""
        packing = {"file": str(self.packing)}
        if self.contacts:
            packing["contacts"] = str(self.contacts)
        return with_keys(case, packing=packing, cell={"size": self.size} if self.size else {})


def read_spheres(path):
    """(x, y, z, radius) [m] of each row of a packing that `frit pack` wrote."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = csv.reader(file)
        next(rows)
        return [tuple(float(cell) for cell in row[1:5]) for row in rows]


def solid_volume(spheres):
    return sum(4 / 3 * math.pi * sphere[3] ** 3 for sphere in spheres)


def write_necks(path, necks):
    """necks: (i, j, neck radius [m]), rows of the packing."""
    lines = [f"{i},{j},{radius!r}" for i, j, radius in necks]
    path.write_text("i,j,neck_radius\n" + "\n".join(lines) + "\n", encoding="utf-8")


class Starts:
    """Starting states, each made once in the workshop's folder."""

    def __init__(self, workshop, threads):
        self.workshop, self.threads, self.made = workshop, threads, {}

    def of(self, case):
        key = (case.start, case.cell, case.particles, case.packing_file)
        if key not in self.made:
            make = {Start.GENERATED: self.generated, Start.DENSE: self.dense, Start.LOOSE: self.loose,
                    Start.RADIUS_RATIO_10: self.wide, Start.MEASURED: self.measured}[case.start]
            self.made[key] = make(case)
        return self.made[key]

    def pack(self, case, count, **packing):
        """A packing file, and the edges of the cell if it is periodic."""
        folder = self.workshop.new_folder()
        keys = {"generate": "random-dense", "count": count, "radius": RADIUS, **packing}
        whole = with_keys(base_case(), packing=keys, cell={"kind": case.cell}, stop={"time": 1.0})
        write_case(folder / "case.toml", whole)
        path = folder / "packing.csv"
        self.workshop.call(["pack", folder / "case.toml", "-o", path], LONGEST)
        if case.cell == "free":
            return StartFiles(path)
        edge = (solid_volume(read_spheres(path)) / packing["relative_density"]) ** (1 / 3)
        return StartFiles(path, [edge] * 3)

    def measured(self, case):
        return StartFiles(case.packing_file.resolve())

    def generated(self, case):
        return self.pack(case, case.particles, relative_density=GENERATED_DENSITY)

    def generated_of(self, case):
        """The generated start of the same size and cell."""
        return self.of(dataclasses.replace(case, start=Start.GENERATED))

    def last_state(self, start, case, **stop):
        """Snapshot arrays (particles, contacts) at the end of a run from `start`."""
        whole = with_keys(base_case(), cell={"kind": case.cell}, contact={"sliding_resistance": USUAL_SLIDING}, stop=stop)
        result = self.workshop.run(start.keys(whole), threads=self.threads, longest=LONGEST)
        return result.snapshot("particles"), result.snapshot("contacts")

    def dense(self, case):
        particles, contacts = self.last_state(self.generated_of(case), case, relative_density=DENSE_DENSITY)
        row = {number: place for place, number in enumerate(particles["id"])}
        spheres = [(*centre, radius) for centre, radius in zip(particles["Points"], particles["radius"])]
        necks = [(row[i], row[j], radius) for i, j, radius in zip(contacts["i"], contacts["j"], contacts["neck_radius [m]"])]
        return self.with_necks(spheres, necks, list(particles["CellSize"][0]) if case.cell == "periodic" else None)

    def loose(self, case):
        start = self.generated_of(case)
        _, contacts = self.last_state(start, case, time=A_MOMENT)
        necks = list(zip(contacts["i"], contacts["j"], contacts["neck_radius [m]"]))
        kept = sorted(random.Random(1).sample(range(len(necks)), round(KEPT_SHARE * len(necks))))
        spheres = [(x, y, z, SHRINKAGE * radius) for x, y, z, radius in read_spheres(start.packing)]
        return self.with_necks(spheres, [necks[k] for k in kept], start.size)

    def wide(self, case):
        made = self.pack(case, case.particles, relative_density=WIDE_DENSITY, radius_spread=WIDE_SPREAD)
        spheres = read_spheres(made.packing)
        smallest = max(sphere[3] for sphere in spheres) / WIDEST_RATIO
        kept = self.workshop.new_folder() / "packing.csv"
        write_packing(kept, [sphere for sphere in spheres if sphere[3] >= smallest])
        return StartFiles(kept, made.size)

    def with_necks(self, spheres, necks, size):
        folder = self.workshop.new_folder()
        write_packing(folder / "packing.csv", spheres)
        write_necks(folder / "necks.csv", necks)
        return StartFiles(folder / "packing.csv", size, folder / "necks.csv")
