"""The page of the study: tables in Markdown, plots in SVG."""
import math
import statistics

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "frit"  # the same file for the same figures
import matplotlib.pyplot as plt  # noqa: E402
from measures import DENSITY, DEVIATION, PAIR_RATIO, TIME, extrapolated, spoiled_below  # noqa: E402
from validation import law  # noqa: E402


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def number(value, form):
    return "none" if math.isnan(value) else format(value, form)


def per_cent(value, reference):
    change = 100 * (value / reference - 1)
    return "none" if math.isnan(change) else f"{change:+.1f} %"


def methods_of(study):
    """(label, name) of each method, the reference first."""
    verlet = [(f"Verlet {study.factors[ratio]:.1e} (x_c {ratio * study.youngest:.3f})", f"verlet {ratio:g}")
              for ratio in study.ratios]
    return [("contact dynamics", "contact-dynamics"), ("accuracy 0.001", "contact-dynamics 0.001"),
            ("accuracy 0.01 (default)", "contact-dynamics 0.01"), ("quasi-static", "quasi-static"),
            ("mean field", "mean-field")] + verlet


def style_of(name, study):
    styles = {"contact-dynamics": dict(color="black", lw=2.5), "quasi-static": dict(color="tab:green", ls="--"),
              "contact-dynamics 0.001": dict(color="tab:blue", ls="-."), "contact-dynamics 0.01": dict(color="tab:blue"),
              "mean-field": dict(color="tab:gray", ls=":")}
    if name in styles:
        return styles[name]
    place = study.ratios.index(float(name.split()[1])) / max(1, len(study.ratios) - 1)
    return dict(color=plt.cm.plasma(0.85 * place), lw=1.2)


def panels(study, title, draw):
    """A figure with a panel for each eta; draw(axes, run, style) draws one method."""
    count = len(study.etas)
    figure, all_axes = plt.subplots(1, count, figsize=(3.6 * count, 3.8), sharey=True, squeeze=False)
    for axes, eta in zip(all_axes[0], study.etas):
        for label, name in methods_of(study):
            if study.run(name, eta):
                draw(axes, study.run(name, eta), dict(label=label, **style_of(name, study)))
        axes.set_title(f"eta = {eta:g}")
    figure.suptitle(title)
    handles, labels = all_axes[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=4, fontsize=8)
    figure.tight_layout(rect=(0, 0.14, 1, 1))
    return figure, all_axes[0]


def save(figure, path):
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def plot_densities(study, folder):
    def draw(axes, run, style):
        axes.semilogx(run.columns[TIME][1:] / law.time_scale(), run.columns[DENSITY][1:], **style)
        axes.set_xlabel("time gamma Delta_b / R^4")
    figure, axes = panels(study, "Density against dimensionless time", draw)
    axes[0].set_ylabel("relative density")
    save(figure, folder / "density.svg")


def plot_rearrangement(study, folder):
    def draw(axes, run, style):
        axes.plot(run.columns[DENSITY][1:], run.columns[PAIR_RATIO][1:], **style)
        axes.set_xlabel("relative density")
    figure, axes = panels(study, "Rearrangement against density", draw)
    axes[0].set_ylabel("pair ratio")
    axes[0].set_ylim(0, 1.0)
    save(figure, folder / "rearrangement.svg")


def difference_table(study, name, density):
    """Differences from contact dynamics, a row for each method, a column for each eta."""
    reference = {eta: study.run("contact-dynamics", eta).at_density(name, density) for eta in study.etas}
    rows = [["contact dynamics"] + [f"{reference[eta]:.4g}" for eta in study.etas]]
    for label, method in methods_of(study)[1:]:
        runs = {eta: study.run(method, eta) for eta in study.etas}
        rows.append([label] + [per_cent(run.at_density(name, density), reference[eta]) if run else "none"
                               for eta, run in runs.items()])
    return table(["method"] + [f"eta {eta:g}" for eta in study.etas], rows)


def limit_table(study, name, density):
    """Verlet's values extrapolated to no mass, beside contact dynamics; the gap at the highest factor."""
    rows = []
    for eta in study.etas:
        reference = study.run("contact-dynamics", eta).at_density(name, density)
        values = [study.verlet(ratio, eta).at_density(name, density) for ratio in study.ratios]
        limit, power = extrapolated(study.ratios, values) if len(values) > 2 else (math.nan, math.nan)
        rows.append([f"{eta:g}", f"{reference:.4g}", f"{values[0]:.4g}", per_cent(values[0], reference),
                     number(limit, ".4g"), per_cent(limit, reference), number(power, ".1f"),
                     f"{values[-1]:.4g}", per_cent(values[-1], reference)])
    return table(["eta", "contact dynamics", "lowest factor", "off by", "extrapolated", "off by", "power of x_c",
                  "highest factor", "off by"], rows)


