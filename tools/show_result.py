#!/usr/bin/env python3
"""Prints where a result is and its main numbers, from summary.json and series.csv."""
import csv
import json
import pathlib
import sys

COLUMNS = ["time [s]", "relative_density", "coordination", "neck_ratio_mean", "rearrangement_pair_ratio"]
ROWS_SHOWN = 8


def short(text):
    """A cell of series.csv in few digits; empty cells (the figure does not exist) as a dash."""
    return f"{float(text):.4g}" if text else "-"


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: show_result.py DIR")
    folder = pathlib.Path(sys.argv[1])
    with open(folder / "series.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    every = max(1, (len(rows) - 1) // ROWS_SHOWN)
    shown = rows[:-1:every] + rows[-1:]
    print("\n" + "  ".join(f"{name:>24}" for name in COLUMNS))
    for row in shown:
        print("  ".join(f"{short(row.get(name, '')):>24}" for name in COLUMNS))
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    print(f"\n{summary['steps']} steps, {summary['rejected_steps']} rejected; {summary['newton_iterations']} Newton and "
          f"{summary['solver_iterations']} solver iterations")
    if (folder / "report.html").is_file():
        print(f"to look at: {folder}/report.html, in any browser")
    print(f"results: {folder}/series.csv (curves), {folder}/summary.json, {folder}/snapshots.pvd (ParaView, OVITO)")


if __name__ == "__main__":
    main()
