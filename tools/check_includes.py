#!/usr/bin/env python3
"""Checks the include lines of src/: each file includes what it uses of the standard library and uses what it includes.

The faults, each as file:line:
  a name of the standard library without its header; a source may rely on the header of its own name
  a standard header of which nothing is used; a header of ours of which no name is used
  an include that stands twice; a source that does not include the header of its own name first, which proves that this compiles alone
  a header without #pragma once
Names are found by text, so it takes a second. `--self-test` proves that each kind of fault is found; `--alone BUILD` compiles every
header that no source includes first, with the flags of the build folder BUILD.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys

import sown_faults

STANDARD = {  # header: the names in std that need it
    "algorithm": "adjacent_find all_of any_of binary_search clamp copy copy_if copy_n count count_if equal fill fill_n find find_if "
                 "find_first_of find_if_not is_sorted lower_bound max max_element min min_element minmax minmax_element none_of nth_element sort stable_sort "
                 "transform unique unique_copy upper_bound ranges::all_of ranges::any_of ranges::binary_search ranges::copy_if "
                 "ranges::count ranges::fill ranges::find ranges::find_if ranges::is_sorted ranges::lower_bound ranges::max_element "
                 "ranges::none_of ranges::replace ranges::replace_if ranges::set_difference ranges::set_intersection ranges::sort "
                 "ranges::transform ranges::count_if ranges::equal ranges::fill_n ranges::generate ranges::min_element ranges::move "
                 "ranges::remove_if ranges::reverse ranges::stable_sort ranges::unique ranges::upper_bound copy_backward equal_range for_each "
                 "generate includes inplace_merge is_sorted_until lexicographical_compare merge mismatch move_backward partial_sort partition "
                 "partition_point replace replace_if reverse rotate search set_difference set_intersection set_union shuffle stable_partition "
                 "swap_ranges remove remove_if",
    "array": "array", "atomic": "atomic", "bit": "bit_cast bit_ceil bit_floor bit_width countl_zero countr_zero endian endian::little endian::native popcount",
    "charconv": "from_chars to_chars chars_format", "chrono": "chrono", "exception": "exception exception_ptr rethrow_exception",
    "cmath": "abs acos asin atan atan2 cbrt ceil copysign cos erf exp expm1 floor fmod hypot isfinite isinf isnan llround log log10 log1p "
             "log2 lerp lround nextafter pow round sin sqrt tan tanh",
    "cstdint": "int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t", "csignal": "signal sig_atomic_t raise",
    "cstdio": "fflush fputs fprintf fopen fclose fwrite rename", "cstdlib": "abort exit getenv", "cstring": "memcpy memset strerror",
    "filesystem": "filesystem", "fstream": "ifstream ofstream", "functional": "function less greater", "iterator": "back_inserter next",
    "limits": "numeric_limits", "map": "map", "memory": "const_pointer_cast make_shared make_unique make_unique_for_overwrite "
    "shared_ptr unique_ptr weak_ptr", "mutex": "lock_guard mutex", "new": "bad_alloc", "numbers": "numbers::pi", "numeric": "accumulate "
    "exclusive_scan inclusive_scan inner_product iota midpoint partial_sum reduce transform_reduce gcd", "optional": "nullopt optional", "set": "set", "span": "as_bytes as_writable_bytes span", "sstream":
    "istringstream ostringstream", "stdexcept": "invalid_argument logic_error out_of_range runtime_error", "string":
    "getline string to_string stod stoll", "string_view": "string_view", "system_error": "errc error_code system_error",
    "tuple": "ignore tie tuple", "type_traits": "is_enum is_enum_v is_same_v is_trivially_copyable_v remove_reference_t false_type",
    "utility": "cmp_greater_equal cmp_less cmp_not_equal declval exchange in_range move pair swap forward",
    "variant": "get_if holds_alternative monostate variant visit", "vector": "vector erase_if", "unordered_map": "unordered_map",
    "thread": "thread", "iostream": "cout cerr cin",
}
HOME = {name: header for header, names in STANDARD.items() for name in names.split()}
ANYWHERE = {"size_t", "ptrdiff_t", "byte", "nullptr_t", "get", "ios", "initializer_list"}  # in many headers; none is theirs alone
ALSO = {"max": {"limits"}, "min": {"limits"}, "abs": {"cstdlib"}, "move": {"algorithm"}, "swap": {"algorithm"},
        "rename": {"filesystem"}}
C_NAMES = {  # headers of C: names that may stand without std::
    "cerrno": r"\berrno\b|\bE[A-Z]{3,}\b", "csignal": r"\bSIG[A-Z0-9]+\b|\bsig\w+", "cstddef": r"\b(size_t|ptrdiff_t|byte|offsetof)\b",
    "cstdio": r"\bstd(out|err|in)\b|\bf(open|close|write|flush|puts|printf|ileno)\b|\bEOF\b",
    "cstdlib": r"\bEXIT_\w+|\bgetenv\b", "ctime": r"\btime_t\b|\btm\b|gmtime|strftime|\btime\(", "cstring": r"\bmem(cpy|set|cmp)\b|strsignal",
    "stdexcept": r"_error\b", "type_traits": r"\bstd::(is|remove|conditional|enable|decay|invoke|integral|underlying)_\w+",
    "iterator": r"\bstd::\w*iterator\w*|\bstd::(size|begin|end|prev|distance)\b", "utility": r"\bstd::(index_sequence|as_const|make_pair)\b",
    "cmath": r"\bM_PI\b", "map": r"\bstd::multimap\b",
}
INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]')
USED = re.compile(r"\bstd::((?:ranges::|numbers::|endian::)?\w+)")
DECLARED = [re.compile(pattern, re.MULTILINE) for pattern in (
    r"^\s*#\s*define\s+(\w+)", r"\b(?:enum\s+class|enum|struct|class|union|concept)\s+(?:\[\[\w+\]\]\s*)?(\w+)", r"\busing\s+(\w+)\s*=",
    r"^(?:  )?[\w:<>,&*\[\]() ]*?[\w>&*\]]\s+[&*]?(\w+)\(", r"^[\w:<>,&* ]*\b(?:const|constexpr|extern)\b[\w:<>,&* ]*?(\w+)(?:\[\w*\])*\s*(?:=|;|\{)",
    r"^\s*(\w+)(?:,| = [^;]*|)$")]


def code_of(text):
    """The text without comments and literals, line by line as before."""
    def blank(match):
        return re.sub(r"[^\n]", " ", match.group(0)) if not match.group(0).startswith("#") else match.group(0)
    return re.sub(r'#\s*include[^\n]*|//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])+\'', blank, text, flags=re.DOTALL)


class File:
    """A file of ours: its code, and its includes as {name: line}."""

    def __init__(self, path):
        self.path, self.faults = path, []
        self.code = code_of(path.read_text())
        self.standard, self.ours, self.order = {}, {}, []
        for line, content in enumerate(self.code.splitlines(), 1):
            if match := INCLUDE.match(content):
                self.add(line, *match.groups())
        self.body = re.sub(r"^\s*#\s*include.*$", "", self.code, flags=re.MULTILINE)
        self.names = {match.group(1): self.code.count("\n", 0, match.start()) + 1 for match in reversed(list(USED.finditer(self.body)))}

    def add(self, line, kind, name):
        known = self.ours if kind == '"' else self.standard
        if name in known:
            self.fault(line, f"{name} is included twice")
        known[name] = line
        self.order.append(name)

    def fault(self, line, text):
        self.faults.append(f"{self.path}:{line}: {text}")

    def declares(self):
        """Names by which others use this header: more than there are, never fewer."""
        return {name for pattern in DECLARED for name in pattern.findall(self.body)}


def headers_of(name):
    """The standard headers that give std::name; None for a name this tool does not know."""
    home = HOME.get(name) or HOME.get(name.split("::")[0])
    return {home} | ALSO.get(name, set()) if home else None


def check_standard(file, own):
    """Standard headers that are missing, and those that are not used."""
    there = set(file.standard) | (set(own.standard) if own else set())
    for name, line in file.names.items():
        if name in ANYWHERE:
            continue
        homes = headers_of(name)
        if homes is None:
            if not any(re.search(pattern, f"std::{name}") for pattern in C_NAMES.values()):
                file.fault(line, f"std::{name} is not in the table of tools/check_includes.py")
        elif not homes & there:
            file.fault(line, f"std::{name} needs <{HOME.get(name) or HOME[name.split('::')[0]]}>")
    used = set().union(*(headers_of(name) or set() for name in file.names))
    for header, line in file.standard.items():
        if header in STANDARD or header in C_NAMES:
            if header not in used and not re.search(C_NAMES.get(header, r"(?!)"), file.body):
                file.fault(line, f"nothing of <{header}> is used")


def check_ours(file, files, own_name):
    """Headers of ours of which nothing is used."""
    words = set(re.findall(r"\w+", file.body))
    for name, line in file.ours.items():
        if name != own_name and name in files and not files[name].declares() & words:
            file.fault(line, f"nothing of {name} is used")


def check(source):
    """All faults of a source folder."""
    files = {path.relative_to(source).as_posix(): File(path) for path in sorted(source.rglob("*.[ch]pp"))}
    for name, file in files.items():
        own_name = name.replace(".cpp", ".hpp") if name.endswith(".cpp") else None
        own = files.get(own_name)
        if own and file.order[:1] != [own_name]:
            file.fault(1, f"{own_name} is not the first include")
        if name.endswith(".hpp") and not re.search(r"^#pragma once$", file.code, re.MULTILINE):
            file.fault(1, "no #pragma once")
        check_standard(file, own)
        check_ours(file, files, own_name)
    return [fault for file in files.values() for fault in file.faults]


SELF_TESTS = [  # files, the fault expected (None: none)
    ({"io/a.hpp": "#pragma once\n#include <vector>\nstruct A { std::vector<int> v; };\n",
      "io/a.cpp": '#include "io/a.hpp"\nstd::vector<int> v; // std::map\nconst char* t = "std::map";\n'}, None),
    ({"io/a.cpp": "std::vector<int> v;\n"}, "a.cpp:1: std::vector needs <vector>"),
    ({"io/a.cpp": "#include <vector>\n#include <map>\nstd::vector<int> v;\n"}, "a.cpp:2: nothing of <map> is used"),
    ({"io/a.cpp": "#include <map>\n#include <map>\nstd::map<int, int> v;\n"}, "a.cpp:2: map is included twice"),
    ({"io/a.hpp": "struct A {};\n"}, "no #pragma once"),
    ({"io/a.hpp": "#pragma once\n", "io/a.cpp": '#include <map>\n#include "io/a.hpp"\nstd::map<int, int> v;\n'}, "not the first include"),
    ({"io/a.hpp": "#pragma once\nint answer(int);\n", "io/b.cpp": '#include "io/a.hpp"\nint b = 1;\n'}, "b.cpp:1: nothing of io/a.hpp"),
    ({"io/a.hpp": "#pragma once\nint answer(int);\n", "io/b.cpp": '#include "io/a.hpp"\nint b = answer(1);\n'}, None),
    ({"io/a.hpp": "#pragma once\nenum class A { first };\n", "io/b.cpp": '#include "io/a.hpp"\nA b;\n'}, None),
    ({"io/a.cpp": "int a = std::frobnicate(1);\n"}, "std::frobnicate is not in the table"),
]


def compile_alone(source, build):
    """Headers that no source of their name compiles first: what the compiler says of those that do not compile alone."""
    entries = json.loads((build / "compile_commands.json").read_text())
    faults = []
    for header in sorted(source.rglob("*.hpp")):
        if header.with_suffix(".cpp").exists():
            continue
        entry = next(e for e in entries if pathlib.Path(e["file"]).parent == header.parent)
        command = re.sub(r" -o \S+ -c \S+.*", f" -fsyntax-only -w -x c++ {header}", entry["command"])
        done = subprocess.run(command, shell=True, cwd=entry["directory"], capture_output=True, text=True)
        if done.returncode != 0:
            faults.append(f"{header}:1: does not compile alone\n{done.stderr.strip()}")
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--self-test", action="store_true", help="check the checker")
    parser.add_argument("--alone", metavar="BUILD", type=pathlib.Path, help="compile headers with the flags of this build folder")
    arguments = parser.parse_args()
    if arguments.self_test:
        return 1 if sown_faults.count_failures("check_includes", check, SELF_TESTS) else 0
    source = pathlib.Path(__file__).resolve().parent.parent / "src"
    faults = compile_alone(source, arguments.alone) if arguments.alone else check(source)
    print("\n".join(faults) if faults else "check_includes: every include is needed, none is missing")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
