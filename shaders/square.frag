#version 330 core
flat in vec4 vFill;
in vec2 vCorner;
uniform vec4 uWire;
uniform float uHalfWidth;  // of the outline, pixels; 0: none
uniform bool uFades;
out vec4 oColor;

void main() {
  float line = 0.0;
  if (uHalfWidth > 0.0) {
    vec2 perPixel = max(fwidth(vCorner), vec2(1e-9));
    vec2 toBorder = min(vCorner, 1.0 - vCorner) / perPixel;
    line = clamp(uHalfWidth + 0.5 - min(toBorder.x, toBorder.y), 0.0, 1.0) * uWire.a;
    if (uFades) line *= clamp((1.0 / max(perPixel.x, perPixel.y) - 1.5) / 6.5, 0.0, 1.0) * 0.78 + 0.22;
  }
  float alpha = line + vFill.a * (1.0 - line);
  if (alpha <= 0.0) discard;
  oColor = vec4((uWire.rgb * line + vFill.rgb * vFill.a * (1.0 - line)) / alpha, alpha);
}
