#version 330 core
// Fill and edges of a triangle in one pass: every triangle draws the half of each edge that lies in it.
flat in vec4 vFill;
in vec3 vCorner;
uniform vec4 uWire;
uniform float uHalfWidth;     // of an edge, pixels; 0: no edges
uniform bool uFades;          // edges a few pixels long turn into shading
uniform float uHatchSpacing;  // pixels between diagonal stripes; 0: solid
out vec4 oColor;

// As wireFade() in render/scene.h.
vec3 fadeOf(vec3 lengths) {
  return clamp((lengths - 1.5) / 6.5, 0.0, 1.0) * 0.78 + 0.22;
}

void main() {
  vec4 fill = vFill;
  if (uHatchSpacing > 0.0) {
    float along = (gl_FragCoord.x + gl_FragCoord.y) * 0.70710678;
    float offset = abs(fract(along / uHatchSpacing) - 0.5) * uHatchSpacing;
    fill.a *= clamp(uHatchSpacing * 0.14 + 0.5 - offset, 0.0, 1.0);
  }
  float line = 0.0;
  if (uHalfWidth > 0.0) {
    vec3 dx = dFdx(vCorner), dy = dFdy(vCorner);
    vec3 slope = sqrt(dx * dx + dy * dy);  // 1 / height over each edge, per pixel
    vec3 cover = clamp(uHalfWidth + 0.5 - vCorner / max(slope, 1e-9), 0.0, 1.0);
    if (uFades) {
      float turn = abs(dx.x * dy.y - dx.y * dy.x);  // 1 / (2 area)
      cover *= fadeOf(slope / max(turn, 1e-12));
    }
    line = max(cover.x, max(cover.y, cover.z)) * uWire.a;
  }
  float alpha = line + fill.a * (1.0 - line);
  if (alpha <= 0.0) discard;
  oColor = vec4((uWire.rgb * line + fill.rgb * fill.a * (1.0 - line)) / alpha, alpha);
}
