"""frit: how a powder sinters, by non-smooth contact dynamics.

    import frit

    case = frit.load_case("case.toml", {"stop.time": "1 h"})
    run = frit.run(case, "results/case", on_row=lambda run: print(run.row["relative_density"]))
    frit.plot(run, y="relative_density", x="time")

Numbers are in SI units everywhere. Arrays have a row a particle (N) or a contact (K), in the order of the stable ids.
Results are the same bits as those of the program, for any number of threads. docs/python.md tells more.
"""

from ._frit import (ContractError, Error, InputError, MachineError, State, __version__, describe, materials, set_threads,
                    threads)
from .case import Case, Packing, load_case, parse_case
from .plot import plot
from .result import Result, Snapshot, read_particles, read_result
from .series import Series
from .simulation import Ending, Simulation, run

__all__ = [
    "Case", "ContractError", "Ending", "Error", "InputError", "MachineError", "Packing", "Result", "Series", "Simulation",
    "Snapshot", "State", "__version__", "describe", "load_case", "materials", "parse_case", "plot", "read_particles",
    "read_result", "run", "set_threads", "threads"
]
