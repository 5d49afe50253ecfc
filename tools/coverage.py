#!/usr/bin/env python3
"""Lines of src/ that the tests have reached in a build with --coverage, by folder; exits with 1 below --least percent in all.

Needs gcovr. Lines that no test can reach are no exception: there is no list of what is left out. `--missed FOLDER` lists the lines that
were not reached in a folder of src/.
"""
import argparse
import collections
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def reached_lines(build):
    """{file relative to src/: {line: times reached}}"""
    done = subprocess.run(["gcovr", "--root", str(ROOT), "--filter", str(ROOT / "src") + "/", "--json", "-",
                           "--gcov-ignore-parse-errors", str(build)],
                          cwd=build, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"gcovr failed: {done.stderr.strip()[-2000:]}")
    files = {}
    for entry in json.loads(done.stdout)["files"]:
        path = pathlib.PurePath(entry["file"]).relative_to("src")
        files[path] = {line["line_number"]: line["count"] for line in entry["lines"] if not line.get("gcovr/noncode")}
    return files


def table(files):
    """Rows of (folder, lines, reached), folders by name, the sum last."""
    sums = collections.defaultdict(lambda: [0, 0])
    for path, lines in files.items():
        for name in (path.parts[0], "all"):
            sums[name][0] += len(lines)
            sums[name][1] += sum(1 for count in lines.values() if count > 0)
    order = sorted(name for name in sums if name != "all")
    return [(name, *sums[name]) for name in [*order, "all"]]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/coverage")
    parser.add_argument("--least", type=float, default=90.0, help="percent of lines in all (default: %(default)s)")
    parser.add_argument("--missed", metavar="FOLDER", help="list the lines of this folder that were not reached")
    arguments = parser.parse_args()
    files = reached_lines(arguments.build.resolve())
    if arguments.missed:
        for path, lines in sorted(files.items()):
            if path.parts[0] == arguments.missed:
                missed = [str(line) for line, count in sorted(lines.items()) if count == 0]
                print(f"src/{path}: {' '.join(missed)}" if missed else f"src/{path}: all")
        return 0
    rows = table(files)
    print("| folder | lines | reached | % |\n|---|---|---|---|")
    for name, lines, reached in rows:
        print(f"| {name} | {lines} | {reached} | {100.0 * reached / lines:.1f} |")
    return 0 if 100.0 * rows[-1][2] / rows[-1][1] >= arguments.least else 1


if __name__ == "__main__":
    sys.exit(main())
