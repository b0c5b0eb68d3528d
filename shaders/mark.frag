#version 330 core
// Shapes by their distance function; the order is that of triscope::Shape.
flat in float vSize;    // pixels across
flat in float vShrunk;  // part of its full size
uniform int uShape;
uniform vec4 uFill;
uniform vec4 uOutline;
uniform float uStroke;  // pixels: width of a ring, a cross and the outline of a mark at full size
out vec4 oColor;

float distanceTo(vec2 p, float r, float stroke) {
  if (uShape == 1) return (abs(p.x) + abs(p.y) - r * 1.15) * 0.70710678;
  if (uShape == 2) return max(abs(p.x), abs(p.y)) - r * 0.88;
  if (uShape == 3) return max(abs(p.x) * 0.8660254 - p.y * 0.5, p.y) - r * 0.62;
  if (uShape == 4) return abs(length(p) - r + 0.5 * stroke) - 0.5 * stroke;
  if (uShape == 5) {
    vec2 q = abs(vec2(p.x + p.y, p.x - p.y) * 0.70710678);
    return max(min(q.x, q.y) - 0.5 * stroke, max(q.x, q.y) - r);
  }
  return length(p) - r;
}

void main() {
  vec2 p = (gl_PointCoord - 0.5) * (vSize + 4.0);  // y points down
  float stroke = uStroke * vShrunk;
  float d = distanceTo(p, 0.5 * vSize, max(stroke, 0.8));
  float inside = clamp(0.5 - d, 0.0, 1.0);
  float covered = clamp(0.5 - d + (uOutline.a > 0.0 ? stroke : 0.0), 0.0, 1.0);
  if (covered <= 0.0) discard;
  vec4 color = mix(uOutline, uFill, uOutline.a > 0.0 ? inside : 1.0);
  oColor = vec4(color.rgb, color.a * covered);
}
