#!/usr/bin/env python3
"""Checks that everything others wrote is listed in docs/licences.md, under a licence that is allowed where it is used.

Looked at: find_package and pkg_check_modules of CMake, #include <...> of src/, Debian packages of ./dev, web/package-lock.json, imports of
web/src, the shared libraries of built programs (--binary), Debian's copyright files where they are installed, and our own LICENSE. Prints
every fault and exits with 1 if there is any. `--self-test` proves that each kind of fault is found.
"""
import argparse
import copy
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LINKED = {"Apache-2.0", "MIT", "BSD-3-Clause", "Zlib", "MPL-2.0", "LGPL-2.1", "GPL-3.0 with GCC's runtime exception"}
ALLOWED = {"linked": LINKED, "headers": LINKED - {"LGPL-2.1"}}
FREE = LINKED | {"GPL-2.0", "GPL-3.0", "PSF-2.0"}  # for what is no part of the program
DEBIAN_WORDS = {  # how Debian's copyright files say it
    "Apache-2.0": r"Apache-2|Apache License", "MIT": r"Expat|MIT", "BSD-3-Clause": r"BSD-3-clause|BSD-C3|BSD-2-clause",
    "Zlib": r"Zlib", "MPL-2.0": r"MPL-2", "LGPL-2.1": r"LGPL-2\.1|Lesser General Public License", "GPL-2.0": r"GPL-2|General Public License",
    "PSF-2.0": r"PSF|PYTHON SOFTWARE FOUNDATION", "GPL-3.0 with GCC's runtime exception": r"Runtime Library Exception|RUNTIME LIBRARY EXCEPTION"}
IMPORT = re.compile(r"""^\s*(?:(?:import|export)\b[^;'"()]*?\bfrom|import)\s*["']([^"']+)["']|\bimport\(["']([^"']+)["']\)""", re.MULTILINE)
NPM_ALLOWED = {"MIT", "Apache-2.0", "ISC", "BSD-2-Clause", "BSD-3-Clause", "0BSD"}


def listed(text):
    """Rows of the table of docs/licences.md as dictionaries; the last four columns are sets of words."""
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines() if line.startswith("|")]
    return [{"name": row[0], "licence": row[1], "in": row[2], "packages": set(row[3].split()), "cmake": set(row[4].split()),
             "headers": set(row[5].split()), "libraries": set(row[6].split())} for row in rows[2:]]


def used_by_cmake():
    """{name: where} of what CMake looks for."""
    lists = [path for folder in ("src", "cmake", "tests", "tools", "share") for pattern in ("CMakeLists.txt", "*.cmake")
             for path in (ROOT / folder).rglob(pattern) if "consumer" not in path.parts]
    found = {}
    for path in [ROOT / "CMakeLists.txt", *lists]:
        for match in re.finditer(r"^\s*(?:find_package\((\w+)|pkg_check_modules\(\w+ .*?(\w+)\))", path.read_text(), re.MULTILINE):
            found[match.group(1) or match.group(2)] = path.relative_to(ROOT).as_posix()
    found.pop("frit", None)
    return found


def used_headers():
    """{header: file} of what src/ includes and neither the standard library nor we have."""
    found = {}
    for path in sorted((ROOT / "src").rglob("*.[ch]pp")):
        for name in re.findall(r"^\s*#\s*include\s+<([^>]+)>", path.read_text(), re.MULTILINE):
            if not re.fullmatch(r"[a-z_0-9]+", name):
                found.setdefault(name, path.relative_to(ROOT).as_posix())
    return found


def used_packages():
    """{package: where} of the Debian packages that ./dev installs."""
    text = (ROOT / "dev").read_text()
    lists = re.findall(r"^\w+_packages=\((.*?)\)", text, re.MULTILINE | re.DOTALL)
    return {word: "dev" for words in lists for word in words.split() if not word.startswith('"$')}


def used_libraries(binaries):
    """{library: binary} of the shared libraries that binaries ask for, without version."""
    found = {}
    for binary in binaries:
        out = subprocess.run(["readelf", "-d", binary], capture_output=True, text=True, check=True).stdout
        for name in re.findall(r"\(NEEDED\).*\[(.*?)\.so", out):
            found[name] = str(binary)
    return found


def compare(rows, column, used, faults):
    """Faults of what is used and not listed, and of what is listed and not used."""
    known = {word for row in rows for word in row[column]}
    for name, where in used.items():
        if not any(name == word or word.endswith("/") and name.startswith(word) for word in known):
            faults.append(f"{where}: {name} is not in docs/licences.md ({column})")
    for word in sorted(known):
        if not any(name == word or word.endswith("/") and name.startswith(word) for name in used):
            faults.append(f"docs/licences.md: {word} is listed and not used ({column})")


