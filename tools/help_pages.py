#!/usr/bin/env python3
"""Writes the man pages frit(1) and frit-case(5) and the completion for bash from what the program says of itself.

help_pages.py PROGRAM FOLDER     reads `--help` of the program and of each command, and `frit describe`
"""
import pathlib
import re
import subprocess
import sys

CASE_TEXT = """A quantity is a string with a unit ("5 um", "10 K/min") or a bare number in SI units. Unknown keys, wrong types
and units, and values out of range are faults; all are told at once. Relative paths are relative to the case file's folder."""


def ask(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=True).stdout


def parse_help(text):
    """(first line, usage, {heading: [(term, text)]}) of a page of CLI11; lines that are indented further go on."""
    lines = text.splitlines()
    usage = next(line.removeprefix("Usage: ") for line in lines if line.startswith("Usage: "))
    sections, entries = {}, None
    for line in lines[1:]:
        if re.fullmatch(r"\S.*:", line):
            entries = sections.setdefault(line[:-1], [])
        elif entries is not None and re.match(r" {2}\S", line):
            term, _, meaning = line.strip().partition("  ")
            entries.append([term, meaning.strip()])
        elif entries and line.strip():
            entries[-1][1] = f"{entries[-1][1]} {line.strip()}".strip()
    return lines[0], usage, sections


class Program:
    """The program's own description."""

    def __init__(self, path):
        self.version = ask(path, "--version").split()[-1]
        self.summary, self.usage, sections = parse_help(ask(path, "--help"))
        self.options = sections["Options"]
        self.commands = {name: (text, parse_help(ask(path, name, "--help"))) for name, text in sections["Subcommands"]}
        self.keys = [line.split()[0] for line in ask(path, "describe").splitlines()[2:] if line.strip()]
        tops = dict.fromkeys(key.split(".")[0] for key in self.keys)
        self.key_texts = [[entry.splitlines() for entry in ask(path, "describe", top).split("\n\n")] for top in tops]


def roff(text):
    """Text that man shows as it is."""
    escaped = text.replace("\\", "\\e").replace("-", "\\-")
    return re.sub(r"^([.'])", r"\\&\1", escaped, flags=re.M)


def entry(term, text):
    return f".TP\n.B {roff(term)}\n{roff(text)}\n"


def command_page(program):
    page = f'.TH FRIT 1 "" "frit {program.version}" "User Commands"\n'
    page += f".SH NAME\nfrit \\- {roff(program.summary.removeprefix('frit '))}\n.SH SYNOPSIS\n"
    page += ".br\n".join(f".B {roff(parsed[1])}\n" for _, parsed in program.commands.values())
    page += ".SH COMMANDS\n"
    for name, (text, (_, _, sections)) in program.commands.items():
        page += f".SS {name}\n{roff(text)}\n"
        for term, meaning in sections.get("Positionals", []) + sections.get("Options", []):
            if not term.startswith("-h,"):
                page += entry(term, meaning)
    page += ".SH OPTIONS\n" + "".join(entry(*option) for option in program.options)
    codes = {"0": "done", "1": "the machine failed: disk, memory, a file", "2": "wrong input",
             "3": "the run could not be computed", "4": "stopped by --max-wall, after a checkpoint",
             "5": "a check of the program itself failed",
             "130, 143": "stopped by a signal, after its step"}
    page += ".SH EXIT STATUS\n" + "".join(entry(*code) for code in codes.items())
    return page + ".SH SEE ALSO\n.BR frit\\-case (5)\n"


def case_page(program):
    page = f'.TH FRIT\\-CASE 5 "" "frit {program.version}" "File Formats"\n'
    page += ".SH NAME\nfrit\\-case \\- keys of a case file of frit (TOML)\n"
    page += ".SH DESCRIPTION\n" + roff(CASE_TEXT) + "\n"
    for keys in program.key_texts:
        page += f".SH {roff(keys[0][0].split('.')[0].upper())}\n"
        for key in keys:
            page += f".TP\n.B {roff(key[0])}\n" + "\n.br\n".join(roff(line.strip()) for line in key[1:]) + "\n"
    return page + ".SH SEE ALSO\n.BR frit (1)\n"


def option_names(parsed):
    terms = (term.split(" ")[0] for term, _ in parsed[2].get("Options", []))
    return [name.split(":")[0] for term in terms for name in term.split(",") if name.startswith("--")]


def completion(program):
    cases = ""
    for name, (_, parsed) in program.commands.items():
        cases += f'    {name}) options="{" ".join(option_names(parsed))}" ;;\n'
    return f"""# Completion of frit {program.version} for bash; written by tools/help_pages.py.
_frit() {{
  local word=$2 before=$3 command=${{COMP_WORDS[1]}} options=""
  local keys="{' '.join(program.keys)}"
  if [[ $COMP_CWORD -eq 1 ]]; then
    COMPREPLY=($(compgen -W "{' '.join(program.commands)} --help --version" -- "$word"))
    return
  fi
  if [[ $before == --set ]]; then
    compopt -o nospace 2>/dev/null
    COMPREPLY=($(compgen -S = -W "$keys" -- "$word"))
    return
  fi
  if [[ $command == describe ]]; then
    COMPREPLY=($(compgen -W "$keys" -- "$word"))
    return
  fi
  case $command in
{cases}  esac
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
  else
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}}
complete -o filenames -F _frit frit
"""


def main(path, folder):
    program = Program(path)
    pages = {"frit.1": command_page, "frit-case.5": case_page, "frit.bash": completion}
    for name, write in pages.items():
        (pathlib.Path(folder) / name).write_text(write(program))


if __name__ == "__main__":
    main(*sys.argv[1:])
