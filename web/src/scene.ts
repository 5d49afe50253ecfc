// From a decoded frame and a camera to what the renderer draws.
import type { Camera } from "./camera";
import type { Frame } from "./frames";
import type { Scene } from "./renderer";
import { visibleRows, type Turned, type Window } from "./visible";

export type Necks = "none" | "plain" | "ratio"; // plain: as the particles they join

export interface Look {
  spheres: number; // share of the radius
  necks: Necks;
  cutAxis: 0 | 1 | 2;
  cutAt: number; // share of the box that is kept along the axis
  cell: boolean;
  codeColours: Uint8Array; // r, g, b, 255 for each code
  neckColours: Uint8Array; // the same for 254 times the neck ratio
  field: number;
}

/** Rows on the near side of the cut. */
function keptRows(frame: Frame, look: Look): Uint32Array {
  const count = frame.radii.length;
  const limit = (look.cutAt - 0.5) * frame.box[look.cutAxis]! + (look.cutAt >= 1 ? 1e9 : 0);
  const rows = new Uint32Array(count);
  let kept = 0;
  for (let n = 0; n < count; ++n) if (frame.places[3 * n + look.cutAxis]! <= limit) rows[kept++] = n;
  return rows.subarray(0, kept);
}

export function turned(frame: Frame, camera: Camera, size: number): Turned {
  const count = frame.radii.length;
  const [x, y, z, radii] = [0, 1, 2, 3].map(() => new Float32Array(count)) as [
    Float32Array,
    Float32Array,
    Float32Array,
    Float32Array,
  ];
  const m = camera.turn;
  const { places } = frame;
  for (let n = 0; n < count; ++n) {
    const [a, b, c] = [places[3 * n]!, places[3 * n + 1]!, places[3 * n + 2]!];
    x[n] = m[0] * a + m[1] * b + m[2] * c + camera.shiftX;
    y[n] = m[3] * a + m[4] * b + m[5] * c + camera.shiftY;
    z[n] = m[6] * a + m[7] * b + m[8] * c;
    radii[n] = frame.radii[n]! * size;
  }
  return { x, y, z, radii };
}

export interface Prepared {
  scene: Omit<Scene, "background" | "lineColour" | "halfHeight">;
  turned: Turned;
  rows: Uint32Array; // drawn, from front to back
}

export function prepare(frame: Frame, camera: Camera, look: Look, window: Window): Prepared {
  const kept = keptRows(frame, look);
  const places = turned(frame, camera, look.spheres);
  const rows = look.spheres > 0 ? visibleRows(kept, places, window) : new Uint32Array(0);
  const spheres = new Float32Array(4 * rows.length);
  const sphereColours = new Uint8Array(4 * rows.length);
  const codes = frame.codes[look.field];
  for (let k = 0; k < rows.length; ++k) {
    const n = rows[k]!;
    spheres[4 * k] = places.x[n]!;
    spheres[4 * k + 1] = places.y[n]!;
    spheres[4 * k + 2] = places.z[n]!;
    spheres[4 * k + 3] = places.radii[n]!;
    const from = codes ? 4 * codes[n]! : 0;
    for (let c = 0; c < 4; ++c) sphereColours[4 * k + c] = look.codeColours[from + c]!;
  }
  const necks =
    look.necks !== "none"
      ? neckList(frame, camera, look, { kept, rows })
      : { bodies: new Float32Array(0), colours: new Uint8Array(0) };
  const reach = Math.hypot(...frame.box) / 2 + 2.5;
  const scene = {
    spheres,
    sphereColours,
    necks: necks.bodies,
    neckColours: necks.colours,
    lines: look.cell ? edges(frame, camera) : new Float32Array(0),
    depth: [-reach, reach] as [number, number],
  };
  return { scene, turned: places, rows };
}

/** Vector from i to j; null where they touch across a face of the periodic cell: half a neck would stick out there. */
function separation(frame: Frame, i: number, j: number): [number, number, number] | null {
  const d: [number, number, number] = [0, 0, 0];
  const reach = 1.05 * (frame.radii[i]! + frame.radii[j]!);
  for (let axis = 0; axis < 3; ++axis) {
    d[axis] = frame.places[3 * j + axis]! - frame.places[3 * i + axis]!;
    if (Math.abs(d[axis]!) > reach) return null;
  }
  return d;
}

