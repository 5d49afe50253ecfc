// Puts the page together.
import "./main.css";
import { anySection, densitySection, timeSection } from "./curves";
import { cursor } from "./cursor";
import { button, choice, el } from "./dom";
import { distributionSection } from "./histograms";
import { short, timeUnit } from "./numbers";
import { PackingSection } from "./packing";
import { column, data, runs } from "./runs";
import { summarySection } from "./summary";
import { visibleRows } from "./visible";

const title =
  runs.length === 1
    ? runs[0]!.title || runs[0]!.name
    : `${runs.length} runs: ${runs.map((run) => run.name).join(", ")}`;

/** The slider of time that all parts follow. */
function timeBar(): HTMLElement {
  const slider = el("input", {
    type: "range",
    min: "0",
    max: String(cursor.rows - 1),
    step: "1",
    "aria-label": "time",
  });
  const text = el("output");
  const play = button("▶", "play", () => toggle());
  let timer = 0;
  const toggle = (): void => {
    if (timer) clearInterval(timer);
    timer = timer ? 0 : window.setInterval(() => cursor.set((cursor.rowOf(0) + 1) % cursor.rows), 250);
    play.textContent = timer ? "❚❚" : "▶";
  };
  const show = (): void => {
    const row = cursor.rowOf(0);
    const time = column(runs[0]!, "time")!;
    const unit = timeUnit(time.at(-1)!);
    slider.value = String(row);
    text.textContent = `${short(time[row]! / unit.size)} ${unit.name}   D = ${short(column(runs[0]!, "relative_density")?.[row])}`;
  };
  slider.addEventListener("input", () => cursor.set(Number(slider.value)));
  cursor.listen(show);
  show();
  const compare = choice(
    "at equal",
    [
      ["density", "density"],
      ["time", "time"],
    ],
    "density",
    (what) => cursor.compareAt(what as "time" | "density"),
  );
  return el("div", { id: "bar" }, play, slider, text, runs.length > 1 ? compare : null);
}

function schemeButton(redraw: () => void): HTMLElement {
  const root = document.documentElement;
  const isDark = (): boolean =>
    (root.dataset.scheme ?? (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light")) === "dark";
  return button("light / dark", "change between a light and a dark page", () => {
    root.dataset.scheme = isDark() ? "light" : "dark";
    redraw();
  });
}

function build(): void {
  const packing = runs.some((run) => run.packing) ? new PackingSection() : null;
  const redraw = (): void => packing?.redraw();
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
  const header = el("header", {}, el("h1", {}, title), schemeButton(redraw));
  const sections = [
    summarySection(),
    packing?.element,
    timeSection(),
    densitySection(),
    distributionSection(),
    anySection(),
  ];
  const footer = el(
    "footer",
    {},
    `Made by frit ${data.version}. All numbers are in the folder of the results: series.csv, summary.json, snapshots.pvd.`,
  );
  document.body.append(header, el("main", {}, ...sections.map((section) => section ?? null)), footer, timeBar());
  // For tests and for the browser's console.
  Object.assign(window, { frit: { runs, column, cursor, views: packing?.views ?? [], visibleRows } });
}

build();
