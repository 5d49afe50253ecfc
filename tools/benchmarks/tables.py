"""Tables of what was measured, for the terminal and for docs/performance.md."""
from . import bandwidth
from .curves import DENSITIES, MEASURES, PAIR_RATIO

PENDING = "(run pending)"
CASE_COLUMNS = {  # figure -> (heading, format)
    "wall [s]": ("wall [s]", ",.1f"), "cpu [s]": ("cpu [s]", ",.1f"), "steps": ("steps", ",.0f"), "rejected": ("rejected", ",.0f"),
    "Newton": ("Newton", ",.0f"), "linear": ("linear", ",.0f"), "wall per step [s]": ("wall per step [s]", ",.3f"),
    "memory [MB]": ("memory [MB]", ",.0f"), "bytes per particle": ("bytes per particle", ",.0f"),
    "cpu per particle-step [us]": ("cpu per particle-step [us]", ",.1f"),
}


def table(header, rows):
    """Markdown; numbers to the right of their columns, the first column to the left."""
    lines = ["| " + " | ".join(header) + " |", "|---|" + "---:|" * (len(header) - 1)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def padded(name, cells, width):
    """A row with as many cells as the header; none given: the run is still to come."""
    cells = cells or [PENDING]
    return [name, *cells, *[""] * (width - 1 - len(cells))]


def names_of(ledger, cases):
    """Named cases in their order, then what else was measured (packing files)."""
    names = [case.name for case in cases]
    return names + sorted(set(ledger["cases"]) - set(names))


def case_cells(entry):
    if "failed" in entry:
        return [f"failed: {entry['failed']}"]
    figures = [format(entry["median"][name], style) for name, (_, style) in CASE_COLUMNS.items()]
    return [f"{entry['accuracy']:g}", f"{entry['particles']:,}", f"{len(entry['runs'])}", f"{entry['threads']}", *figures]


def case_table(ledger, names):
    header = ["case", "accuracy", "particles", "runs", "threads", *(heading for heading, _ in CASE_COLUMNS.values())]
    entries = ((name, ledger["cases"].get(name)) for name in names)
    return table(header, [padded(name, entry and case_cells(entry), len(header)) for name, entry in entries])


def signed(differences, density, figure):
    figures = differences.get(f"{density:.2f}")
    return f"{figures[figure]:+.2f}" if figures else "not in the run"


def accuracy_table(ledger, names):
    """Differences [%] from the run at accuracy 0.001, of the cases that have one."""
    header = ["case", *(f"time to {density:.2f}" for density in DENSITIES), *(f"pair ratio at {density:.2f}" for density in DENSITIES)]
    rows = []
    for name in names:
        reference = ledger["cases"].get(name, {}).get("reference")
        if reference:
            compared = reference["difference [%]"]
            rows.append([name, *(signed(compared, density, figure) for figure in ("time [s]", PAIR_RATIO) for density in DENSITIES)])
    return table(header, rows or [padded("any case with --reference", [], len(header))])


def independence_table(ledger, names):
    """Differences [%] that other masses and a tighter tolerance make, the largest over the densities."""
    header = ["case", "changed", "time", *(name.replace("rearrangement_", "").replace("_", " ") for name in MEASURES)]
    rows = []
    for name in names:
        for changed, compared in ledger["cases"].get(name, {}).get("independence [%]", {}).items():
            largest = (max((figures[figure] for figures in compared.values()), key=abs, default=None)
                       for figure in ("time [s]", *MEASURES))
            rows.append([name, changed, *("did not end" if value is None else f"{value:+.2f}" for value in largest)])
    return table(header, rows or [padded("any case with --independence", [], len(header))])


def bandwidth_table(ledger):
    header = ["arrays together [MiB]", "threads", "triad [GB/s]"]
    rows = [[f"{row['MiB']:g}", f"{row['threads']}", f"{row['GB/s']:.1f}"] for row in ledger.get("bandwidth", {}).get("triad", [])]
    return table(header, rows or [padded("", [], len(header))])


def roofline_table(ledger, names):
    header = ["case", "in use [MB]", "moved per iteration [MB]", "triad [GB/s]", "iterations", "time at bandwidth [s]",
              "measured, steps [s]", "share"]
    triad, rows = ledger.get("bandwidth", {}).get("triad"), []
    for name in names:
        entry = ledger["cases"].get(name)
        if triad and entry and "median" in entry:
            told = bandwidth.roofline(entry, triad)
            rows.append([name, f"{told['resident [MB]']:,.1f}", f"{told['moved per iteration [MB]']:,.2f}",
                         f"{told['bandwidth [GB/s]']:.1f}", f"{told['iterations']:,.0f}", f"{told['time at bandwidth [s]']:,.2f}",
                         f"{told['measured step time [s]']:,.2f}", f"{told['share']:.0%}"])
    return table(header, rows or [padded("", [], len(header))])


def peers_table(ledger):
    header = ["density factor", "steps of the peer", "time of the peer [s]", "cpu of frit [s]", "ratio"]
    entry, rows = ledger.get("peers"), []
    for name, told in (entry["factors"].items() if entry else ()):
        rows.append([f"{told['density factor']:.3g} ({name})", f"{told['peer steps']:.3g}", f"{told['peer time [s]']:.3g}",
                     f"{entry['frit cpu [s]']:.3g}", f"{told['ratio']:.3g}"])
    said = "" if not entry else (f"{entry['peer']}: {entry['particles']:,} spheres, {entry['peer cpu per particle-step [us]']:.3g} us per "
                                 f"particle and step; frit: accuracy {entry['accuracy']:g}, {entry['frit steps']} steps to "
                                 f"{entry['sintering time [s]']:.0f} s (density {entry['to density']:g}), "
                                 f"{entry['frit cpu per particle-step [us]']:.3g} us per particle and step; one core each.\n\n")
    return said + table(header, rows or [padded("", [], len(header))])


def profile_table(ledger, kind):
    rows = ledger.get("profile", {}).get(kind, [])
    told = [[f"`{row['function'][:100]}`", f"{row['instructions'] / 1e6:,.0f}", f"{row['share [%]']:.1f}"] for row in rows]
    header = ["function", "million instructions", "%"]
    return table(header, told or [padded("", [], len(header))])


def all_tables(ledger, cases):
    """Marker in docs/performance.md -> table."""
    names = names_of(ledger, cases)
    return {"cases": case_table(ledger, names), "accuracy": accuracy_table(ledger, names), "independence": independence_table(ledger, names), "bandwidth": bandwidth_table(ledger),
            "roofline": roofline_table(ledger, names), "peers": peers_table(ledger),
            "profile-exclusive": profile_table(ledger, "exclusive"), "profile-inclusive": profile_table(ledger, "inclusive")}
