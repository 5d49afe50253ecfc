// Spheres and necks as points: a square on the screen each, in which the fragment shader meets the surface exactly.
// Points, not instanced squares: SwiftShader draws them ten times faster. The projection is parallel, so that sizes can be
// compared and the scale bar holds everywhere.

const common = `#version 300 es
precision highp float;
`;

const shade = `
uniform vec3 background;
uniform vec2 depthRange; // nearest and farthest of the packing
vec3 shade(vec3 colour, vec3 normal, float depth) {
  float light = 0.42 + 0.5 * max(0.0, dot(normal, normalize(vec3(-0.35, 0.55, 0.75)))) + 0.12 * normal.y;
  float far = clamp((depth - depthRange.x) / (depthRange.y - depthRange.x), 0.0, 1.0);
  return mix(colour * light, background, 0.45 * far * far);
}
`;

// Places come already turned: x right, y up, z away from the eye; `scale` takes them to the clip space.
export const sphereVertex = `${common}
layout(location = 0) in vec4 sphere; // place and radius
layout(location = 1) in vec4 colour;
uniform vec3 scale;
uniform float pixels; // a unit of length on the screen
flat out vec4 body;
flat out vec3 tint;
void main() {
  body = sphere;
  tint = colour.rgb;
  gl_Position = vec4(sphere.xyz * scale, 1.0);
  gl_PointSize = 2.0 * sphere.w * pixels + 1.0;
}`;

export const sphereFragment = `${common}
flat in vec4 body;
flat in vec3 tint;
uniform vec3 scale;
uniform float pixels;
out vec4 result;
${shade}
void main() {
  vec2 across = (gl_PointCoord - 0.5) * vec2(2.0, -2.0) * (1.0 + 0.5 / (body.w * pixels));
  float squared = dot(across, across);
  if (squared > 1.0) discard;
  float up = sqrt(1.0 - squared);
  float depth = body.z - up * body.w;
  gl_FragDepth = 0.5 + 0.5 * depth * scale.z;
  float rim = 1.0 - 0.55 * smoothstep(1.0 - 3.0 / (body.w * pixels + 3.0), 1.0, squared);
  result = vec4(shade(tint, vec3(across, up), depth) * rim, 1.0);
}`;

export const neckVertex = `${common}
layout(location = 0) in vec4 place; // middle and radius
layout(location = 1) in vec4 axis;  // unit vector and half length
layout(location = 2) in vec4 colour;
uniform vec3 scale;
uniform float pixels;
flat out vec4 body;
flat out vec4 along;
flat out vec3 tint;
flat out float size;
void main() {
  body = place;
  along = axis;
  tint = colour.rgb;
  size = length(vec2(place.w, axis.w));
  gl_Position = vec4(place.xyz * scale, 1.0);
  gl_PointSize = 2.0 * size * pixels + 1.0;
}`;

// A line of sight through the lateral surface or a flat end of a cylinder.
export const neckFragment = `${common}
flat in vec4 body;
flat in vec4 along;
flat in vec3 tint;
flat in float size;
uniform vec3 scale;
out vec4 result;
${shade}
void main() {
  vec3 eye = vec3((gl_PointCoord - 0.5) * vec2(2.0, -2.0) * size, 0.0);
  vec3 ray = vec3(0.0, 0.0, 1.0);
  vec3 axis = along.xyz;
  vec3 d = ray - axis * axis.z;
  vec3 o = eye - axis * dot(eye, axis);
  float a = dot(d, d), b = dot(d, o), c = dot(o, o) - body.w * body.w;
  float root = b * b - a * c;
  float t = 1e9;
  vec3 normal = vec3(0.0, 0.0, -1.0);
  if (a > 1e-9 && root >= 0.0) {
    float side = (-b - sqrt(root)) / a;
    if (abs(dot(eye + side * ray, axis)) <= along.w) {
      t = side;
      normal = (o + side * d) / body.w;
    }
  }
  if (abs(axis.z) > 1e-6) {
    float face = (-sign(axis.z) * along.w - dot(eye, axis)) / axis.z;
    vec3 off = o + face * d;
    if (face < t && dot(off, off) <= body.w * body.w) {
      t = face;
      normal = -sign(axis.z) * axis;
    }
  }
  if (t > 1e8) discard;
  float depth = body.z + t;
  gl_FragDepth = 0.5 + 0.5 * depth * scale.z;
  result = vec4(shade(tint, vec3(normal.xy, -normal.z), depth), 1.0);
}`;

export const lineVertex = `${common}
layout(location = 0) in vec3 place;
uniform vec3 scale;
void main() { gl_Position = vec4(place * scale, 1.0); }`;

export const lineFragment = `${common}
uniform vec3 tint;
out vec4 result;
void main() { result = vec4(tint, 1.0); }`;
