#version 330 core
//#include dash.glsl
in float vAngle;
in vec2 vFromCentre;
uniform vec4 uColor;
uniform float uRadius;
uniform float uHalfWidth;
out vec4 oColor;

void main() {
  float away = abs(length(vFromCentre) - uRadius);
  float cover = clamp(uHalfWidth + 0.5 - away, 0.0, 1.0) * dashAt(vAngle * uRadius);
  if (cover <= 0.0) discard;
  oColor = vec4(uColor.rgb, uColor.a * cover);
}
