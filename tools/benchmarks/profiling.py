"""Where the instructions of a run go, function by function, by valgrind's callgrind."""
import re
import shutil
import subprocess

from validation import program

from . import ledger

PACKAGE = "valgrind"
MOST_LISTED = 15
LINE = re.compile(r"^\s*([\d,]+) \(\s*([\d.]+)%\)\s+(.+)$")


def is_installed():
    return shutil.which("valgrind") is not None and shutil.which("callgrind_annotate") is not None


def short_name(text):
    """file:function(arguments) [object] -> function without arguments and template parameters."""
    name = re.sub(r"\s*\[[^\]]*\]$", "", text).split(":", 1)[1]
    name = name.replace("(anonymous namespace)::", "").replace("(below main)", "start")
    while True:
        shorter = re.sub(r"<[^<>]*>", "", name)
        if shorter == name:
            break
        name = shorter
    return re.sub(r"\(.*", "", name).replace("frit::", "").strip()


def parse(text):
    """Functions of callgrind_annotate's list: {"function", "instructions", "share [%]"} in its order, PROGRAM TOTALS left out."""
    functions = []
    for line in text.splitlines():
        match = LINE.match(line)
        if match and ":" in match.group(3):
            functions.append({"function": short_name(match.group(3)), "instructions": int(match.group(1).replace(",", "")),
                              "share [%]": float(match.group(2))})
    return functions


def annotate(record, *options):
    done = subprocess.run(["callgrind_annotate", *options, str(record)], capture_output=True, text=True, check=True)
    return done.stdout


def profile(folder, case):
    """Runs frit on a case under callgrind; the lists go to results/profile/. Returns both tables."""
    record = folder / "callgrind.out"
    program.write_case(folder / "case.toml", case)
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={record}", str(program.PROGRAM), "run",
               str(folder / "case.toml"), "-o", str(folder / "out"), "--quiet", "--threads", "1"]
    subprocess.run(command, check=True, capture_output=True, text=True)
    kept = ledger.PATH.parent / "profile"
    kept.mkdir(parents=True, exist_ok=True)
    entry = {}
    for kind, option in (("exclusive", "--inclusive=no"), ("inclusive", "--inclusive=yes")):
        text = annotate(record, option)
        (kept / f"{kind}.txt").write_text(text, encoding="utf-8")
        entry[kind] = [row for row in parse(text) if row["function"].strip()]
    entry["inclusive"] = [row for row in entry["inclusive"] if "::" in row["function"] and not row["function"].startswith("std::")]
    return {kind: rows[:MOST_LISTED] for kind, rows in entry.items()}
