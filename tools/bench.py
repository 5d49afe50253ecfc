#!/usr/bin/env python3
"""Time and memory of free balls from their first density to 0.87 at accuracy 0.01 (docs/performance.md).

Medians of several runs; details and the machine go to results/bench.json, a table to the terminal.
"""
import argparse
import json
import pathlib
import platform
import statistics
import sys
import tempfile

from validation import program
from validation.claims import write_between
from validation.program import Workshop, base_case, random_dense, read_packing, with_keys

FIGURES = ["wall [s]", "cpu [s]", "steps", "rejected", "newton", "cg", "memory [MB]"]
LONGEST_RUN = 24 * 3600.0  # [s]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sizes", default="1000,10000,100000", help="numbers of particles, with commas; empty: none")
    parser.add_argument("--runs", type=int, default=3, help="runs of each, for the median")
    parser.add_argument("--threads", type=int, default=0, help="0: every processor")
    parser.add_argument("--packing", type=pathlib.Path, metavar="FILE", help="also this CSV packing, as a free body")
    parser.add_argument("--program", type=pathlib.Path, help="the program to measure (default: the release build)")
    parser.add_argument("--write", action="store_true", help="put the table into docs/performance.md")
    return parser.parse_args()


def figures_of(summary):
    return {"wall [s]": summary["wall_s"]["total"], "cpu [s]": summary["cpu_s"]["total"], "steps": summary["steps"],
            "rejected": summary["rejected_steps"], "newton": summary["newton_iterations"],
            "cg": summary["solver_iterations"], "memory [MB]": summary["peak_memory_bytes"] / 1e6}


def measure(workshop, spheres, arguments):
    """Figures of every run on these spheres, and what the program says of the machine."""
    case = with_keys(base_case(), contact={"sliding_resistance": 0.01}, stop={"relative_density": 0.87},
                     method={"accuracy": 0.01}, output={"snapshots": False})
    runs = []
    for _ in range(arguments.runs):
        summary = workshop.run(case, spheres, threads=arguments.threads, longest=LONGEST_RUN).summary()
        runs.append(figures_of(summary))
    return runs, {"version": summary["version"], "threads": summary["threads"], **summary["machine"]}


def packings(arguments, workshop):
    """(name, spheres) of every case, made one by one."""
    for size in filter(None, arguments.sizes.split(",")):
        yield f"{int(size):,} generated", workshop.pack(random_dense(int(size)))
    if arguments.packing:
        spheres = read_packing(arguments.packing)
        yield f"{len(spheres):,} from {arguments.packing.name}", spheres


def markdown(entries):
    lines = ["| particles | " + " | ".join(FIGURES) + " |", "|---|" + "---:|" * len(FIGURES)]
    for entry in entries:
        cells = [f"{entry['median'][figure]:,.{1 if figure.endswith('[s]') else 0}f}" for figure in FIGURES]
        lines.append(f"| {entry['name']} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def main():
    arguments = parse_arguments()
    if arguments.program:
        program.PROGRAM = arguments.program.resolve()
    if not program.PROGRAM.is_file():
        print(f"bench: {program.PROGRAM} is not there; run ./dev build first", file=sys.stderr)
        return 2
    entries, machine = [], {"system": platform.platform()}
    with tempfile.TemporaryDirectory(prefix="frit-bench-") as folder:
        workshop = Workshop(folder)
        for name, spheres in packings(arguments, workshop):
            runs, told = measure(workshop, spheres, arguments)
            machine.update(told)
            median = {figure: statistics.median(run[figure] for run in runs) for figure in FIGURES}
            entries.append({"name": name, "particles": len(spheres), "median": median, "runs": runs})
            print(f"{name}: {median['wall [s]']:.1f} s", flush=True)
    results = program.ROOT / "results"
    results.mkdir(exist_ok=True)
    (results / "bench.json").write_text(json.dumps({"machine": machine, "cases": entries}, indent=2) + "\n", encoding="utf-8")
    print(f"\n{machine.get('cpu', '')}, {machine.get('threads', '?')} threads, median of {arguments.runs}\n\n{markdown(entries)}")
    if arguments.write:
        write_between(program.ROOT / "docs/performance.md", "bench", markdown(entries))
    return 0


if __name__ == "__main__":
    sys.exit(main())
