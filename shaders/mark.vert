#version 330 core
layout(location = 0) in vec2 aPosition;  // world, less the upload origin
layout(location = 1) in float aSpacing;  // world distance to the next mark; 0: never shrink
uniform mat3x2 uView;
uniform float uSize;           // pixels across, without the outline
uniform float uSmallest;       // pixels
uniform float uPixelsPerUnit;
flat out float vSize;
flat out float vShrunk;  // part of its full size

void main() {
  gl_Position = vec4(uView * vec3(aPosition, 1.0), 0.0, 1.0);
  // As markSize() in render/scene.h.
  float room = 0.6 * aSpacing * uPixelsPerUnit;
  vSize = aSpacing > 0.0 ? clamp(room, uSmallest, uSize) : uSize;
  vShrunk = vSize / uSize;
  gl_PointSize = vSize + 4.0;  // room for the outline and the soft edge
}
