// Draws spheres, necks and lines with WebGL 2.
import { lineFragment, lineVertex, neckFragment, neckVertex, sphereFragment, sphereVertex } from "./shaders";

export interface Scene {
  spheres: Float32Array; // x, y, z, radius each, turned
  sphereColours: Uint8Array; // r, g, b, 255 each
  necks: Float32Array; // x, y, z, radius, axis x, y, z, half length each, turned
  neckColours: Uint8Array;
  lines: Float32Array; // x, y, z of both ends each, turned
  lineColour: [number, number, number];
  background: [number, number, number]; // 0 to 1
  halfHeight: number; // of the window
  depth: [number, number]; // nearest and farthest z
}

interface Program {
  program: WebGLProgram;
  uniform: (name: string) => WebGLUniformLocation | null;
}

export class Renderer {
  readonly largestPoint: number; // pixels
  private readonly gl: WebGL2RenderingContext;
  private readonly spheres: Program;
  private readonly necks: Program;
  private readonly lines: Program;
  private readonly buffers: WebGLBuffer[];

  /** Throws where there is no WebGL 2. */
  constructor(private readonly canvas: HTMLCanvasElement) {
    const gl = canvas.getContext("webgl2", { antialias: false });
    if (!gl) throw new Error("WebGL 2 is missing");
    this.gl = gl;
    this.largestPoint = (gl.getParameter(gl.ALIASED_POINT_SIZE_RANGE) as Float32Array)[1]!;
    this.spheres = this.build(sphereVertex, sphereFragment);
    this.necks = this.build(neckVertex, neckFragment);
    this.lines = this.build(lineVertex, lineFragment);
    this.buffers = [0, 1, 2, 3, 4].map(() => gl.createBuffer()!);
    gl.enable(gl.DEPTH_TEST);
  }

  draw(scene: Scene): void {
    const { gl, canvas } = this;
    const pixels = canvas.height / (2 * scene.halfHeight);
    // A point is dropped as a whole where its middle is off the viewport: this one reaches beyond the canvas.
    const beyond = Math.ceil(Math.min(this.largestPoint, 1024) / 2);
    const [width, height] = [canvas.width + 2 * beyond, canvas.height + 2 * beyond];
    gl.viewport(-beyond, -beyond, width, height);
    const margin = 0.02 * (scene.depth[1] - scene.depth[0]) + 1e-6;
    const deepest = Math.max(Math.abs(scene.depth[0]), Math.abs(scene.depth[1])) + margin;
    const scale = [(2 * pixels) / width, (2 * pixels) / height, 1 / deepest] as const;
    gl.clearColor(...scene.background, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const use = ({ program, uniform }: Program): void => {
      gl.useProgram(program);
      gl.uniform3f(uniform("scale"), ...scale);
      gl.uniform1f(uniform("pixels"), pixels);
      gl.uniform3f(uniform("background"), ...scene.background);
      gl.uniform2f(uniform("depthRange"), ...scene.depth);
    };
    use(this.spheres);
    this.attribute(0, this.buffers[0]!, scene.spheres, 4, 16, 0);
    this.attribute(1, this.buffers[1]!, scene.sphereColours, 4, 4, 0);
    gl.drawArrays(gl.POINTS, 0, scene.spheres.length / 4);
    use(this.necks);
    this.attribute(0, this.buffers[2]!, scene.necks, 4, 32, 0);
    gl.enableVertexAttribArray(1);
    gl.vertexAttribPointer(1, 4, gl.FLOAT, false, 32, 16);
    this.attribute(2, this.buffers[3]!, scene.neckColours, 4, 4, 0);
    gl.drawArrays(gl.POINTS, 0, scene.necks.length / 8);
    gl.disableVertexAttribArray(1);
    gl.disableVertexAttribArray(2);
    use(this.lines);
    gl.uniform3f(this.lines.uniform("tint"), ...scene.lineColour);
    this.attribute(0, this.buffers[4]!, scene.lines, 3, 12, 0);
    gl.drawArrays(gl.LINES, 0, scene.lines.length / 3);
  }

  /** Waits until all is drawn, for measuring. */
  finish(): void {
    this.gl.readPixels(0, 0, 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  private attribute(
    place: number,
    buffer: WebGLBuffer,
    values: Float32Array | Uint8Array,
    size: number,
    stride: number,
    offset: number,
  ): void {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.STREAM_DRAW);
    gl.enableVertexAttribArray(place);
    const bytes = values instanceof Uint8Array;
    gl.vertexAttribPointer(place, size, bytes ? gl.UNSIGNED_BYTE : gl.FLOAT, bytes, stride, offset);
  }

  private build(vertex: string, fragment: string): Program {
    const { gl } = this;
    const program = gl.createProgram()!;
    for (const [kind, source] of [
      [gl.VERTEX_SHADER, vertex],
      [gl.FRAGMENT_SHADER, fragment],
    ] as const) {
      const shader = gl.createShader(kind)!;
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
      throw new Error(`a shader failed: ${gl.getProgramInfoLog(program)}`);
    const places = new Map<string, WebGLUniformLocation | null>();
    const uniform = (name: string): WebGLUniformLocation | null => {
      if (!places.has(name)) places.set(name, gl.getUniformLocation(program, name));
      return places.get(name)!;
    };
    return { program, uniform };
  }
}