def spoiled_table(study):
    rows = []
    for ratio in study.ratios:
        seen = [spoiled_below(study.verlet(ratio, eta), study.run("contact-dynamics", eta), study.youngest)
                for eta in study.etas]
        rows.append([f"{study.factors[ratio]:.2e}", f"{ratio * study.youngest:.3f}"]
                    + [number(value, ".3f") for value in seen])
    return table(["density factor", "x_c"] + [f"seen, eta {eta:g}" for eta in study.etas], rows)


def cell_table(study):
    eta, ratio = study.plan["cell_eta"], study.plan["cell_ratio"]
    runs = [(1.0, study.verlet(ratio, eta))] + [(inertia, study.run(f"cell {inertia:g}", eta))
                                               for inertia in study.plan["cell_inertias"]]
    reference, rows = study.run("contact-dynamics", eta), []
    for inertia, run in sorted(runs, key=lambda pair: pair[0]):
        rows.append([f"{inertia:g}"] + [per_cent(run.at_density(name, place), reference.at_density(name, place))
                                        for name in (TIME, PAIR_RATIO, DEVIATION) for place in (study.middle, study.end)])
    header = [f"{what} at {place:.3f}" for what in ("time", "pair ratio", "deviation") for place in (study.middle, study.end)]
    return table(["method.cell_inertia"] + header, rows)


def cost_table(study):
    rows = []
    for label, name in methods_of(study):
        runs = [run for run in (study.run(name, eta) for eta in study.etas) if run]
        cpu, steps = statistics.median(run.cpu for run in runs), statistics.median(run.steps for run in runs)
        rows.append([label, f"{steps:,.0f}", f"{cpu:.2f}", f"{1e6 * cpu / steps / study.particles:.3g}"])
    return table(["method", "steps", "processor time [s]", "us per particle-step"], rows)


def write(study, folder):
    """results.md and its plots."""
    folder.mkdir(parents=True, exist_ok=True)
    plot_densities(study, folder)
    plot_rearrangement(study, folder)
    middle, end = study.middle, study.end
    text = [
        "# Multiplied masses, density and rearrangement", "",
        "Written by `cases/rearrangement/study.py`; how the packing is made stands there. Copper, R = 5 um, 1050 degC, "
        f"{study.particles} particles, periodic cell without stress, loose regions; from density {study.start:.3f} "
        f"to {study.end:.3f}. Youngest necks: x = {study.youngest:g}. Factors are chosen by x_c, the neck ratio below which "
        "inertia governs (docs/theory.md, section 7). Implicit methods: accuracy 1e-4 where nothing else is said, 0.01 with eta = 0. Differences are from contact dynamics at equal density.", "",
        "![Density](density.svg)", "", "![Rearrangement](rearrangement.svg)", "",
        f"## Time to density {end:.3f} [s]", "", difference_table(study, TIME, end), "",
        f"## Pair ratio at density {middle:.3f}", "", difference_table(study, PAIR_RATIO, middle), "",
        f"## Pair ratio at density {end:.3f}", "", difference_table(study, PAIR_RATIO, end), "",
        f"## Mean deviation at density {end:.3f} [mean radii]", "", difference_table(study, DEVIATION, end), "",
        "## Verlet in the limit of small factors", "", f"Pair ratio at density {end:.3f}:", "",
        limit_table(study, PAIR_RATIO, end), "", f"Mean deviation at density {end:.3f}:", "",
        limit_table(study, DEVIATION, end), "",
        "## Neck ratio below which inertia spoils", "",
        "*seen*: mean neck ratio of contact dynamics at the time when the mean neck of Verlet has grown by 95 % as much; from then on "
        "it stays within that. The youngest neck ratio: never behind.", "", spoiled_table(study), "",
        "## Inertia of the cell", "",
        f"Verlet at x_c {study.plan['cell_ratio'] * study.youngest:.3f}, eta {study.plan['cell_eta']:g}: differences from contact dynamics at "
        "two densities.", "", cell_table(study), "",
        "## Cost", "", "Median over eta, of the steps alone, one thread.", "", cost_table(study), ""]
    (folder / "results.md").write_text("\n".join(text), encoding="utf-8")
