#!/usr/bin/env python3
"""Runs the program on cases with known answers and compares (docs/validation.md).

Exit code 1 if a claim fails, 2 if the program is not built.
"""
import argparse
import functools
import pathlib
import sys
import tempfile
import time

from validation import claims as claims_of
from validation import free_body, interruptions, lattices, methods, packings, pairs, program

QUICK = [pairs.growth_equal, pairs.growth_unequal, pairs.times_of_paper, pairs.loaded, pairs.pulled_open,
         pairs.equilibrium, pairs.parhami_mcmeeking, pairs.chain, lattices.lattices, lattices.mean_field, packings.two_solvers,
         packings.symmetries, packings.thread_counts, methods.explicit_pair, methods.lattices_by_all_methods]
LONG = [interruptions.kills, interruptions.failing_calls, packings.order_without_births, packings.order_with_births, methods.alumina_ball]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="only what takes less than a minute together")
    parser.add_argument("--write", action="store_true", help="put the table into docs/validation.md")
    parser.add_argument("--packing", type=pathlib.Path, metavar="FILE",
                        help="CSV packing for the free body instead of a generated one")
    parser.add_argument("--only", metavar="TEXT", help="only groups whose name contains the text")
    parser.add_argument("--program", type=pathlib.Path, help="the program to test (default: the release build)")
    return parser.parse_args()


def groups(arguments):
    """(name, check) of every group; check is None when it is skipped."""
    ball = functools.partial(free_body.free_ball, packing=arguments.packing)
    long = [(check.__name__, check) for check in LONG] + [("free_ball", ball)]
    chosen = [(check.__name__, check) for check in QUICK]
    chosen += [(name, None if arguments.quick else check) for name, check in long]
    return [(name, check) for name, check in chosen if not arguments.only or arguments.only in name]


def check_group(name, check, workshop):
    """Claims of one group; a program that fails is a claim that fails."""
    if check is None:
        return [claims_of.is_skipped(name, "left out by --quick")]
    try:
        return check(workshop)
    except program.RunFailed as failure:
        return [claims_of.has_failed(name, str(failure))]


def main():
    arguments = parse_arguments()
    if arguments.program:
        program.PROGRAM = arguments.program.resolve()
    if not program.PROGRAM.is_file():
        print(f"validate: {program.PROGRAM} is not there; run ./dev build first", file=sys.stderr)
        return 2
    found = []
    with tempfile.TemporaryDirectory(prefix="frit-validate-") as folder:
        workshop = program.Workshop(folder)
        for name, check in groups(arguments):
            began = time.monotonic()
            found_here = check_group(name, check, workshop)
            print(f"{name} ({time.monotonic() - began:.1f} s)")
            for claim in found_here:
                claims_of.print_claim(claim)
            found += found_here
    failed = sum(claim.passed is False for claim in found)
    skipped = sum(claim.passed is None for claim in found)
    print(f"validate: {len(found) - failed - skipped} claims hold, {failed} fail, {skipped} groups skipped")
    if arguments.write:
        claims_of.write_between(program.ROOT / "docs/validation.md", "validation", claims_of.markdown(found))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
