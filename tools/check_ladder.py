#!/usr/bin/env python3
"""Checks the one-way ladder of src/: no folder includes, or links, one on its own rung or above (docs/architecture.md).

Reads the #include lines of src/ and the USES of each folder's CMakeLists.txt. Prints every fault as file:line and
exits with 1 if there is any. `--self-test` proves that each kind of fault is found.
"""
import argparse
import pathlib
import re
import sys

import sown_faults

LADDER = [["core"], ["state", "solve"], ["neighbor"], ["contact"], ["network"], ["integrate", "observe"],
          ["generate", "io", "config"], ["run"], ["report", "analyze"], ["app", "python"]]
RUNG = {folder: rung for rung, folders in enumerate(LADDER) for folder in folders}
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"')
KEYWORDS = {"SOURCES", "USES", "LIBRARIES"}


def forbidden(user, used):
    """Why `user` may not depend on `used`, or None."""
    if user == used or RUNG[used] < RUNG[user]:
        return None
    kind = "a sibling" if RUNG[used] == RUNG[user] else "a higher rung"
    return f"{user} must not use {used}, {kind}"


def uses_of(text):
    """(line, folder) for each folder that a CMakeLists.txt links: words after USES, and frit_<folder>."""
    in_uses = False
    for line, content in enumerate(text.splitlines(), 1):
        for word in re.findall(r"[\w:.${}/]+|\)", content.split("#")[0]):
            if word in KEYWORDS or word == ")":
                in_uses = word == "USES"
            elif in_uses:
                yield line, word
            elif word.startswith("frit_") and word[len("frit_"):] in RUNG:
                yield line, word[len("frit_"):]


def reachable(folder, links):
    """Folders that `folder` sees through its own links and theirs."""
    seen, waiting = set(), [folder]
    while waiting:
        for used in links.get(waiting.pop(), ()):
            if used not in seen:
                seen.add(used)
                waiting.append(used)
    return seen


def check_links(folder, faults):
    """The folders that `folder` links; its wrong links go to `faults`."""
    lists = folder / "CMakeLists.txt"
    if not lists.is_file():
        return set()
    found = set()
    for line, used in uses_of(lists.read_text()):
        if used not in RUNG:
            faults.append(f"{lists}:{line}: {used} is not on the ladder")
            continue
        found.add(used)
        if reason := forbidden(folder.name, used):
            faults.append(f"{lists}:{line}: {reason}")
    return found - {folder.name}


def include_fault(folder, included, linked):
    """What is wrong with an include of `included` by a file of `folder`, or None."""
    used = included.split("/")[0]
    if "/" not in included or used not in RUNG:
        return f'"{included}" is not written relative to src/'
    if reason := forbidden(folder, used):
        return f"{reason} (includes {included})"
    if used != folder and used not in linked:
        return f"{folder} includes {included} but its CMakeLists.txt does not link {used}"
    return None


def check(source):
    """All faults of a source folder, each as text with file and line."""
    faults = []
    folders = sorted(path for path in source.iterdir() if path.is_dir())
    for folder in folders:
        if folder.name not in RUNG:
            faults.append(f"{folder}:1: {folder.name} is not on the ladder")
    folders = [folder for folder in folders if folder.name in RUNG]
    links = {folder.name: check_links(folder, faults) for folder in folders}
    for folder in folders:
        linked = reachable(folder.name, links)
        for path in sorted(folder.rglob("*.[ch]pp")):
            for line, content in enumerate(path.read_text().splitlines(), 1):
                match = INCLUDE.match(content)
                fault = include_fault(folder.name, match.group(1), linked) if match else None
                if fault:
                    faults.append(f"{path}:{line}: {fault}")
    return faults


SELF_TESTS = [  # what is written, the fault expected (None: none)
    ({"contact/CMakeLists.txt": "frit_library(contact SOURCES a.cpp USES state core)",
      "contact/a.cpp": '#include "state/state.hpp"\n#include <vector>\n#include "contact/a.hpp"\n'}, None),
    ({"core/CMakeLists.txt": "", "core/a.hpp": '// note\n#include "run/run.hpp"\n'},
     "a.hpp:2: core must not use run, a higher rung"),
    ({"state/CMakeLists.txt": "", "state/a.hpp": '#include "solve/problem.hpp"\n'},
     "a.hpp:1: state must not use solve, a sibling"),
    ({"io/CMakeLists.txt": "frit_library(io\n  SOURCES a.cpp\n  USES state config)"},
     "CMakeLists.txt:3: io must not use config, a sibling"),
    ({"network/CMakeLists.txt": "target_link_libraries(frit_network PUBLIC frit_app)"}, "network must not use app"),
    ({"contact/CMakeLists.txt": "frit_library(contact USES core)", "contact/a.cpp": '#include "neighbor/neighbor.hpp"\n'},
     "does not link neighbor"),
    ({"contact/CMakeLists.txt": "frit_library(contact USES neighbor)",
      "neighbor/CMakeLists.txt": "frit_library(neighbor USES state)",
      "contact/a.cpp": '#include "state/state.hpp"\n'}, None),
    ({"contact/CMakeLists.txt": "", "contact/a.cpp": '#include "detection.hpp"\n'}, "not written relative to src/"),
    ({"helpers/a.hpp": ""}, "helpers is not on the ladder"),
    ({"io/CMakeLists.txt": "frit_library(io USES sttae)"}, "sttae is not on the ladder"),
]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--self-test", action="store_true", help="check the checker")
    arguments = parser.parse_args()
    if arguments.self_test:
        return 1 if sown_faults.count_failures("check_ladder", check, SELF_TESTS) else 0
    faults = check(pathlib.Path(__file__).resolve().parent.parent / "src")
    print("\n".join(faults) if faults else "check_ladder: every include and link goes down the ladder")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
