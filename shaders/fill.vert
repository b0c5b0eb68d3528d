#version 330 core
// Triangles, three vertices each and none shared, so that gl_VertexID says which corner this is.
layout(location = 0) in vec2 aPosition;  // world, less the upload origin
layout(location = 1) in vec4 aFill;
uniform mat3x2 uView;  // clip coordinates from (position, 1)
flat out vec4 vFill;
out vec3 vCorner;  // barycentric coordinates

void main() {
  int corner = gl_VertexID % 3;
  vCorner = vec3(corner == 0, corner == 1, corner == 2);
  vFill = aFill;
  gl_Position = vec4(uView * vec3(aPosition, 1.0), 0.0, 1.0);
}