/**
 * Cylinders: between spheres to scale from surface to surface at the radius of the neck, between small ones from centre to
 * centre. Drawn where an end is seen (spheres to scale) or kept (small spheres).
 */
function neckList(
  frame: Frame,
  camera: Camera,
  look: Look,
  of: { kept: Uint32Array; rows: Uint32Array },
): { bodies: Float32Array; colours: Uint8Array } {
  const toScale = look.spheres >= 1;
  const wanted = new Uint8Array(frame.radii.length);
  for (const row of of.kept) wanted[row] = toScale ? 1 : 3;
  for (const row of of.rows) wanted[row]! |= 2;
  const bodies = new Float32Array(8 * frame.neckRatios.length);
  const colours = new Uint8Array(4 * frame.neckRatios.length);
  const m = camera.turn;
  let count = 0;
  for (let k = 0; k < frame.neckRatios.length; ++k) {
    const [i, j] = [frame.neckEnds[2 * k]!, frame.neckEnds[2 * k + 1]!];
    if (!((wanted[i]! | wanted[j]!) & 2) || !(wanted[i]! & wanted[j]!)) continue;
    const d = separation(frame, i, j);
    if (!d) continue;
    const length = Math.hypot(...d);
    const [ri, rj] = [frame.radii[i]!, frame.radii[j]!];
    const radius = ((frame.neckRatios[k]! / 254) * 2 * ri * rj) / (ri + rj);
    const begin = toScale ? Math.sqrt(Math.max(0, ri * ri - radius * radius)) : 0;
    const end = toScale ? length - Math.sqrt(Math.max(0, rj * rj - radius * radius)) : length;
    if (end <= begin || length === 0) continue;
    const middle = (begin + end) / (2 * length);
    const at = 8 * count;
    for (let axis = 0; axis < 3; ++axis) {
      const row = 3 * axis;
      const along = m[row]! * d[0] + m[row + 1]! * d[1] + m[row + 2]! * d[2];
      const from =
        m[row]! * frame.places[3 * i]! +
        m[row + 1]! * frame.places[3 * i + 1]! +
        m[row + 2]! * frame.places[3 * i + 2]!;
      bodies[at + axis] = from + middle * along + (axis === 0 ? camera.shiftX : axis === 1 ? camera.shiftY : 0);
      bodies[at + 4 + axis] = along / length;
    }
    bodies[at + 3] = toScale ? radius : 0.45 * radius;
    bodies[at + 7] = (end - begin) / 2;
    for (let c = 0; c < 4; ++c)
      colours[4 * count + c] =
        look.necks === "ratio" ? look.neckColours[4 * frame.neckRatios[k]! + c]! : mean(frame, look, i, j, c);
    ++count;
  }
  return { bodies: bodies.subarray(0, 8 * count), colours: colours.subarray(0, 4 * count) };
}

// Of one part of the colours of two particles.
function mean(frame: Frame, look: Look, i: number, j: number, part: number): number {
  const codes = frame.codes[look.field];
  return codes
    ? (look.codeColours[4 * codes[i]! + part]! + look.codeColours[4 * codes[j]! + part]!) / 2
    : look.codeColours[part]!;
}

/** The twelve edges of the box. */
function edges(frame: Frame, camera: Camera): Float32Array {
  const ends: number[] = [];
  const m = camera.turn;
  const add = (corner: number): void => {
    const [a, b, c] = [0, 1, 2].map((axis) => ((corner >> axis) & 1 ? 0.5 : -0.5) * frame.box[axis]!) as [
      number,
      number,
      number,
    ];
    ends.push(
      m[0] * a + m[1] * b + m[2] * c + camera.shiftX,
      m[3] * a + m[4] * b + m[5] * c + camera.shiftY,
      m[6] * a + m[7] * b + m[8] * c,
    );
  };
  for (let corner = 0; corner < 8; ++corner) {
    for (let axis = 0; axis < 3; ++axis) {
      if ((corner >> axis) & 1) continue;
      add(corner);
      add(corner | (1 << axis));
    }
  }
  return new Float32Array(ends);
}
