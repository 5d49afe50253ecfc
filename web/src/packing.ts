// The section of the 3D views: one a run, turned together, with what they show.
import { Camera } from "./camera";
import { drawColourBar, mapNames, usualRange } from "./colours";
import { check, choice, el } from "./dom";
import { nameAndUnit, label, short } from "./numbers";
import { runs } from "./runs";
import type { Necks } from "./scene";
import { type Settings, View } from "./view";

const preferred = ["rearrangement_d2min", "coordination"];

export class PackingSection {
  readonly element = el("section", { id: "packing" }, el("h2", {}, "Packing"));
  readonly views: View[] = [];
  private readonly settings: Settings;
  private readonly bar = el("canvas", { width: "256", height: "1", class: "colours" });
  private readonly ends: [HTMLInputElement, HTMLInputElement] = [numberInput("from"), numberInput("to")];
  private readonly legend = el("div", { class: "legend" });

  constructor() {
    const fields = [...new Set(runs.flatMap((run) => run.packing?.fields.map((field) => field.name) ?? []))];
    const first = preferred.find((name) => fields.includes(name)) ?? fields[0] ?? "";
    this.settings = {
      field: first,
      map: mapNames[0]!,
      range: { least: 0, most: 1 },
      spheres: 1,
      necks: "plain",
      cutAxis: 0,
      cutAt: 1,
      cell: true,
    };
    const grid = el("div", { class: "views" });
    try {
      const camera = new Camera();
      runs.forEach((run, n) => {
        if (!run.packing) return;
        const view = new View(n, this.settings, camera);
        view.onTurn = () => this.redraw();
        this.views.push(view);
        grid.append(view.element);
      });
    } catch (error) {
      this.element.append(
        el(
          "p",
          { class: "notice" },
          `No 3D view: ${(error as Error).message} in this browser. Curves and distributions do not need it; another browser, or one with hardware acceleration on, shows the packing.`,
        ),
      );
      return;
    }
    this.element.append(this.controls(fields), grid, this.makeLegend(), this.help());
    void this.fitRange();
  }

  redraw(): void {
    for (const view of this.views) view.request();
  }

  private controls(fields: string[]): HTMLElement {
    const { settings } = this;
    const slider = el("input", {
      type: "range",
      min: "0.02",
      max: "1",
      step: "0.01",
      value: "1",
      "aria-label": "place of the cut",
    });
    slider.addEventListener("input", () => {
      settings.cutAt = Number(slider.value);
      this.redraw();
    });
    const size = choice(
      "spheres",
      [
        ["1", "to scale"],
        ["0.35", "small: the network"],
        ["0", "none: necks only"],
      ],
      "1",
      (value) => {
        settings.spheres = Number(value);
        this.redraw();
      },
    );
    const colour = choice(
      "colour",
      [["", "one colour"], ...fields.map((name): [string, string] => [name, label(name)])],
      settings.field,
      (name) => {
        settings.field = name;
        void this.fitRange();
      },
    );
    const cut = choice(
      "cut along",
      [
        ["0", "x"],
        ["1", "y"],
        ["2", "z"],
      ],
      "0",
      (axis) => {
        settings.cutAxis = Number(axis) as 0 | 1 | 2;
        this.redraw();
      },
    );
    const periodic = runs.some((run) => run.packing?.frames[0]?.periodic);
    const necks = choice(
      "necks",
      [
        ["plain", "as the particles"],
        ["ratio", "by r/R, 0 to 0.8"],
        ["none", "none"],
      ],
      settings.necks,
      (value) => {
        settings.necks = value as Necks;
        this.redraw();
      },
    );
    const cell = check(periodic ? "cell" : "box", settings.cell, (on) => {
      settings.cell = on;
      this.redraw();
    });
    return el("div", { class: "bar" }, colour, size, necks, cut, slider, cell);
  }

  private makeLegend(): HTMLElement {
    const maps = choice(
      "",
      mapNames.map((name): [string, string] => [name, name]),
      this.settings.map,
      (map) => {
        this.settings.map = map;
        drawColourBar(this.bar, map);
        this.redraw();
      },
    );
    maps.title = "colour map";
    this.ends.forEach((input, n) =>
      input.addEventListener("change", () => {
        const value = Number(input.value);
        if (!Number.isFinite(value)) return;
        this.settings.range[n === 0 ? "least" : "most"] = value;
        this.redraw();
      }),
    );
    drawColourBar(this.bar, this.settings.map);
    this.legend.append(el("span", { class: "name" }), this.ends[0], this.bar, this.ends[1], maps);
    return this.legend;
  }

  private help(): HTMLElement {
    return el(
      "p",
      { class: "help" },
      "Drag or arrow keys turn, wheel or + − zoom, shift and drag moves, 0 shows all, comma and full stop step through time; on touch: one finger turns, two zoom and move.",
    );
  }

  /** Sets the colours' range to where most values of all frames and runs lie. */
  private async fitRange(): Promise<void> {
    const { settings } = this;
    const name = nameAndUnit(settings.field);
    this.legend.classList.toggle("off", settings.field === "");
    this.legend.firstChild!.textContent = name.unit ? `${name.name} [${name.unit}]` : name.name;
    const ranges = [];
    for (const view of this.views) if (view.field) ranges.push(usualRange(view.field, await view.allCodes()));
    if (ranges.length > 0) {
      settings.range = {
        least: Math.min(...ranges.map((range) => range.least)),
        most: Math.max(...ranges.map((range) => range.most)),
      };
      this.ends[0].value = String(Number(settings.range.least.toPrecision(3)));
      this.ends[1].value = String(Number(settings.range.most.toPrecision(3)));
      this.ends[0].title = short(settings.range.least);
    }
    this.redraw();
  }
}

function numberInput(name: string): HTMLInputElement {
  return el("input", { type: "text", inputmode: "decimal", size: "7", "aria-label": `colours ${name}` });
}
