// What was computed and what came out, in words and five numbers.
import { el } from "./dom";
import { label, short, timeUnit } from "./numbers";
import { column, runColour, runs } from "./runs";
import type { Run } from "./types";

interface Figure {
  name: string;
  value: (run: Run) => string;
}

const last = (run: Run, name: string): number => column(run, name)?.at(-1) ?? NaN;

const figures: Figure[] = [
  { name: "relative density", value: (run) => short(last(run, "relative_density")) },
  {
    name: "time",
    value: (run) => {
      const time = last(run, "time");
      const unit = timeUnit(time);
      return `${short(time / unit.size, 3)} ${unit.name}`;
    },
  },
  { name: "coordination", value: (run) => short(last(run, "coordination"), 3) },
  { name: "neck ratio r/R", value: (run) => short(last(run, "neck_ratio_mean"), 3) },
  { name: "rearrangement, pair ratio", value: (run) => short(last(run, "rearrangement_pair_ratio"), 3) },
];

function figureTable(): HTMLElement {
  const single = runs.length === 1;
  const blocks = runs.map((run, n) => {
    const cells = figures.map(({ name, value }) => el("div", { class: "figure" }, el("b", {}, value(run)), el("span", {}, name)));
    const head = single ? null : el("h3", {}, el("i", { class: "swatch", style: `background:${runColour(n)}` }), run.name);
    return el("div", { class: "figures" }, head, ...cells);
  });
  return el("div", {}, ...blocks);
}

function rows(pairs: [string, string][]): HTMLTableElement {
  const table = el("table");
  for (const [name, value] of pairs) table.append(el("tr", {}, el("th", {}, name), el("td", {}, value)));
  return table;
}

function cost(run: Run): [string, string][] {
  const s = run.summary;
  if (!s.steps) return [["cost", "not known: summary.json is missing"]];
  return [
    ["steps", `${s.steps}, ${s.rejected_steps} repeated shorter`],
    ["iterations", `${s.newton_iterations} Newton, ${s.solver_iterations} linear`],
    ["time of the computer", `${short(s.cpu_s?.total, 3)} s of processor, ${short(s.wall_s?.total, 3)} s of wall clock`],
    ["memory", `${short(s.peak_memory_bytes / 1e6, 3)} MB at most`],
    ["accuracy", `${s.accuracy_asked === null ? "fixed steps" : `asked ${short(s.accuracy_asked)}`}, estimated ${short(s.accuracy_estimated, 2)}`],
    ["largest force residual", short(s.largest_residual, 2)],
    ["machine", `${s.machine?.cpu}, ${s.threads} threads; frit ${s.version}`],
  ];
}

function notices(run: Run): HTMLElement[] {
  const name = runs.length > 1 ? `${run.name}: ` : "";
  const ended = run.summary.exit?.code ? [`The run ended early: ${run.summary.exit.reason}`] : [];
  const warnings: string[] = [...ended, ...(run.summary.warnings ?? [])];
  return [
    ...warnings.map((text) => el("p", { class: "notice" }, `${name}${text}`)),
    ...(run.notes.length > 0 ? [el("p", { class: "left-out" }, `${name}Left out of this page, but in the folder of the results: ${run.notes.join("; ")}.`)] : []),
  ];
}

function details(run: Run): HTMLElement {
  const final = run.series.columns.map((name, n): [string, string] => [label(name), short(run.series.values[n]!.at(-1), 6)]);
  return el(
    "details",
    {},
    el("summary", {}, runs.length > 1 ? `${run.name}: material, cost, last row` : "Material, cost, last row"),
    el(
      "div",
      { class: "columns" },
      el("div", {}, el("h3", {}, run.material.name), rows(run.material.properties), el("p", { class: "source" }, `Source: ${run.material.source}.`)),
      el("div", {}, el("h3", {}, "Cost and accuracy"), rows(cost(run))),
      el("div", { class: "long" }, el("h3", {}, "Last row of series.csv"), rows(final)),
    ),
  );
}

export function summarySection(): HTMLElement {
  const words = runs.map((run) => el("p", {}, runs.length > 1 ? el("b", {}, `${run.name}: `) : null, run.words.join(" ")));
  return el("section", { id: "summary" }, figureTable(), el("div", { class: "words" }, ...words), ...runs.flatMap(notices), ...runs.map(details));
}
