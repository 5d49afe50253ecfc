#!/usr/bin/env python3
"""Runs clang-tidy (.clang-tidy) over src/ and remembers which files were clean: a file is looked at again when it, a header of ours
that it includes, its compile command, the set of checks or clang-tidy itself has changed.

Needs a configured build folder (compile_commands.json). Prints every finding once; exits with 1 if there is any.
"""
import argparse
import concurrent.futures
import hashlib
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)
FINDING = re.compile(r"^/.*: (warning|error): .*\[.*\]$")


def with_headers(path, seen):
    """Adds `path` and the headers of ours that it reaches to `seen`: {path: its bytes}."""
    if path in seen or not path.is_file():
        return
    seen[path] = path.read_bytes()
    for name in INCLUDE.findall(seen[path].decode()):
        with_headers(ROOT / "src" / name, seen)


def key_of(entry, common):
    """What the verdict on a file of compile_commands.json depends on, as a hash."""
    files = {}
    with_headers(pathlib.Path(entry["file"]), files)
    key = hashlib.sha256(common + entry["command"].replace(str(ROOT), "").encode())
    for path in sorted(files):
        key.update(str(path.relative_to(ROOT)).encode() + files[path])
    return key.hexdigest()


def findings_of(command, path):
    """The findings in one file, each with its lines of explanation."""
    done = subprocess.run([*command, path], capture_output=True, text=True)
    found = []
    for line in done.stdout.splitlines():
        if FINDING.match(line):
            found.append(line.replace(f"{ROOT}/", ""))
        elif found:
            found[-1] += "\n" + line
    if not found and (done.returncode != 0 or "Error parsing" in done.stderr):
        found.append(f"{path}: clang-tidy failed: {done.stderr.strip()}")
    return found


def wanted(entries, names):
    """The entries of files of src/, or only of those named."""
    chosen = {(pathlib.Path.cwd() / name).resolve() for name in names}
    for entry in entries:
        path = pathlib.Path(entry["file"])
        if path.is_relative_to(ROOT / "src") and (not chosen or path in chosen):
            yield entry


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="*", help="sources to look at (default: all of src/)")
    parser.add_argument("--build", default="build/dev", help="folder with compile_commands.json (default: %(default)s)")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--quick", action="store_true", help="without clang-analyzer, which takes two thirds of the time")
    arguments = parser.parse_args()
    build = ROOT / arguments.build
    stamps = build / "tidy"
    stamps.mkdir(exist_ok=True)
    version = subprocess.run(["clang-tidy", "--version"], capture_output=True, check=True).stdout
    command = ["clang-tidy", "--quiet", "-p", str(build)] + (["--checks=-clang-analyzer-*"] if arguments.quick else [])
    common = (ROOT / ".clang-tidy").read_bytes() + version + str(arguments.quick).encode()
    entries = list(wanted(json.loads((build / "compile_commands.json").read_text()), arguments.files))
    keys = {entry["file"]: key_of(entry, common) for entry in entries}
    todo = [name for name, key in keys.items() if not (stamps / key).exists()]
    shown = set()
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        running = {pool.submit(findings_of, command, name): name for name in todo}
        for done in concurrent.futures.as_completed(running):
            for finding in done.result():
                if finding not in shown:
                    shown.add(finding)
                    print(finding, flush=True)
            if not done.result():
                (stamps / keys[running[done]]).touch()
    print(f"clang-tidy: {len(entries)} files, {len(todo)} looked at, {len(shown)} findings")
    return 1 if shown else 0


if __name__ == "__main__":
    sys.exit(main())
