// A chart of curves: hover for values, drag to zoom, double click to see all, click to move the cursor there.
import { cursor } from "./cursor";
import { el, svg } from "./dom";
import { csvOf, saveButtons } from "./download";
import { short } from "./numbers";
import { type Extent, type Scale, extent, linear, logarithmic } from "./scale";

export interface Curve {
  run: number;
  name: string;
  colour: string;
  x: Float64Array;
  y: Float64Array;
  low?: Float64Array; // of a band
  high?: Float64Array;
}

export interface ChartData {
  title: string;
  x: string; // what the axes show, with units
  y: string;
  curves: Curve[];
  note?: string;
}

export interface Axes {
  logX: boolean;
  logY: boolean;
}

const margin = { left: 66, right: 14, top: 10, bottom: 42 };
const height = 290;

export class Chart {
  readonly element: HTMLElement;
  private readonly drawing = svg("svg", { class: "chart", role: "img", tabindex: 0 });
  private readonly caption = el("figcaption");
  private readonly tip = el("div", { class: "tip", hidden: "" });
  private readonly marks = svg("g", { "data-transient": "" });
  private zoom: Extent | null = null;
  private width = 0;
  private scaleX: Scale = linear(0, 1);
  private scaleY: Scale = linear(0, 1);

  constructor(
    private data: ChartData,
    private axes: Axes = { logX: false, logY: false },
  ) {
    this.element = el(
      "figure",
      {},
      this.caption,
      el("div", { class: "plot" }, this.drawing, this.tip),
      saveButtons(
        () => this.data.title,
        this.drawing,
        () => this.csv(),
      ),
    );
    this.listenToPointer();
    this.drawing.addEventListener("keydown", (event) => this.onKey(event));
    new ResizeObserver(() => {
      if (this.drawing.clientWidth !== this.width) this.draw();
    }).observe(this.drawing);
    cursor.listen(() => this.drawMarks());
  }

  show(data: ChartData, axes: Axes): void {
    this.data = data;
    this.axes = axes;
    this.zoom = null;
    this.draw();
  }

  csv(): string {
    const columns = this.data.curves.flatMap((curve) => [
      { name: `${this.data.x} (${curve.name})`, values: curve.x },
      { name: `${this.data.y} (${curve.name})`, values: curve.y },
      ...(curve.low ? [{ name: `10 % (${curve.name})`, values: curve.low }] : []),
      ...(curve.high ? [{ name: `90 % (${curve.name})`, values: curve.high }] : []),
    ]);
    return csvOf(columns);
  }

  private draw(): void {
    this.width = this.drawing.clientWidth;
    if (this.width === 0) return;
    this.caption.replaceChildren(el("strong", {}, this.data.title), this.data.note ? ` ${this.data.note}` : "");
    this.drawing.setAttribute("aria-label", `${this.data.title}: ${this.data.y} against ${this.data.x}`);
    this.drawing.setAttribute("width", String(this.width));
    this.drawing.setAttribute("height", String(height));
    this.drawing.replaceChildren();
    this.scaleX = this.makeScale("x");
    this.scaleY = this.makeScale("y");
    this.drawAxes();
    this.drawCurves();
    this.drawing.append(this.marks);
    this.drawMarks();
  }

  private makeScale(axis: "x" | "y"): Scale {
    const log = axis === "x" ? this.axes.logX : this.axes.logY;
    const accepts = (value: number): boolean => Number.isFinite(value) && (!log || value > 0);
    const values: number[] = [];
    for (const curve of this.data.curves) {
      curve.x.forEach((x, row) => {
        if (axis === "x") values.push(x);
        else if (this.isVisible(x)) values.push(curve.y[row]!, curve.low?.[row] ?? NaN, curve.high?.[row] ?? NaN);
      });
    }
    let range =
      axis === "x" && this.zoom ? this.zoom : (extent(values, accepts) ?? { least: log ? 1 : 0, most: log ? 10 : 1 });
    if (axis === "y" || range.least === range.most) range = widened(range, log);
    return log ? logarithmic(range.least, range.most) : linear(range.least, range.most);
  }

  private isVisible(x: number): boolean {
    if (this.axes.logX && !(x > 0)) return false;
    return !this.zoom || (x >= this.zoom.least && x <= this.zoom.most);
  }

