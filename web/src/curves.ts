// The sections of curves: against time, against density, and any column against any.
import { type Axes, Chart, type ChartData, type Curve } from "./chart";
import { check, choice, el } from "./dom";
import { label, timeUnit } from "./numbers";
import { column, densificationRate, dimensionlessTime, runColour, runs, shrinkage } from "./runs";
import type { Run } from "./types";

type Get = (run: Run) => Float64Array | null;

interface Quantity {
  title: string;
  axis: string;
  get: Get;
  low?: Get;
  high?: Get;
  logarithmic?: boolean; // up, unless the user says otherwise
}

const of =
  (name: string): Get =>
  (run) =>
    column(run, name);
const scaled =
  (get: Get, factor: number): Get =>
  (run) =>
    get(run)?.map((value) => value * factor) ?? null;

const overTime: Quantity[] = [
  { title: "Relative density", axis: "relative density", get: of("relative_density") },
  { title: "Linear shrinkage", axis: "shrinkage, −ln(L/L₀) [%]", get: scaled(shrinkage, 100) },
  { title: "Densification rate", axis: "(dD/dt)/D [1/s]", get: densificationRate, logarithmic: true },
  { title: "Temperature", axis: "temperature [K]", get: of("temperature") },
];

const overDensity: Quantity[] = [
  { title: "Coordination", axis: "contacts a particle", get: of("coordination") },
  {
    title: "Neck ratio",
    axis: "x = r/R, mean",
    get: of("neck_ratio_mean"),
    low: of("neck_ratio_q10"),
    high: of("neck_ratio_q90"),
  },
  { title: "Rearrangement", axis: "pair ratio", get: of("rearrangement_pair_ratio") },
  {
    title: "Non-affine motion",
    axis: "D²min/R², mean",
    get: of("rearrangement_d2min_mean"),
    low: of("rearrangement_d2min_q10"),
    high: of("rearrangement_d2min_q90"),
  },
];

const nameOf = (run: Run): string => run.title || run.name;

function curves(x: Get, quantity: Quantity): Curve[] {
  return runs.flatMap((run, n) => {
    const xs = x(run);
    const ys = quantity.get(run);
    if (!xs || !ys) return [];
    const curve: Curve = { run: n, name: runs.length > 1 ? run.name : nameOf(run), colour: runColour(n), x: xs, y: ys };
    const [low, high] = [quantity.low?.(run), quantity.high?.(run)];
    return [low && high ? { ...curve, low, high } : curve];
  });
}

const hasNumbers = (curve: Curve): boolean => curve.y.some(Number.isFinite);

/** A grid of charts that share how the axes are shown. */
class Group {
  readonly grid = el("div", { class: "grid" });
  private readonly charts: { chart: Chart; quantity: Quantity }[] = [];

  constructor(
    quantities: Quantity[],
    private x: { axis: string; get: Get },
    private axes: Axes,
  ) {
    for (const quantity of quantities) {
      const data = this.dataOf(quantity);
      if (!data.curves.some(hasNumbers)) continue;
      const chart = new Chart(data, this.axesOf(quantity));
      this.charts.push({ chart, quantity });
      this.grid.append(chart.element);
    }
  }

  show(x: { axis: string; get: Get }, axes: Axes): void {
    this.x = x;
    this.axes = axes;
    for (const { chart, quantity } of this.charts) chart.show(this.dataOf(quantity), this.axesOf(quantity));
  }

  private axesOf(quantity: Quantity): Axes {
    return { ...this.axes, logY: this.axes.logY || quantity.logarithmic === true };
  }

  private dataOf(quantity: Quantity): ChartData {
    const note = quantity.low ? "with 10 and 90 % quantiles" : "";
    return { title: quantity.title, x: this.x.axis, y: quantity.axis, curves: curves(this.x.get, quantity), note };
  }
}

export function timeSection(): HTMLElement {
  const longest = Math.max(...runs.map((run) => Math.max(...column(run, "time")!)));
  const unit = timeUnit(longest);
  const time = { axis: `time [${unit.name}]`, get: scaled(of("time"), 1 / unit.size) };
  const tau = { axis: "dimensionless time τ = γ∫Δb dt/R⁴", get: dimensionlessTime };
  let mode = "linear";
  let logY = false;
  const group = new Group(overTime, time, { logX: false, logY });
  const show = (): void => group.show(mode.startsWith("tau") ? tau : time, { logX: mode.endsWith("log"), logY });
  const modes: [string, string][] = [
    ["linear", `time [${unit.name}]`],
    ["log", "time, logarithmic"],
  ];
  if (runs.some((run) => dimensionlessTime(run)))
    modes.push(["tau", "dimensionless"], ["tau log", "dimensionless, logarithmic"]);
  const bar = el(
    "div",
    { class: "bar" },
    choice("against", modes, mode, (value) => {
      mode = value;
      show();
    }),
    check("vertical axes logarithmic", logY, (on) => {
      logY = on;
      show();
    }),
  );
  return el("section", { id: "time" }, el("h2", {}, "Against time"), bar, group.grid);
}

/** Necks and rearrangement: against density, or against time where no density is known. */
export function densitySection(): HTMLElement {
  const known = runs.some((run) => column(run, "relative_density")?.some(Number.isFinite));
  const density = known
    ? { axis: "relative density", get: of("relative_density") }
    : { axis: "time [s]", get: of("time") };
  const group = new Group(overDensity, density, { logX: false, logY: false });
  const bar = el(
    "div",
    { class: "bar" },
    check("vertical axes logarithmic", false, (logY) => group.show(density, { logX: false, logY })),
  );
  return el(
    "section",
    { id: "density" },
    el("h2", {}, known ? "Against density" : "Necks against time"),
    bar,
    group.grid,
  );
}

/** One chart of any column against any other. */
export function anySection(): HTMLElement {
  const names = [...new Set(runs.flatMap((run) => run.series.columns))];
  const options = names.map((name): [string, string] => [name, label(name)]);
  let [x, y] = ["relative_density", "contacts"];
  const axes = { logX: false, logY: false };
  const dataOf = (): ChartData => {
    const quantity = { title: `${label(y)} against ${label(x)}`, axis: label(y), get: of(y) };
    return { title: quantity.title, x: label(x), y: quantity.axis, curves: curves(of(x), quantity) };
  };
  const chart = new Chart(dataOf(), axes);
  const show = (): void => chart.show(dataOf(), axes);
  const bar = el(
    "div",
    { class: "bar" },
    choice("show", options, y, (value) => {
      y = value;
      show();
    }),
    choice("against", options, x, (value) => {
      x = value;
      show();
    }),
    check("logarithmic across", false, (on) => {
      axes.logX = on;
      show();
    }),
    check("logarithmic up", false, (on) => {
      axes.logY = on;
      show();
    }),
  );
  return el("section", { id: "any" }, el("h2", {}, "Any column"), bar, chart.element);
}
