#version 330 core
// Axis-aligned squares, four vertices each.
layout(location = 0) in vec2 aPosition;  // world, less the upload origin
layout(location = 1) in vec4 aFill;
uniform mat3x2 uView;
flat out vec4 vFill;
out vec2 vCorner;  // (0, 0) lower left … (1, 1) upper right

void main() {
  int corner = gl_VertexID % 4;
  vCorner = vec2(corner == 1 || corner == 2, corner >= 2);
  vFill = aFill;
  gl_Position = vec4(uView * vec3(aPosition, 1.0), 0.0, 1.0);
}
