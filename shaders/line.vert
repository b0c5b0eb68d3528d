#version 330 core
// Line segments as quads of four vertices, a pixel wider than the line for its soft edge.
layout(location = 0) in vec2 aFrom;  // world, less the upload origin
layout(location = 1) in vec2 aTo;
layout(location = 2) in float aAlong;  // world length of the polyline before aFrom
uniform mat3x2 uView;
uniform vec2 uViewport;       // pixels
uniform float uPixelsPerUnit;
uniform float uHalfWidth;     // pixels
out vec2 vPlace;              // pixels along and across, from aFrom
flat out float vLength;       // pixels
flat out float vStart;        // pixels along the polyline at aFrom

void main() {
  vec2 toPixels = 0.5 * uViewport;
  vec2 from = uView * vec3(aFrom, 1.0) * toPixels;
  vec2 to = uView * vec3(aTo, 1.0) * toPixels;
  vec2 along = to - from;
  vLength = length(along);
  vec2 direction = vLength > 1e-6 ? along / vLength : vec2(1.0, 0.0);
  vec2 normal = vec2(-direction.y, direction.x);
  float reach = uHalfWidth + 1.0;
  int corner = gl_VertexID % 4;
  vPlace.x = corner == 1 || corner == 2 ? vLength + reach : -reach;
  vPlace.y = corner >= 2 ? reach : -reach;
  vStart = aAlong * uPixelsPerUnit;
  gl_Position = vec4((from + direction * vPlace.x + normal * vPlace.y) / toPixels, 0.0, 1.0);
}
