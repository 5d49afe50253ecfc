"""Runs a page of Markdown in a folder of its own: files are written, commands run, shown output must come out.

run_tutorial.py PAGE

toml and python   whose first line is "# NAME" become files
sh                each line is a command, which may end with "# exit code N"
text              each line must be one that the commands before it have printed, blanks aside; "..." at its end: more may follow

With FRIT_UPDATE=1 lines and pictures are renewed; what the text around them says is for whoever renews to check.
"""
import difflib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PICTURES = {"tutorial_packing.png": "figures/packing.png", "tutorial_curves.png": "figures/eta/curves.png",
            "tutorial_study.png": "figures/study.png"}
UPDATE = os.environ.get("FRIT_UPDATE") == "1"
LARGEST_PICTURE = 150_000  # bytes


def blocks_of(text):
    """(kind, lines) of each fenced block."""
    return [(kind, body.splitlines()) for kind, body in re.findall(r"^```(\w+)\n(.*?)^```$", text, re.M | re.S)]


def run(command, folder):
    """What the command prints; its exit code must be the one that is told."""
    code = int((re.search(r"# exit code (\d+)$", command) or [0, 0])[1])
    path = f"{pathlib.Path(os.environ['FRIT']).parent}:/usr/bin:/bin"
    done = subprocess.run(["/bin/sh", "-c", command], cwd=folder, env={**os.environ, "PATH": path}, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=170)
    if done.returncode != code:
        sys.exit(f"{command}\nended with {done.returncode}:\n{done.stdout}")
    return done.stdout


def squeezed(line):
    return " ".join(line.split())


def as_shown(line, printed):
    """The line, or with FRIT_UPDATE=1 the printed one that is most like it; ends the test where there is none."""
    lines = {squeezed(candidate): candidate for candidate in printed.splitlines()}
    begin = squeezed(line.removesuffix("..."))
    if begin in lines or line.endswith("...") and any(candidate.startswith(begin) for candidate in lines):
        return line
    near = difflib.get_close_matches(squeezed(line), lines, n=1) if UPDATE else []
    if not near:
        sys.exit(f"the page shows this line, the commands did not print it:\n{line}\nthey printed:\n{printed}")
    if not line.endswith("..."):
        return lines[near[0]]
    return ",".join(lines[near[0]].split(",")[:line.count(",") + 1]) + "..."


def follow(text, folder):
    """Goes through the page; how much was done, and the page with its output as it came."""
    counts = {"sh": 0, "text": 0, "file": 0}
    printed = ""
    for kind, lines in blocks_of(text):
        if kind == "sh":
            for command in lines:
                counts["sh"] += 1
                printed += run(command, folder) + "\n"
        elif kind == "text":
            for line in lines:
                counts["text"] += 1
                text = text.replace(f"\n{line}\n", f"\n{as_shown(line, printed)}\n", 1)
        elif lines[0].startswith("# "):
            counts["file"] += 1
            (folder / lines[0][2:]).write_text("\n".join(lines[1:]) + "\n")
        else:
            sys.exit(f"a block of {kind} without its file's name: {lines[0]}")
    return counts, text


def check_pictures(page, folder):
    for name, source in PICTURES.items():
        made, kept = folder / source, page.parent / "pictures" / name
        if UPDATE:
            shutil.copy(made, kept)
        for picture in (made, kept):
            content = picture.read_bytes()
            if not content.startswith(b"\x89PNG") or len(content) > LARGEST_PICTURE:
                sys.exit(f"{picture}: no PNG, or above {LARGEST_PICTURE} bytes ({len(content)})")
        if name not in page.read_text():
            sys.exit(f"{name} is not on the page")


def main(page):
    text = page.read_text()
    if len(blocks_of(text)) != len(re.findall(r"^```", text, re.M)) / 2:
        sys.exit("a block has no kind (sh, text, toml, python)")
    with tempfile.TemporaryDirectory(prefix="frit-tutorial-") as folder:
        counts, renewed = follow(text, pathlib.Path(folder))
        check_pictures(page, pathlib.Path(folder))
    if UPDATE:
        page.write_text(renewed)
    print(f"{counts['sh']} commands, {counts['file']} files, {counts['text']} lines of output as shown")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
