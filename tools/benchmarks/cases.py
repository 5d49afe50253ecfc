"""The named benchmark cases: which state each starts from, how far it goes and how often it is run."""
import dataclasses
import enum
import fnmatch
import pathlib
import typing

from validation.program import base_case, with_keys

SIZES = {"1k": 1_000, "10k": 10_000, "100k": 100_000, "1M": 1_000_000}
SLIDING_RESISTANCES = (0.0, 0.001, 0.01, 0.1)
USUAL_SLIDING = 0.01
LARGEST_QUICK = 10_000  # particles of the largest cases that run unasked


class Start(enum.Enum):
    """The state a case starts from (starts.py makes it)."""
    GENERATED = "random packing generated at density 0.64"
    DENSE = "the generated packing after sintering to 0.80, with its necks"
    LOOSE = "the generated packing, a third of its contacts taken out"
    RADIUS_RATIO_10 = "random packing, largest radius ten times the smallest"
    MEASURED = "a packing file"


@dataclasses.dataclass(frozen=True)
class BenchCase:
    name: str
    start: Start
    particles: int  # asked for; what was made stands in the result
    cell: str = "free"  # or "periodic"
    sliding_resistance: float = USUAL_SLIDING
    to_density: float = 0.87
    accuracy: float = 0.01
    packing_file: typing.Optional[pathlib.Path] = None  # of a MEASURED start

    def is_quick(self):
        return self.particles <= LARGEST_QUICK

    def runs(self):
        """Runs for the median: many where one is short."""
        return 5 if self.particles <= 1_000 else 3 if self.is_quick() else 1

    def told(self):
        return (f"{self.start.value}; {self.cell}, eta {self.sliding_resistance:g}, to density {self.to_density:g}"
                + ("" if self.is_quick() else "; only by name"))

    def case_keys(self):
        """Keys of the case file, without the packing."""
        return with_keys(base_case(), cell={"kind": self.cell}, contact={"sliding_resistance": self.sliding_resistance},
                         stop={"relative_density": self.to_density}, method={"accuracy": self.accuracy},
                         output={"every_steps": 1, "snapshots": False})


def named_cases():
    """Every case of the suite, in the order of the tables."""
    cases = []
    for label, count in SIZES.items():
        cases += [BenchCase(f"free-{label}-eta-{eta:g}", Start.GENERATED, count, sliding_resistance=eta)
                  for eta in SLIDING_RESISTANCES]
        cases.append(BenchCase(f"periodic-{label}", Start.GENERATED, count, cell="periodic"))
    for label in ("1k", "10k", "100k"):
        count = SIZES[label]
        cases.append(BenchCase(f"fresh-{label}", Start.GENERATED, count, cell="periodic", to_density=0.72))
        cases.append(BenchCase(f"dense-{label}", Start.DENSE, count, cell="periodic"))
        cases += [BenchCase(f"loose-{label}-eta-{eta:g}", Start.LOOSE, count, sliding_resistance=eta)
                  for eta in (0.001, USUAL_SLIDING)]
        cases.append(BenchCase(f"radius-ratio-10-{label}", Start.RADIUS_RATIO_10, count, cell="periodic"))
    return cases


def measured_case(path):
    """The case of a packing file (CSV with a free body), whose size is not known before it is read."""
    return BenchCase(f"measured-{path.stem}", Start.MEASURED, 0, packing_file=path)


def select(cases, patterns):
    """The cases whose names match one of the shell patterns, in their order. ValueError for a pattern without a match."""
    for pattern in patterns:
        if not any(fnmatch.fnmatchcase(case.name, pattern) for case in cases):
            raise ValueError(f"no benchmark is called {pattern!r}; ./dev bench --list shows all")
    return [case for case in cases if any(fnmatch.fnmatchcase(case.name, pattern) for pattern in patterns)]
