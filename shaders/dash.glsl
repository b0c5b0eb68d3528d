// How much of a dashed line is there at `along` pixels: 1 in a dash, 0 in a gap, soft in between.
uniform vec4 uDash;      // lengths in pixels: on, off, on, off
uniform int uDashCount;  // of these, how many are used; 0: solid

float dashAt(float along) {
  if (uDashCount == 0) return 1.0;
  float period = uDash.x + uDash.y + (uDashCount > 2 ? uDash.z + uDash.w : 0.0);
  float place = mod(along, period);
  float inFirst = min(max(uDash.x * 0.5 + 0.5 - abs(place - uDash.x * 0.5), 0.0), 1.0);
  float wrapped = clamp(0.5 - (period - place), 0.0, 1.0);
  float inSecond = 0.0;
  if (uDashCount > 2) {
    float middle = uDash.x + uDash.y + uDash.z * 0.5;
    inSecond = clamp(uDash.z * 0.5 + 0.5 - abs(place - middle), 0.0, 1.0);
  }
  return max(max(inFirst, wrapped), inSecond);
}
