// What was computed and what came out, in words and five numbers.
import { el } from "./dom";
import { label, short, timeUnit } from "./numbers";
import { column, runColour, runs, shrinkage } from "./runs";
import type { Run } from "./types";

interface Figure {
  name: string;
  of: (run: Run) => number; // NaN: the run does not tell
  text: (value: number) => string;
}

const last = (run: Run, name: string): number => column(run, name)?.at(-1) ?? NaN;

function timeText(time: number): string {
  const unit = timeUnit(time);
  return `${short(time / unit.size, 3)} ${unit.name}`;
}

const three = (value: number): string => short(value, 3);
// By their weight: the first five that a run tells are shown.
const figures: Figure[] = [
  { name: "relative density", of: (run) => last(run, "relative_density"), text: short },
  { name: "time", of: (run) => last(run, "time"), text: timeText },
  { name: "coordination", of: (run) => last(run, "coordination"), text: three },
  { name: "neck ratio r/R", of: (run) => last(run, "neck_ratio_mean"), text: three },
  { name: "rearrangement, pair ratio", of: (run) => last(run, "rearrangement_pair_ratio"), text: three },
  {
    name: "linear shrinkage",
    of: (run) => 100 * (shrinkage(run)?.at(-1) ?? NaN),
    text: (value) => `${three(value)} %`,
  },
  { name: "temperature", of: (run) => last(run, "temperature"), text: (value) => `${three(value)} K` },
  { name: "contacts", of: (run) => last(run, "contacts"), text: short },
];

function figureTable(): HTMLElement {
  const single = runs.length === 1;
  const blocks = runs.map((run, n) => {
    const told = figures.filter(({ of }) => Number.isFinite(of(run))).slice(0, 5);
    const cells = told.map(({ name, of, text }) =>
      el("div", { class: "figure" }, el("b", {}, text(of(run))), el("span", {}, name)),
    );
    const head = single
      ? null
      : el("h3", {}, el("i", { class: "swatch", style: `background:${runColour(n)}` }), run.name);
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
    [
      "time of the computer",
      `${short(s.cpu_s?.total, 3)} s of processor, ${short(s.wall_s?.total, 3)} s of wall clock`,
    ],
    ["memory", `${short(s.peak_memory_bytes / 1e6, 3)} MB at most`],
    [
      "accuracy",
      `${s.accuracy_asked === null ? "fixed steps" : `asked ${short(s.accuracy_asked)}`}, estimated ${short(s.accuracy_estimated, 2)}`,
    ],
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
    ...(run.notes.length > 0
      ? [
          el(
            "p",
            { class: "left-out" },
            `${name}Left out of this page, but in the folder of the results: ${run.notes.join("; ")}.`,
          ),
        ]
      : []),
  ];
}

function details(run: Run): HTMLElement {
  const final = run.series.columns.map((name, n): [string, string] => [
    label(name),
    short(run.series.values[n]!.at(-1), 6),
  ]);
  return el(
    "details",
    {},
    el("summary", {}, runs.length > 1 ? `${run.name}: material, cost, last row` : "Material, cost, last row"),
    el(
      "div",
      { class: "columns" },
      el(
        "div",
        {},
        el("h3", {}, run.material.name),
        rows(run.material.properties),
        el("p", { class: "source" }, `Source: ${run.material.source}.`),
      ),
      el("div", {}, el("h3", {}, "Cost and accuracy"), rows(cost(run))),
      el("div", { class: "long" }, el("h3", {}, "Last row of series.csv"), rows(final)),
    ),
  );
}

export function summarySection(): HTMLElement {
  const words = runs.map((run) =>
    el("p", {}, runs.length > 1 ? el("b", {}, `${run.name}: `) : null, run.words.join(" ")),
  );
  return el(
    "section",
    { id: "summary" },
    figureTable(),
    el("div", { class: "words" }, ...words),
    ...runs.flatMap(notices),
    ...runs.map(details),
  );
}
