// The embedded data, and columns computed from it.
import type { PageData, Run } from "./types";

export const data: PageData = JSON.parse(document.getElementById("data")!.textContent!);
export const runs: Run[] = data.runs;

/** Values of a column by its name, with or without unit, NaN for what is missing; null where the run lacks it. */
export function column(run: Run, name: string): Float64Array | null {
  const index = run.series.columns.findIndex((c) => c === name || c.startsWith(`${name} [`));
  if (index < 0) return null;
  return Float64Array.from(run.series.values[index]!, (value) => value ?? NaN);
}

/** Mean of the three logarithmic strains as shrinkage, positive when it shrinks. */
export function shrinkage(run: Run): Float64Array | null {
  const strains = ["x", "y", "z"].map((axis) => column(run, `linear_strain_${axis}`));
  if (strains.some((strain) => !strain)) return null;
  const [x, y, z] = strains as [Float64Array, Float64Array, Float64Array];
  return x.map((value, row) => -(value + y[row]! + z[row]!) / 3);
}

/** Rate of change of the density over the density [1/s]: slope of the parabola through a row and its two neighbours. */
export function densificationRate(run: Run): Float64Array | null {
  const time = column(run, "time");
  const density = column(run, "relative_density");
  if (!time || !density || time.length < 3) return null;
  return density.map((value, row) => {
    const a = Math.max(0, Math.min(row - 1, time.length - 3));
    return parabolaSlope(time, density, a, time[row]!) / value;
  });
}

function parabolaSlope(x: Float64Array, y: Float64Array, a: number, at: number): number {
  const [x0, x1, x2] = [x[a]!, x[a + 1]!, x[a + 2]!];
  const first = (y[a + 1]! - y[a]!) / (x1 - x0);
  const second = ((y[a + 2]! - y[a + 1]!) / (x2 - x1) - first) / (x2 - x0);
  return first + second * (2 * at - x0 - x1);
}

/** Dimensionless sintering time tau; null where the radius is not known. */
export function dimensionlessTime(run: Run): Float64Array | null {
  const theta = column(run, "theta");
  return theta && run.tau_per_theta !== null ? theta.map((value) => value * run.tau_per_theta!) : null;
}

/** The row whose value is nearest. */
export function nearestRow(values: ArrayLike<number>, value: number): number {
  let best = 0;
  for (let row = 1; row < values.length; ++row) {
    if (!(Math.abs(values[row]! - value) >= Math.abs(values[best]! - value))) best = row;
  }
  return best;
}

/** Colours of runs (Okabe and Ito 2008, told apart by the colour-blind). */
export const runColours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];
export const runColour = (index: number): string => runColours[index % runColours.length]!;

/** From base64. A plain loop: ten times faster than Uint8Array.from with a function. */
export function bytesOf(text: string): Uint8Array {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let n = 0; n < bytes.length; ++n) bytes[n] = letters.charCodeAt(n);
  return bytes;
}