  private px = (value: number): number => margin.left + this.scaleX.place(value) * this.plotWidth();
  private py = (value: number): number =>
    height - margin.bottom - this.scaleY.place(value) * (height - margin.top - margin.bottom);
  private plotWidth = (): number => Math.max(10, this.width - margin.left - margin.right);

  private drawAxes(): void {
    const [left, right, top, bottom] = [margin.left, this.width - margin.right, margin.top, height - margin.bottom];
    for (const tick of this.scaleX.ticks(Math.max(2, this.plotWidth() / 80))) {
      const x = this.px(tick);
      this.drawing.append(svg("line", { class: "grid", x1: x, x2: x, y1: top, y2: bottom }));
      this.drawing.append(svg("text", { class: "tick", x, y: bottom + 17, "text-anchor": "middle" }, short(tick)));
    }
    for (const tick of this.scaleY.ticks(5)) {
      const y = this.py(tick);
      this.drawing.append(svg("line", { class: "grid", x1: left, x2: right, y1: y, y2: y }));
      this.drawing.append(svg("text", { class: "tick", x: left - 7, y: y + 4, "text-anchor": "end" }, short(tick)));
    }
    this.drawing.append(svg("path", { class: "axis", d: `M${left} ${top}V${bottom}H${right}` }));
    this.drawing.append(
      svg("text", { class: "label", x: (left + right) / 2, y: height - 6, "text-anchor": "middle" }, this.data.x),
    );
    const middle = (top + bottom) / 2;
    this.drawing.append(
      svg(
        "text",
        { class: "label", x: 14, y: middle, "text-anchor": "middle", transform: `rotate(-90 14 ${middle})` },
        this.data.y,
      ),
    );
  }

  private drawCurves(): void {
    const clip = `clip-${Math.random().toString(36).slice(2)}`;
    const area = svg("clipPath", { id: clip });
    area.append(
      svg("rect", {
        x: margin.left,
        y: margin.top - 4,
        width: this.plotWidth() + 4,
        height: height - margin.top - margin.bottom + 8,
      }),
    );
    const group = svg("g", { "clip-path": `url(#${clip})` });
    for (const curve of this.data.curves) {
      if (curve.low && curve.high)
        group.append(svg("path", { class: "band", d: this.bandPath(curve), fill: curve.colour }));
      group.append(svg("path", { class: "curve", d: this.path(curve.x, curve.y), stroke: curve.colour }));
      if (curve.x.length > 80) continue;
      curve.x.forEach((x, row) => {
        const y = curve.y[row]!;
        if (this.scaleX.accepts(x) && this.scaleY.accepts(y))
          group.append(svg("circle", { cx: this.px(x), cy: this.py(y), r: 1.8, fill: curve.colour }));
      });
    }
    this.drawing.append(area, group);
  }

  private path(xs: Float64Array, ys: Float64Array): string {
    let path = "";
    let pen = "M";
    xs.forEach((x, row) => {
      if (!this.scaleX.accepts(x) || !this.scaleY.accepts(ys[row]!)) {
        pen = "M";
        return;
      }
      path += `${pen}${this.px(x).toFixed(2)} ${this.py(ys[row]!).toFixed(2)}`;
      pen = "L";
    });
    return path;
  }

  private bandPath(curve: Curve): string {
    const there = this.path(curve.x, curve.high!);
    const back = this.path(curve.x.slice().reverse(), curve.low!.slice().reverse());
    return there && back ? `${there}${back.replace("M", "L")}Z` : "";
  }

  private drawMarks(): void {
    this.marks.replaceChildren();
    if (this.width === 0) return;
    this.data.curves.forEach((curve, n) => {
      const row = cursor.rowOf(curve.run);
      const [x, y] = [curve.x[row]!, curve.y[row]!];
      if (!this.scaleX.accepts(x) || !this.isVisible(x)) return;
      if (n === 0)
        this.marks.append(
          svg("line", { class: "cursor", x1: this.px(x), x2: this.px(x), y1: margin.top, y2: height - margin.bottom }),
        );
      if (this.scaleY.accepts(y))
        this.marks.append(svg("circle", { class: "mark", cx: this.px(x), cy: this.py(y), r: 4.5, fill: curve.colour }));
    });
  }

