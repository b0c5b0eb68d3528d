#version 330 core
//#include dash.glsl
in vec2 vPlace;
flat in float vLength;
flat in float vStart;
uniform vec4 uColor;
uniform float uHalfWidth;
uniform bool uFades;
out vec4 oColor;

void main() {
  float beyond = max(max(-vPlace.x, vPlace.x - vLength), 0.0);
  float away = length(vec2(beyond, vPlace.y));  // round caps, so that the joints of a polyline close
  float cover = clamp(uHalfWidth + 0.5 - away, 0.0, 1.0) * dashAt(vStart + clamp(vPlace.x, 0.0, vLength));
  if (uFades) cover *= clamp((vLength - 1.5) / 6.5, 0.0, 1.0) * 0.78 + 0.22;
  if (cover <= 0.0) discard;
  oColor = vec4(uColor.rgb, uColor.a * cover);
}