def check_licences(rows, faults):
    """Whether each licence is allowed where its work is used, and is the one of Debian's copyright file (of build tools
    often that of a package without contents)."""
    for row in rows:
        if row["in"] not in ("headers", "linked", "beside", "tests", "build"):
            faults.append(f'docs/licences.md: {row["name"]}: "{row["in"]}" is no place')
        elif row["licence"] not in ALLOWED.get(row["in"], FREE):
            faults.append(f'docs/licences.md: {row["name"]}: {row["licence"]} is not allowed in what is {row["in"]}')
        for package in sorted(row["packages"]):
            text = pathlib.Path("/usr/share/doc", package, "copyright")
            words = DEBIAN_WORDS.get(row["licence"])
            if row["in"] != "build" and words and text.is_file() and not re.search(words, text.read_text(errors="replace"), re.IGNORECASE):
                faults.append(f'docs/licences.md: {row["name"]}: {text} does not speak of {row["licence"]}')


def check_page(lock, scripts, faults):
    """Licences of npm's packages; the page's scripts import only each other."""
    for name, package in lock["packages"].items():
        if package.get("license") not in NPM_ALLOWED:
            faults.append(f'web/package-lock.json: {name or "frit"}: licence {package.get("license")} is not allowed')
    for path, text in scripts.items():
        for name in IMPORT.findall(text):
            if not "".join(name).startswith("."):
                faults.append(f"web/src/{path}: imports {''.join(name)}: it would become part of the page")


def check_ours(licence, faults):
    if "Apache License" not in licence or "Version 2.0" not in licence:
        faults.append("LICENSE: not the Apache License 2.0")


def gather(binaries):
    """What the checks look at."""
    return {"rows": listed((ROOT / "docs/licences.md").read_text()), "cmake": used_by_cmake(), "headers": used_headers(),
            "packages": used_packages(), "libraries": used_libraries(binaries), "lock": json.loads((ROOT / "web/package-lock.json").read_text()),
            "scripts": {path.name: path.read_text() for path in (ROOT / "web/src").glob("*.ts")},
            "licence": (ROOT / "LICENSE").read_text()}


def check(facts):
    """All faults."""
    faults = []
    check_licences(facts["rows"], faults)
    for column in ("cmake", "headers", "packages"):
        compare(facts["rows"], column, facts[column], faults)
    if facts["libraries"]:
        compare(facts["rows"], "libraries", facts["libraries"], faults)
    check_page(facts["lock"], facts["scripts"], faults)
    check_ours(facts["licence"], faults)
    return faults


def self_test(facts):
    """Number of seeded faults that are not found, one by one."""
    def row(name):
        return lambda f: next(row for row in f["rows"] if row["name"] == name)
    seeds = {
        "is not in docs/licences.md (cmake)": lambda f: f["cmake"].update(Boost="CMakeLists.txt"),
        "is not in docs/licences.md (headers)": lambda f: f["headers"].update({"Eigen/Sparse": "src/a.cpp"}),
        "is not in docs/licences.md (packages)": lambda f: f["packages"].update({"libgsl-dev": "dev"}),
        "is not in docs/licences.md (libraries)": lambda f: f["libraries"].update({"libgsl": "frit"}),
        "listed and not used": lambda f: f["headers"].pop("zlib.h"),
        "GPL-2.0 is not allowed in what is linked": lambda f: row("SuiteSparse (CHOLMOD)")(f).update({"in": "linked"}),
        "LGPL-2.1 is not allowed in what is headers": lambda f: row("cairo")(f).update({"in": "headers"}),
        "is no place": lambda f: row("fmt")(f).update({"in": "somewhere"}),
        "does not speak of MPL-2.0": lambda f: row("zlib")(f).update({"licence": "MPL-2.0"}),
        "licence None is not allowed": lambda f: f["lock"]["packages"].update(x={}),
        "it would become part of the page": lambda f: f["scripts"].update({"a.ts": 'import {x} from "three";'}),
        "not the Apache License": lambda f: f.update(licence="All rights reserved"),
    }
    failed = 0
    for expected, sow in seeds.items():
        sown = copy.deepcopy(facts)
        sow(sown)
        found = check(sown)
        if not any(expected in fault for fault in found):
            failed += 1
            print(f"self-test: expected {expected!r}, found {found}")
    print(f"check_licences: {len(seeds) - failed} of {len(seeds)} self-tests passed")
    return failed


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--self-test", action="store_true", help="check the checker")
    parser.add_argument("--binary", nargs="*", default=[], help="built programs and modules whose shared libraries to check")
    arguments = parser.parse_args()
    facts = gather(arguments.binary)
    if arguments.self_test:
        return 1 if self_test(facts) else 0
    faults = check(facts)
    print("\n".join(faults) if faults else "check_licences: everything is listed and allowed")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