  /** The point of a curve that is nearest to a place on the screen, across first. */
  private nearest(clientX: number, clientY: number): { curve: Curve; row: number } | null {
    const box = this.drawing.getBoundingClientRect();
    let best: { curve: Curve; row: number } | null = null;
    let least = Infinity;
    for (const curve of this.data.curves) {
      curve.x.forEach((x, row) => {
        if (!this.isVisible(x) || !this.scaleX.accepts(x) || !this.scaleY.accepts(curve.y[row]!)) return;
        const away =
          Math.abs(this.px(x) - clientX + box.left) + 0.05 * Math.abs(this.py(curve.y[row]!) - clientY + box.top);
        if (away < least) [least, best] = [away, { curve, row }];
      });
    }
    return best;
  }

  private listenToPointer(): void {
    let from: number | null = null;
    const band = svg("rect", { class: "zoom", y: margin.top, height: height - margin.top - margin.bottom });
    const inPlot = (event: PointerEvent): number => {
      const x = event.clientX - this.drawing.getBoundingClientRect().left;
      return Math.max(margin.left, Math.min(this.width - margin.right, x));
    };
    this.drawing.addEventListener("pointerdown", (event) => {
      from = inPlot(event);
      this.drawing.setPointerCapture(event.pointerId);
    });
    this.drawing.addEventListener("pointermove", (event) => {
      this.hover(event);
      if (from === null) return;
      const x = inPlot(event);
      band.setAttribute("x", String(Math.min(from, x)));
      band.setAttribute("width", String(Math.abs(x - from)));
      this.marks.append(band);
    });
    this.drawing.addEventListener("pointerup", (event) => {
      if (from === null) return;
      const to = inPlot(event);
      band.remove();
      if (Math.abs(to - from) > 8) this.zoomTo(from, to);
      else this.jump(event);
      from = null;
    });
    this.drawing.addEventListener("pointercancel", () => {
      from = null;
      band.remove();
    });
    this.drawing.addEventListener("pointerleave", () => this.tip.setAttribute("hidden", ""));
    this.drawing.addEventListener("dblclick", () => {
      this.zoom = null;
      this.draw();
    });
  }

  private zoomTo(a: number, b: number): void {
    const value = (x: number): number => this.scaleX.value((x - margin.left) / this.plotWidth());
    this.zoom = { least: value(Math.min(a, b)), most: value(Math.max(a, b)) };
    this.draw();
  }

  private jump(event: PointerEvent): void {
    const found = this.nearest(event.clientX, event.clientY);
    if (found) cursor.set(found.row, found.curve.run);
  }

  private hover(event: PointerEvent): void {
    const found = this.nearest(event.clientX, event.clientY);
    this.tip.toggleAttribute("hidden", !found);
    if (!found) return;
    const { curve, row } = found;
    const band = curve.low && curve.high ? ` (${short(curve.low[row])} to ${short(curve.high[row])})` : "";
    this.tip.replaceChildren(
      ...(this.data.curves.length > 1 ? [el("b", { style: `color:${curve.colour}` }, curve.name), el("br")] : []),
      `${this.data.x}: ${short(curve.x[row]!, 6)}`,
      el("br"),
      `${this.data.y}: ${short(curve.y[row]!, 6)}${band}`,
    );
    const x = this.px(curve.x[row]!);
    this.tip.style.left = `${Math.min(x + 12, this.width - this.tip.offsetWidth - 4)}px`;
    this.tip.style.top = `${Math.max(2, this.py(curve.y[row]!) - this.tip.offsetHeight - 10)}px`;
  }

  private onKey(event: KeyboardEvent): void {
    const run = this.data.curves[0]?.run ?? 0;
    if (event.key === "ArrowLeft") cursor.set(cursor.rowOf(run) - 1, run);
    else if (event.key === "ArrowRight") cursor.set(cursor.rowOf(run) + 1, run);
    else if (event.key === "Escape") {
      this.zoom = null;
      this.draw();
    } else return;
    event.preventDefault();
  }
}

function widened(range: Extent, log: boolean): Extent {
  if (log) {
    const factor = range.least === range.most ? 2 : (range.most / range.least) ** 0.04;
    return { least: range.least / factor, most: range.most * factor };
  }
  const more = 0.05 * (range.most - range.least) || 0.05 * Math.abs(range.most) || 1;
  // Zero stays the floor of what is never negative and begins there.
  return { least: range.least === 0 ? 0 : range.least - more, most: range.most + more };
}
