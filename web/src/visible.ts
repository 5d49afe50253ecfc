// Which spheres can be seen: most of a packing is hidden behind its outer layers, and need not be drawn.

/** What the eye looks at: places already turned, z away from the eye. */
export interface Turned {
  x: Float32Array;
  y: Float32Array;
  z: Float32Array;
  radii: Float32Array;
}

export interface Window {
  halfWidth: number;
  halfHeight: number;
  pixel: number; // its edge
}

const bins = 4096;
const cellsAcrossRadius = 4;

/** Rows from front to back. */
export function fromFrontToBack(rows: Uint32Array, z: Float32Array): Uint32Array {
  let least = Infinity;
  let most = -Infinity;
  for (const row of rows) {
    if (z[row]! < least) least = z[row]!;
    if (z[row]! > most) most = z[row]!;
  }
  const factor = (bins - 1) / (most - least || 1);
  const starts = new Uint32Array(bins + 1);
  for (const row of rows) starts[((z[row]! - least) * factor) | 0]! += 1;
  let sum = 0;
  for (let bin = 0; bin < bins; ++bin) {
    const count = starts[bin]!;
    starts[bin] = sum;
    sum += count;
  }
  const sorted = new Uint32Array(rows.length);
  for (const row of rows) sorted[starts[((z[row]! - least) * factor) | 0]!++] = row;
  return sorted;
}

/**
 * Rows that are in the window and not certainly hidden, from front to back. A grid over the window holds for each cell the
 * depth of a sphere that covers it, but for half a pixel at its rims; a sphere is hidden where it lies behind that in all the
 * cells it touches.
 */
export function visibleRows(rows: Uint32Array, { x, y, z, radii }: Turned, window: Window): Uint32Array {
  let largest = 0;
  for (const row of rows) if (radii[row]! > largest) largest = radii[row]!;
  const cell = Math.max(largest / cellsAcrossRadius, window.pixel);
  const halfCell = (cell - window.pixel) / 2;
  const [across, up] = [Math.ceil((2 * window.halfWidth) / cell), Math.ceil((2 * window.halfHeight) / cell)];
  const covered = new Float32Array(across * up).fill(Infinity);
  const seen = new Uint32Array(rows.length);
  let count = 0;
  for (const row of fromFrontToBack(rows, z)) {
    const [px, py, r] = [x[row]! + window.halfWidth, y[row]! + window.halfHeight, radii[row]!];
    const left = Math.max(0, Math.floor((px - r) / cell));
    const right = Math.min(across - 1, Math.floor((px + r) / cell));
    const low = Math.max(0, Math.floor((py - r) / cell));
    const high = Math.min(up - 1, Math.floor((py + r) / cell));
    const front = z[row]! - r;
    let hidden = true;
    for (let v = low; v <= high && hidden; ++v) {
      for (let u = left; u <= right; ++u) {
        if (covered[v * across + u]! > front) {
          hidden = false;
          break;
        }
      }
    }
    if (hidden) continue;
    seen[count++] = row;
    for (let v = low; v <= high; ++v) {
      for (let u = left; u <= right; ++u) {
        // The farthest corner of the cell: where it is within the sphere, so is all of the cell.
        const dx = Math.abs((u + 0.5) * cell - px) + halfCell;
        const dy = Math.abs((v + 0.5) * cell - py) + halfCell;
        const inside = r * r - dx * dx - dy * dy;
        if (inside <= 0) continue;
        const depth = z[row]! - Math.sqrt(inside);
        if (depth < covered[v * across + u]!) covered[v * across + u] = depth;
      }
    }
  }
  return seen.subarray(0, count);
}
