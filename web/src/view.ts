// The 3D view of one run: canvas, colour bar, scale bar, and what the pointer and the keys do.
import { Camera } from "./camera";
import { type Range, codeColours } from "./colours";
import { cursor } from "./cursor";
import { button, el } from "./dom";
import { saveBlob } from "./download";
import { type Frame, Frames, decode } from "./frames";
import { label, lengthUnit, roundDown, short, timeUnit } from "./numbers";
import { Renderer } from "./renderer";
import { nearestRow, runs } from "./runs";
import { type Look, type Necks, type Prepared, prepare } from "./scene";
import type { Field, Packing } from "./types";

export interface Settings {
  field: string; // name, or "" for one colour
  map: string;
  range: Range;
  spheres: number;
  necks: Necks;
  cutAxis: 0 | 1 | 2;
  cutAt: number;
  cell: boolean;
}

export class View {
  readonly element: HTMLElement;
  readonly frames: Frames;
  readonly camera: Camera;
  onTurn: () => void = () => {};
  private readonly canvas = el("canvas", {
    tabindex: "0",
    role: "img",
    "aria-label": "packing, to turn with the arrow keys",
  });
  private readonly title = el("figcaption");
  private readonly tip = el("div", { class: "tip", hidden: "" });
  private readonly scaleBar = el("div", { class: "scale" }, el("i"), el("span"));
  private readonly renderer: Renderer;
  private readonly packing: Packing;
  private frame: Frame | null = null;
  private shownIndex = -1;
  private prepared: Prepared | null = null;
  private waiting = false;
  /** Milliseconds from the start of preparing to all pixels, of the last frames drawn; for tests. */
  readonly drawTimes: number[] = [];
  measure = false;

  constructor(
    readonly run: number,
    private readonly settings: Settings,
    camera: Camera,
  ) {
    this.packing = runs[run]!.packing!;
    this.frames = new Frames(this.packing, run);
    this.camera = camera;
    this.renderer = new Renderer(this.canvas);
    const save = button("PNG", "save a picture", () => this.save());
    const whole = button("whole", "see all of it again (key 0)", () => {
      camera.reset();
      this.onTurn();
    });
    this.element = el(
      "figure",
      { class: "view" },
      this.title,
      el("div", { class: "stage" }, this.canvas, this.scaleBar, this.tip),
      el("div", { class: "tools" }, whole, save),
    );
    this.listen();
    cursor.listen(() => void this.load());
    new ResizeObserver(() => this.resize()).observe(this.canvas);
    void this.load();
  }

  get field(): Field | undefined {
    return this.packing.fields.find((field) => field.name === this.settings.field);
  }

  get snapshotIndex(): number {
    return nearestRow(
      this.packing.frames.map((frame) => frame.time),
      cursor.timeOf(this.run),
    );
  }

  async load(): Promise<void> {
    const index = this.snapshotIndex;
    const frame = await this.frames.get(index);
    if (index !== this.snapshotIndex) return;
    this.shownIndex = index;
    this.frame = frame;
    this.request();
  }

