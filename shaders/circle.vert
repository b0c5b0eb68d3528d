#version 330 core
// One circle: a strip of quads that follows it, so that a large one costs its rim and not its disc.
uniform vec2 uCentre;      // pixels from the middle of the viewport
uniform float uRadius;     // pixels
uniform vec2 uViewport;
uniform float uHalfWidth;
uniform int uSides;
out float vAngle;
out vec2 vFromCentre;

void main() {
  int step = gl_VertexID / 2;
  vAngle = 6.28318531 * float(step) / float(uSides);
  // The strip's chords must enclose the rim's soft edge on both sides.
  float sag = 1.0 / cos(3.14159265 / float(uSides));
  float radius = gl_VertexID % 2 == 0 ? max(uRadius - uHalfWidth - 1.0, 0.0) * (2.0 - sag) : (uRadius + uHalfWidth + 1.0) * sag;
  vFromCentre = radius * vec2(cos(vAngle), sin(vAngle));
  gl_Position = vec4((uCentre + vFromCentre) / (0.5 * uViewport), 0.0, 1.0);
}
