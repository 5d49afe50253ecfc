// How a packing is looked at: a rotation, a zoom and a shift, in parallel projection.

export type Matrix = [number, number, number, number, number, number, number, number, number]; // rows

export class Camera {
  turn: Matrix = start();
  zoom = 1;
  shiftX = 0; // of the middle on the screen, in units of length
  shiftY = 0;

  reset(): void {
    this.turn = start();
    this.zoom = 1;
    this.shiftX = this.shiftY = 0;
  }

  /** Turns about axes of the screen [rad]. */
  rotate(right: number, down: number): void {
    const [cr, sr, cd, sd] = [Math.cos(right), Math.sin(right), Math.cos(down), Math.sin(down)];
    const aboutY: Matrix = [cr, 0, -sr, 0, 1, 0, sr, 0, cr];
    const aboutX: Matrix = [1, 0, 0, 0, cd, sd, 0, -sd, cd];
    this.turn = orthonormal(multiply(aboutX, multiply(aboutY, this.turn)));
  }
}

const start = (): Matrix => {
  // From the front, a little from the right and above; z of the packing is up.
  const [a, b] = [-0.55, 0.42];
  const [ca, sa, cb, sb] = [Math.cos(a), Math.sin(a), Math.cos(b), Math.sin(b)];
  const flat: Matrix = [ca, sa, 0, 0, 0, 1, -sa, ca, 0];
  return multiply([1, 0, 0, 0, cb, sb, 0, -sb, cb], flat);
};

export function multiply(a: Matrix, b: Matrix): Matrix {
  const c = new Array<number>(9).fill(0) as Matrix;
  for (let row = 0; row < 3; ++row) {
    for (let col = 0; col < 3; ++col) {
      c[3 * row + col] = a[3 * row]! * b[col]! + a[3 * row + 1]! * b[3 + col]! + a[3 * row + 2]! * b[6 + col]!;
    }
  }
  return c;
}

// Many small turns add up rounding errors; rows are made perpendicular again.
function orthonormal(m: Matrix): Matrix {
  const x = unit([m[0], m[1], m[2]]);
  const along = m[3] * x[0] + m[4] * x[1] + m[5] * x[2];
  const y = unit([m[3] - along * x[0], m[4] - along * x[1], m[5] - along * x[2]]);
  // Away from the eye: x, y and this are left-handed.
  return [...x, ...y, x[2] * y[1] - x[1] * y[2], x[0] * y[2] - x[2] * y[0], x[1] * y[0] - x[0] * y[1]];
}

function unit(v: [number, number, number]): [number, number, number] {
  const length = Math.hypot(...v);
  return [v[0] / length, v[1] / length, v[2] / length];
}
