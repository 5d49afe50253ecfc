#!/usr/bin/env python3
"""Named benchmarks: time and memory of whole runs, memory bandwidth, a smooth code beside frit, a profile.

What the names mean: docs/performance.md, or --list. Figures are merged into results/bench.json by name, so that benchmarks
can be run one by one; tables go to the terminal, and with --write into docs/performance.md.
"""
import argparse
import os
import pathlib
import platform
import subprocess
import sys
import tempfile

from benchmarks import bandwidth, ledger, measure, peers, profiling, self_test, tables
from benchmarks.cases import BenchCase, Start, measured_case, named_cases, select
from benchmarks.starts import Starts
from validation import program
from validation.claims import write_between
from validation.program import RunFailed, Workshop

DEFAULT_BUILD = program.ROOT / "build/release"
PAGE = program.ROOT / "docs/performance.md"
PROFILED_DENSITY = 0.65  # a few steps from the first one on


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help="shell patterns of names; none: every case up to 10,000 particles")
    parser.add_argument("--list", action="store_true", help="show all names and end")
    parser.add_argument("--runs", type=int, default=0, help="runs of each case, for the median (0: as many as the case wants)")
    parser.add_argument("--threads", type=int, default=len(os.sched_getaffinity(0)), help="of frit (default: every processor)")
    parser.add_argument("--reference", action="store_true", help=f"also one run at accuracy {measure.REFERENCE_ACCURACY:g} of each case, "
                                                                 "and the differences from it")
    parser.add_argument("--independence", action="store_true", help="also runs with ten times and a tenth of the mass and with a hundredth of the "
                                                                    "tolerance, and the differences")
    parser.add_argument("--packing", type=pathlib.Path, metavar="FILE", help="this CSV packing, as a free body")
    parser.add_argument("--particles", type=int, default=1000, help="of peers and profile (1000)")
    parser.add_argument("--build", type=pathlib.Path, default=DEFAULT_BUILD, help="build folder of the program to measure (build/release)")
    parser.add_argument("--write", action="store_true", help="put all tables into docs/performance.md")
    parser.add_argument("--self-test", action="store_true", help="test the arithmetic of the benchmarks themselves and end")
    return parser.parse_args()


class Session:
    """What the benchmarks of one call share."""

    def __init__(self, arguments, folder):
        self.arguments, self.workshop = arguments, Workshop(folder)
        self.starts = Starts(self.workshop, arguments.threads)
        self.ledger = ledger.load()

    def keep(self, entry):
        """The entry, with what it was measured on."""
        entry["system"], entry["sources"] = platform.platform(), ledger.commit()
        return entry

    def run_case(self, case):
        """Measures a case into the ledger; False if a run failed."""
        arguments = self.arguments
        effort = measure.Effort(arguments.threads, arguments.runs, arguments.reference, arguments.independence)
        try:
            entry = measure.measure(self.workshop, self.starts, case, effort)
        except RunFailed as failure:
            entry = {"what": case.told(), "failed": str(failure)}
        self.ledger["cases"][case.name] = self.keep(entry)
        print(f"{case.name}: " + (f"{entry['median']['wall [s]']:.1f} s" if "median" in entry else entry["failed"]), flush=True)
        return "failed" not in entry

    def run_bandwidth(self):
        self.ledger["bandwidth"] = self.keep({"triad": bandwidth.measure(self.arguments.build.resolve())})

    def run_peers(self):
        if not peers.is_installed():
            print(f"peers: skipped, the Debian package {peers.PACKAGE} is not installed (apt-get install {peers.PACKAGE})")
            return
        case = BenchCase("peers", Start.GENERATED, self.arguments.particles)
        start = self.starts.of(case)
        figures, rows, summary = measure.run_once(self.workshop, start.keys(case.case_keys()), 1)
        entry = peers.compare(self.workshop, start, figures, rows)
        entry |= {"accuracy": case.accuracy, "to density": case.to_density, "machine": summary["machine"]}
        self.ledger["peers"] = self.keep(entry)

    def run_profile(self):
        if not profiling.is_installed():
            print(f"profile: skipped, the Debian package {profiling.PACKAGE} is not installed (apt-get install {profiling.PACKAGE})")
            return
        case = BenchCase("profile", Start.GENERATED, self.arguments.particles, to_density=PROFILED_DENSITY)
        keys = self.starts.of(case).keys(case.case_keys())
        entry = profiling.profile(self.workshop.new_folder(), keys)
        self.ledger["profile"] = self.keep({"what": case.told(), "particles": case.particles, **entry})


STUDIES = {
    "bandwidth": (Session.run_bandwidth, "memory bandwidth by the triad, and the roofline of the measured cases"),
    "peers": (Session.run_peers, "time per step of LIGGGHTS on the same packing, and the steps it would need"),
    "profile": (Session.run_profile, "functions by instructions, from callgrind"),
}
STUDY_TABLES = {"bandwidth": ["bandwidth", "roofline"], "peers": ["peers"], "profile": ["profile-exclusive", "profile-inclusive"]}


def list_names(cases):
    for name, told in [(case.name, case.told()) for case in cases] + [(name, told) for name, (_, told) in STUDIES.items()]:
        print(f"{name:24} {told}")


def chosen(arguments, cases):
    """(cases, names of studies) to run. ValueError for a name that does not exist."""
    studies = [name for name in arguments.names if name in STUDIES]
    patterns = [name for name in arguments.names if name not in STUDIES]
    picked = select(cases, patterns)
    if arguments.packing:
        picked.append(measured_case(arguments.packing))
    elif not arguments.names:
        picked = [case for case in cases if case.is_quick()]
    return picked, studies


def run(arguments, cases, studies):
    """Runs them one by one, each saved at once; prints their tables. The exit code."""
    good = True
    with tempfile.TemporaryDirectory(prefix="frit-bench-") as folder:
        session = Session(arguments, folder)
        for case in cases:
            good = session.run_case(case) and good
            ledger.save(session.ledger)
        for study in studies:
            STUDIES[study][0](session)
            ledger.save(session.ledger)
    told = session.ledger
    names = [case.name for case in cases]
    if cases:
        print("\n" + tables.case_table(told, names))
    if arguments.reference and cases:
        print("\ndifference [%] from the reference run\n\n" + tables.accuracy_table(told, names))
    if arguments.independence and cases:
        print("\nlargest difference [%] when what must not matter is changed\n\n" + tables.independence_table(told, names))
    every = tables.all_tables(told, named_cases())
    for marker in (marker for study in studies for marker in STUDY_TABLES[study]):
        print(f"\n{marker}\n\n{every[marker]}")
    if arguments.write:
        for marker, text in every.items():
            write_between(PAGE, f"bench-{marker}", text)
    return 0 if good else 1


def main():
    arguments = parse_arguments()
    cases = named_cases()
    if arguments.list:
        list_names(cases)
        return 0
    if arguments.self_test:
        return self_test.run()
    program.PROGRAM = arguments.build.resolve() / "src/app/frit"
    if not program.PROGRAM.is_file():
        print(f"bench: {program.PROGRAM} is not there; run ./dev build first", file=sys.stderr)
        return 2
    try:
        return run(arguments, *chosen(arguments, cases))
    except ValueError as wrong:
        print(f"bench: {wrong}", file=sys.stderr)
        return 2
    except subprocess.CalledProcessError as failure:
        print(f"bench: {failure}\n{failure.stderr or ''}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