  /** Draws with the next frame of the screen. */
  request(): void {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.draw();
    });
  }

  private resize(): void {
    const ratio = Math.min(2, devicePixelRatio);
    this.canvas.width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    this.canvas.height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    // At once: changing the size has cleared the canvas.
    this.draw();
  }

  private halfHeight(): number {
    const [width, height] = [this.canvas.width, this.canvas.height];
    // The box of the first frame fits, however it is turned, so that shrinkage shows.
    const [a, b, c] = this.packing.frames[0]!.size.map((size) => size / this.packing.mean_radius) as [
      number,
      number,
      number,
    ];
    const reach = 0.44 * Math.hypot(a, b, c) + 0.8;
    const whole = (reach * Math.max(1, height / width)) / this.camera.zoom;
    // The largest sphere must fit into the largest point that the graphics can draw.
    const largest = this.packing.largest_radius / this.packing.mean_radius;
    return Math.max(whole, (largest * height) / (this.renderer.largestPoint - 2));
  }

  private look(): Look {
    const field = this.field;
    const plain = new Uint8Array([199, 190, 178, 255]);
    const neckField: Field = { name: "neck_ratio", least: 0, most: 1, square: false };
    return {
      ...this.settings,
      codeColours: field ? codeColours(this.settings.map, field, this.settings.range) : plain,
      neckColours: codeColours(this.settings.map, neckField, { least: 0, most: 0.8 }),
      field: field ? this.packing.fields.indexOf(field) : -1,
    };
  }

  draw(): void {
    if (!this.frame || this.canvas.width < 2) return;
    const begin = performance.now();
    const halfHeight = this.halfHeight();
    const window = {
      halfWidth: (halfHeight * this.canvas.width) / this.canvas.height,
      halfHeight,
      pixel: (2 * halfHeight) / this.canvas.height,
    };
    this.prepared = prepare(this.frame, this.camera, this.look(), window);
    const dark = getComputedStyle(document.body).colorScheme === "dark";
    this.renderer.draw({
      ...this.prepared.scene,
      halfHeight,
      background: dark ? [0.07, 0.075, 0.085] : [1, 1, 1],
      lineColour: dark ? [0.6, 0.6, 0.6] : [0.45, 0.45, 0.45],
    });
    if (this.measure) {
      this.renderer.finish();
      this.drawTimes.push(performance.now() - begin);
    }
    this.canvas.dataset.ready = String(this.shownIndex);
    this.drawLabels(halfHeight);
  }

  private drawLabels(halfHeight: number): void {
    const info = this.packing.frames[this.shownIndex]!;
    const unit = timeUnit(this.packing.frames.at(-1)!.time);
    const name = runs.length > 1 ? `${runs[this.run]!.name}, ` : "";
    this.title.textContent = `${name}t = ${short(info.time / unit.size)} ${unit.name}, ${this.packing.count.toLocaleString("en")} particles`;
    const perPixel = (2 * halfHeight * this.packing.mean_radius) / this.canvas.clientHeight;
    const length = roundDown(perPixel * 0.24 * this.canvas.clientWidth);
    const lengths = lengthUnit(length);
    (this.scaleBar.firstChild as HTMLElement).style.width = `${length / perPixel}px`;
    this.scaleBar.lastChild!.textContent = `${short(length / lengths.size)} ${lengths.name}`;
  }

  private save(): void {
    this.draw(); // in the same turn: the picture is gone after it
    this.canvas.toBlob((blob) => saveBlob(`${runs[this.run]!.name}_packing.png`, blob!));
  }

  private listen(): void {
    const fingers = new Map<number, PointerEvent>();
    this.canvas.addEventListener("pointerdown", (event) => {
      fingers.set(event.pointerId, event);
      this.canvas.setPointerCapture(event.pointerId);
      this.tip.hidden = true;
    });
    const lift = (event: PointerEvent): void => void fingers.delete(event.pointerId);
    this.canvas.addEventListener("pointerup", lift);
    this.canvas.addEventListener("pointercancel", lift);
    this.canvas.addEventListener("pointerleave", () => (this.tip.hidden = true));
    this.canvas.addEventListener("pointermove", (event) => {
      const before = fingers.get(event.pointerId);
      if (!before) return this.hover(event);
      this.drag(before, event, fingers);
      fingers.set(event.pointerId, event);
      this.onTurn();
    });
    this.canvas.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        this.zoomBy(Math.exp(-0.0015 * event.deltaY));
      },
      { passive: false },
    );
    this.canvas.addEventListener("keydown", (event) => this.onKey(event));
  }

  private drag(before: PointerEvent, now: PointerEvent, fingers: Map<number, PointerEvent>): void {
    const [dx, dy] = [now.clientX - before.clientX, now.clientY - before.clientY];
    const other = [...fingers.values()].find((finger) => finger.pointerId !== now.pointerId);
    if (other) {
      const apart = (finger: PointerEvent): number =>
        Math.hypot(finger.clientX - other.clientX, finger.clientY - other.clientY);
      this.camera.zoom = clampZoom((this.camera.zoom * apart(now)) / (apart(before) || 1));
      this.shift(dx / 2, dy / 2);
    } else if (now.shiftKey || now.buttons & 6) {
      this.shift(dx, dy);
    } else {
      this.camera.rotate(dx * 0.008, dy * 0.008);
    }
  }

  private shift(dx: number, dy: number): void {
    const perPixel = (2 * this.halfHeight()) / this.canvas.clientHeight;
    this.camera.shiftX += dx * perPixel;
    this.camera.shiftY -= dy * perPixel;
  }

  private zoomBy(factor: number): void {
    this.camera.zoom = clampZoom(this.camera.zoom * factor);
    this.onTurn();
  }

  private onKey(event: KeyboardEvent): void {
    const turns: Record<string, [number, number]> = {
      ArrowLeft: [-0.1, 0],
      ArrowRight: [0.1, 0],
      ArrowUp: [0, -0.1],
      ArrowDown: [0, 0.1],
    };
    const turn = turns[event.key];
    if (turn && event.shiftKey) this.shift(turn[0] * 300, turn[1] * 300);
    else if (turn) this.camera.rotate(...turn);
    else if (event.key === "+" || event.key === "=") this.camera.zoom = clampZoom(this.camera.zoom * 1.15);
    else if (event.key === "-") this.camera.zoom = clampZoom(this.camera.zoom / 1.15);
    else if (event.key === "0") this.camera.reset();
    else if (event.key === "," || event.key === ".")
      return cursor.set(cursor.rowOf(this.run) + (event.key === "." ? 1 : -1), this.run);
    else return;
    event.preventDefault();
    this.onTurn();
  }

  /** The particle under the pointer, if any. */
  private pick(event: PointerEvent): number | null {
    if (!this.prepared) return null;
    const box = this.canvas.getBoundingClientRect();
    const perPixel = (2 * this.halfHeight()) / box.height;
    const x = (event.clientX - box.left - box.width / 2) * perPixel;
    const y = -(event.clientY - box.top - box.height / 2) * perPixel;
    const { turned, rows } = this.prepared;
    let [found, front]: [number | null, number] = [null, Infinity];
    for (const row of rows) {
      const squared = turned.radii[row]! ** 2 - (turned.x[row]! - x) ** 2 - (turned.y[row]! - y) ** 2;
      if (squared <= 0 || turned.z[row]! - Math.sqrt(squared) >= front) continue;
      [found, front] = [row, turned.z[row]! - Math.sqrt(squared)];
    }
    return found;
  }

  private hover(event: PointerEvent): void {
    const row = this.pick(event);
    this.tip.hidden = row === null;
    if (row === null || !this.frame) return;
    const radius = this.frame.radii[row]! * this.packing.mean_radius;
    const unit = lengthUnit(radius);
    const lines = this.packing.fields.map(
      (field, n) => `${label(field.name)}: ${short(decode(field, this.frame!.codes[n]![row]!), 3)}`,
    );
    this.tip.textContent = [
      `particle ${this.packing.ids?.[row] ?? row}`,
      `radius: ${short(radius / unit.size, 3)} ${unit.name}`,
      ...lines,
    ].join("\n");
    const box = this.canvas.getBoundingClientRect();
    this.tip.style.left = `${Math.min(event.clientX - box.left + 14, box.width - this.tip.offsetWidth - 4)}px`;
    this.tip.style.top = `${Math.min(event.clientY - box.top + 14, box.height - this.tip.offsetHeight - 4)}px`;
  }

  /** All codes of the field, frame by frame, for its usual range. */
  async allCodes(): Promise<Uint8Array[]> {
    const index = this.packing.fields.findIndex((field) => field.name === this.settings.field);
    const frames = await Promise.all(this.packing.frames.map((_, n) => this.frames.get(n)));
    return frames.map((frame) => frame.codes[index]!);
  }
}

const clampZoom = (zoom: number): number => Math.max(0.3, Math.min(60, zoom));
