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

/** Cells that a sphere touches, cut at the window. */
interface Patch {
  left: number;
  right: number;
  low: number;
  high: number;
}

/** A grid over the window: for each cell the depth of a sphere that covers it, but for half a pixel at its rims. */
class Cover {
  private readonly across: number;
  private readonly up: number;
  private readonly depths: Float32Array;
  private readonly halfCell: number; // less half a pixel

  constructor(
    private readonly window: Window,
    private readonly cell: number,
  ) {
    this.across = Math.ceil((2 * window.halfWidth) / cell);
    this.up = Math.ceil((2 * window.halfHeight) / cell);
    this.depths = new Float32Array(this.across * this.up).fill(Infinity);
    this.halfCell = (cell - window.pixel) / 2;
  }

  /** Of a sphere of radius r about (x, y), from the middle of the window. */
  patch(x: number, y: number, r: number): Patch {
    const { cell, window } = this;
    return {
      left: Math.max(0, Math.floor((x + window.halfWidth - r) / cell)),
      right: Math.min(this.across - 1, Math.floor((x + window.halfWidth + r) / cell)),
      low: Math.max(0, Math.floor((y + window.halfHeight - r) / cell)),
      high: Math.min(this.up - 1, Math.floor((y + window.halfHeight + r) / cell)),
    };
  }

  /** Whether nothing at this depth or behind shows in the patch; true for an empty patch. */
  hides({ left, right, low, high }: Patch, depth: number): boolean {
    for (let v = low; v <= high; ++v) {
      for (let u = left; u <= right; ++u) if (this.depths[v * this.across + u]! > depth) return false;
    }
    return true;
  }

  add({ left, right, low, high }: Patch, x: number, y: number, z: number, r: number): void {
    for (let v = low; v <= high; ++v) {
      // The farthest corner of the cell: where it is within the sphere, so is all of the cell.
      const dy = Math.abs((v + 0.5) * this.cell - this.window.halfHeight - y) + this.halfCell;
      for (let u = left; u <= right; ++u) {
        const dx = Math.abs((u + 0.5) * this.cell - this.window.halfWidth - x) + this.halfCell;
        const inside = r * r - dx * dx - dy * dy;
        if (inside <= 0) continue;
        const depth = z - Math.sqrt(inside);
        if (depth < this.depths[v * this.across + u]!) this.depths[v * this.across + u] = depth;
      }
    }
  }
}

/** Rows that are in the window and not certainly hidden behind others, from front to back. */
export function visibleRows(rows: Uint32Array, { x, y, z, radii }: Turned, window: Window): Uint32Array {
  let largest = 0;
  for (const row of rows) if (radii[row]! > largest) largest = radii[row]!;
  const cover = new Cover(window, Math.max(largest / cellsAcrossRadius, window.pixel));
  const seen = new Uint32Array(rows.length);
  let count = 0;
  for (const row of fromFrontToBack(rows, z)) {
    const r = radii[row]!;
    const patch = cover.patch(x[row]!, y[row]!, r);
    if (cover.hides(patch, z[row]! - r)) continue;
    seen[count++] = row;
    cover.add(patch, x[row]!, y[row]!, z[row]!, r);
  }
  return seen.subarray(0, count);
}
