// Distributions over particles and contacts at the moment of the cursor.
import { cursor } from "./cursor";
import { choice, el, svg } from "./dom";
import { csvOf, saveButtons } from "./download";
import { label, short } from "./numbers";
import { linear } from "./scale";
import { nearestRow, runColour, runs } from "./runs";
import type { Distribution } from "./types";

const height = 230;
const margin = { left: 46, right: 12, top: 8, bottom: 40 };

interface Shown {
  run: number;
  of: Distribution;
  shares: number[]; // of a bin
  time: number;
}

/** Shares of one quantity at the cursor, a step curve a run. */
class Histogram {
  readonly element: HTMLElement;
  private readonly drawing = svg("svg", { class: "chart", role: "img" });
  private readonly caption = el("figcaption");

  constructor(private name: string) {
    const tools = saveButtons(
      () => this.name,
      this.drawing,
      () => this.csv(),
    );
    this.element = el("figure", {}, this.caption, el("div", { class: "plot" }, this.drawing), tools);
    cursor.listen(() => this.draw());
    new ResizeObserver(() => this.draw()).observe(this.drawing);
  }

  show(name: string): void {
    this.name = name;
    this.draw();
  }

  private shown(): Shown[] {
    return runs.flatMap((run, n) => {
      const of = run.distributions?.fields.find((field) => field.name === this.name);
      if (!of) return [];
      const snapshot = nearestRow(run.distributions!.times, cursor.timeOf(n));
      const counts = of.counts[snapshot]!;
      const all = counts.reduce((sum, count) => sum + count, 0) || 1;
      return [{ run: n, of, shares: counts.map((count) => count / all), time: run.distributions!.times[snapshot]! }];
    });
  }

  private csv(): string {
    return csvOf(
      this.shown().flatMap(({ run, of, shares }) => {
        const width = (of.range[1] - of.range[0]) / shares.length;
        return [
          {
            name: `${label(of.name)}: middle of the bin (${runs[run]!.name})`,
            values: shares.map((_, bin) => of.range[0] + (bin + 0.5) * width),
          },
          { name: `share (${runs[run]!.name})`, values: shares },
        ];
      }),
    );
  }

  private draw(): void {
    const width = this.drawing.clientWidth;
    const shown = this.shown();
    if (width === 0 || shown.length === 0) return;
    const [first] = shown as [Shown];
    const snapshots = runs[first.run]!.distributions!.times;
    const mean = first.of.mean[snapshots.indexOf(first.time)];
    this.caption.replaceChildren(el("strong", {}, label(first.of.name)), ` over ${first.of.over}, mean ${short(mean)}`);
    this.drawing.setAttribute("width", String(width));
    this.drawing.setAttribute("height", String(height));
    this.drawing.replaceChildren();
    const ranges = shown.map(({ of }) => of.range);
    const x = linear(Math.min(...ranges.map((r) => r[0])), Math.max(...ranges.map((r) => r[1])));
    const y = linear(0, Math.max(...shown.flatMap(({ shares }) => shares)) * 1.05);
    const px = (value: number): number => margin.left + x.place(value) * (width - margin.left - margin.right);
    const py = (value: number): number =>
      height - margin.bottom - y.place(value) * (height - margin.top - margin.bottom);
    const whole = first.shares.length === first.of.range[1] - first.of.range[0];
    const ticks = x.ticks(width / 90).filter((tick) => !whole || Number.isInteger(tick));
    this.drawAxes(ticks, y.ticks(4), px, py, width);
    for (const each of shown) this.drawing.append(this.steps(each, px, py));
  }

  private drawAxes(
    xs: number[],
    ys: number[],
    px: (v: number) => number,
    py: (v: number) => number,
    width: number,
  ): void {
    const bottom = height - margin.bottom;
    for (const tick of ys) {
      this.drawing.append(
        svg("line", { class: "grid", x1: margin.left, x2: width - margin.right, y1: py(tick), y2: py(tick) }),
      );
      this.drawing.append(
        svg(
          "text",
          { class: "tick", x: margin.left - 6, y: py(tick) + 4, "text-anchor": "end" },
          `${short(100 * tick)} %`,
        ),
      );
    }
    for (const tick of xs)
      this.drawing.append(
        svg("text", { class: "tick", x: px(tick), y: bottom + 16, "text-anchor": "middle" }, short(tick, 3)),
      );
    this.drawing.append(svg("path", { class: "axis", d: `M${margin.left} ${bottom}H${width - margin.right}` }));
    this.drawing.append(
      svg(
        "text",
        { class: "label", x: (margin.left + width) / 2, y: height - 5, "text-anchor": "middle" },
        label(this.name),
      ),
    );
  }

  private steps({ run, of, shares }: Shown, px: (v: number) => number, py: (v: number) => number): SVGElement {
    const width = (of.range[1] - of.range[0]) / shares.length;
    let path = `M${px(of.range[0])} ${py(0)}`;
    shares.forEach((share, bin) => {
      path += `V${py(share).toFixed(2)}H${px(of.range[0] + (bin + 1) * width).toFixed(2)}`;
    });
    return svg("path", { class: "steps", d: `${path}V${py(0)}Z`, fill: runColour(run), stroke: runColour(run) });
  }
}

const wanted = ["neck_ratio", "normal_force [N]", "coordination", "rearrangement_d2min"];

export function distributionSection(): HTMLElement | null {
  const names = [...new Set(runs.flatMap((run) => run.distributions?.fields.map((field) => field.name) ?? []))];
  if (names.length === 0) return null;
  const first = [...wanted.filter((name) => names.includes(name)), ...names.filter((name) => !wanted.includes(name))];
  const grid = el("div", { class: "grid" });
  first.slice(0, 4).forEach((name) => {
    const histogram = new Histogram(name);
    const options = names.map((each): [string, string] => [each, label(each)]);
    histogram.element.prepend(choice("", options, name, (value) => histogram.show(value)));
    grid.append(histogram.element);
  });
  return el("section", { id: "distributions" }, el("h2", {}, "Distributions"), grid);
}
