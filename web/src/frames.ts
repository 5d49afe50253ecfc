// Decodes the particles and necks of each snapshot; each frame builds on the one before (src/report/frame_packer.cpp).
import { bytesOf } from "./runs";
import type { Field, Packing } from "./types";

export interface Frame {
  places: Float32Array; // x, y, z each, relative to the middle of the box, in mean radii
  radii: Float32Array; // in mean radii
  codes: Uint8Array[]; // one list a field
  box: [number, number, number]; // edges in mean radii
  neckEnds: Uint32Array; // i, j each
  neckRatios: Uint8Array; // 254 times r/R
}

/** The value that a code stands for; NaN for none. */
export function decode(field: Field, code: number): number {
  if (code === 255) return NaN;
  const part = code / 254;
  return field.least + (field.most - field.least) * (field.square ? part * part : part);
}

async function inflate(bytes: Uint8Array): Promise<Uint8Array> {
  const stream = new Blob([bytes as BlobPart]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

class Reader {
  private at = 0;
  constructor(private readonly bytes: Uint8Array) {}

  take(count: number): Uint8Array {
    this.at += count;
    return this.bytes.subarray(this.at - count, this.at);
  }

  planes(count: number): [Uint8Array, Uint8Array] {
    return [this.take(count), this.take(count)];
  }

  varint(): number {
    let value = 0;
    let factor = 1;
    for (;;) {
      const byte = this.bytes[this.at++]!;
      value += (byte & 127) * factor;
      if (byte < 128) return value;
      factor *= 128;
    }
  }
}

/** The frames of a run, decoded in their order and kept. */
export class Frames {
  private readonly done: Promise<Frame>[] = [];
  private readonly last: Uint16Array[];

  constructor(
    private readonly packing: Packing,
    private readonly run: number,
  ) {
    this.last = [0, 1, 2].map(() => new Uint16Array(packing.count));
  }

  get(index: number): Promise<Frame> {
    for (let n = this.done.length; n <= index; ++n) {
      const before = this.done[n - 1] ?? Promise.resolve();
      const text = document.getElementById(`frame-${this.run}-${n}`)!.textContent!;
      this.done.push(before.then(async () => this.unpack(n, await inflate(bytesOf(text)))));
    }
    return this.done[index]!;
  }

  private unpack(index: number, bytes: Uint8Array): Frame {
    const { count, mean_radius, largest_radius, fields } = this.packing;
    const info = this.packing.frames[index]!;
    const reader = new Reader(bytes);
    const box = info.size.map((size) => size / mean_radius) as [number, number, number];
    const places = new Float32Array(3 * count);
    for (let axis = 0; axis < 3; ++axis)
      this.unpackAxis(reader, axis, box[axis]! / (info.periodic ? 65536 : 65535), box[axis]! / 2, places);
    const [low, high] = reader.planes(count);
    const radii = new Float32Array(count);
    for (let n = 0; n < count; ++n) radii[n] = ((low[n]! | (high[n]! << 8)) / 65535) * (largest_radius / mean_radius);
    const codes = fields.map(() => reader.take(count));
    const neckEnds = new Uint32Array(2 * info.necks);
    let i = 0;
    for (let k = 0; k < info.necks; ++k) {
      i += reader.varint();
      const zigzag = reader.varint();
      neckEnds[2 * k] = i;
      neckEnds[2 * k + 1] = i + (zigzag % 2 ? -(zigzag + 1) / 2 : zigzag / 2);
    }
    return { places, radii, codes, box, neckEnds, neckRatios: reader.take(info.necks) };
  }

  private unpackAxis(reader: Reader, axis: number, step: number, middle: number, places: Float32Array): void {
    const last = this.last[axis]!;
    const [low, high] = reader.planes(last.length);
    for (let n = 0; n < last.length; ++n) {
      last[n] = last[n]! + (low[n]! | (high[n]! << 8)); // 16 bits wrap, as the cell does
      places[3 * n + axis] = last[n]! * step - middle;
    }
  }
}
