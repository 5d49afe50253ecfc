// The moment that all parts of the page show: a row of the first run, and the rows of the others that go with it.
import { column, nearestRow, runs } from "./runs";

type Listener = () => void;

const times = runs.map((run) => column(run, "time")!);
const densities = runs.map((run) => column(run, "relative_density") ?? column(run, "time")!);

export class Cursor {
  private row = times[0]!.length - 1;
  private listeners: Listener[] = [];
  private atEqual: "time" | "density" = runs.length > 1 ? "density" : "time";

  listen(listener: Listener): void {
    this.listeners.push(listener);
  }

  rowOf(run: number): number {
    if (run === 0) return this.row;
    const [of, own] = this.atEqual === "time" ? [times[0]!, times[run]!] : [densities[0]!, densities[run]!];
    return nearestRow(own, of[this.row]!);
  }

  timeOf(run: number): number {
    return times[run]![this.rowOf(run)]!;
  }

  get rows(): number {
    return times[0]!.length;
  }

  compareAt(what: "time" | "density"): void {
    this.atEqual = what;
    this.tell();
  }

  /** Goes to a row of a run. */
  set(row: number, run = 0): void {
    const [of, own] = this.atEqual === "time" ? [times[0]!, times[run]!] : [densities[0]!, densities[run]!];
    const wanted = run === 0 ? row : nearestRow(of, own[row]!);
    const inside = Math.max(0, Math.min(this.rows - 1, wanted));
    if (inside === this.row) return;
    this.row = inside;
    this.tell();
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}

export const cursor = new Cursor();
