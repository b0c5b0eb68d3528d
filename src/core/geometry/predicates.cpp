// The exact side of the predicates, in stages: each answers most of what the one before it could not.
//   1. Differences on a common grid of 30 bits (integer input, regular grids): 128-bit integers, exact.
//   2. Pairs of doubles with an error bound of 2^-100 of the permanent: nearly degenerate input.
//   3. Expansions: exactly degenerate input with long mantissas.
#include "core/geometry/predicates.h"

#include <bit>
#include <cstdint>

#include "core/geometry/expansion.h"

namespace triscope::detail {
namespace {

using exact::Expansion;
using exact::fastTwoSum;
using exact::Pair;
using exact::twoDifference;
using exact::twoProduct;
using exact::twoSum;

__extension__ typedef __int128 Int128;

int signOf(double value) { return value > 0.0 ? 1 : (value < 0.0 ? -1 : 0); }

/// x·y with a relative error below 9·2^-106.
Pair times(Pair x, Pair y) {
  const Pair high = twoProduct(x.high, y.high);
  return fastTwoSum(high.high, high.low + (x.high * y.low + x.low * y.high));
}
/// x + y with an error below 4·2^-106·(|x| + |y|).
Pair plus(Pair x, Pair y) {
  const Pair high = twoSum(x.high, y.high);
  return fastTwoSum(high.high, high.low + (x.low + y.low));
}
Pair minus(Pair x, Pair y) { return plus(x, {-y.high, -y.low}); }

/// Bounds the error of stage 2. In the in-circle determinant a minor and a lift are each within 13·2^-106 of the
/// sum of their terms' magnitudes, their product within 35 and the sum of three within 43; 2^-100 is 64 of these
/// and leaves room for the rounding of the permanent.
constexpr double kPairError = 0x1p-100;

/// Splitting a double into halves overflows past 2^996; input that leads there is outside what is promised.
constexpr double kLargestPermanent = 0x1p980;

/// -1, 0 or +1, or kUnknown when the six differences are no integers of 30 bits on a common power-of-two grid.
constexpr int kUnknown = 2;

int incircleOnGrid(const double (&difference)[6]) {
  double largest = 0.0;
  for (const double d : difference) largest = std::fabs(d) > largest ? std::fabs(d) : largest;
  // The power of two that brings the largest difference into [2^29, 2^30).
  const auto exponent = static_cast<int>(std::bit_cast<std::uint64_t>(largest) >> 52);
  const int shifted = 1023 + 29 - (exponent - 1023);
  if (exponent == 0 || shifted <= 0 || shifted >= 2047) return kUnknown;
  const double scale = std::bit_cast<double>(static_cast<std::uint64_t>(shifted) << 52);
  std::int64_t n[6];
  for (int i = 0; i < 6; ++i) {
    const double onGrid = difference[i] * scale;
    if (!(std::fabs(onGrid) <= 0x1p30)) return kUnknown;  // not a number
    n[i] = static_cast<std::int64_t>(onGrid);
    // The second test catches what scaling made vanish.
    if (static_cast<double>(n[i]) != onGrid || (n[i] == 0) != (difference[i] == 0.0)) return kUnknown;
  }
  const auto [ax, ay, bx, by, cx, cy] = n;
  const Int128 det = static_cast<Int128>(ax * ax + ay * ay) * (bx * cy - cx * by) +
                     static_cast<Int128>(bx * bx + by * by) * (cx * ay - ax * cy) +
                     static_cast<Int128>(cx * cx + cy * cy) * (ax * by - bx * ay);
  return det > 0 ? 1 : (det < 0 ? -1 : 0);
}

Pair lift(Pair x, Pair y) { return plus(times(x, x), times(y, y)); }

Expansion<16> minor(const Expansion<2>& ax, const Expansion<2>& ay, const Expansion<2>& bx, const Expansion<2>& by) {
  return ax * by - bx * ay;
}
Expansion<16> lift(const Expansion<2>& x, const Expansion<2>& y) { return x * x + y * y; }

/// Sign of x·y - z·w.
int signOfDifference(Pair x, Pair y, Pair z, Pair w) {
  if (x.low == 0.0 && y.low == 0.0 && z.low == 0.0 && w.low == 0.0) {
    // Rounding is monotone: unequal rounded products order the exact ones, equal ones leave it to the errors.
    const Pair left = twoProduct(x.high, y.high), right = twoProduct(z.high, w.high);
    if (left.high != right.high) return left.high > right.high ? 1 : -1;
    return signOf(left.low - right.low);
  }
  const Pair left = times(x, y), right = times(z, w);
  const Pair det = minus(left, right);
  const double permanent = std::fabs(left.high) + std::fabs(right.high);
  if (std::fabs(det.high) > kPairError * permanent || !(permanent < kLargestPermanent)) return signOf(det.high);
  return (Expansion<2>(x) * Expansion<2>(y) - Expansion<2>(z) * Expansion<2>(w)).sign();
}

}  // namespace

int orient2dExact(Point a, Point b, Point c) {
  return signOfDifference(twoDifference(a.x, c.x), twoDifference(b.y, c.y), twoDifference(a.y, c.y),
                          twoDifference(b.x, c.x));
}

int dotSignExact(Point apex, Point a, Point b) {
  return signOfDifference(twoDifference(a.x, apex.x), twoDifference(b.x, apex.x), twoDifference(apex.y, a.y),
                          twoDifference(b.y, apex.y));
}

int incircleExact(Point a, Point b, Point c, Point d) {
  const Pair ax = twoDifference(a.x, d.x), ay = twoDifference(a.y, d.y);
  const Pair bx = twoDifference(b.x, d.x), by = twoDifference(b.y, d.y);
  const Pair cx = twoDifference(c.x, d.x), cy = twoDifference(c.y, d.y);
  const bool differencesExact =
      ax.low == 0.0 && ay.low == 0.0 && bx.low == 0.0 && by.low == 0.0 && cx.low == 0.0 && cy.low == 0.0;
  if (differencesExact) {
    const int sign = incircleOnGrid({ax.high, ay.high, bx.high, by.high, cx.high, cy.high});
    if (sign != kUnknown) return sign;
  }

  const Pair bc = times(bx, cy), cb = times(cx, by);
  const Pair ca = times(cx, ay), ac = times(ax, cy);
  const Pair ab = times(ax, by), ba = times(bx, ay);
  const Pair aLift = lift(ax, ay), bLift = lift(bx, by), cLift = lift(cx, cy);
  const Pair det = plus(plus(times(aLift, minus(bc, cb)), times(bLift, minus(ca, ac))), times(cLift, minus(ab, ba)));
  const double permanent = (std::fabs(bc.high) + std::fabs(cb.high)) * aLift.high +
                           (std::fabs(ca.high) + std::fabs(ac.high)) * bLift.high +
                           (std::fabs(ab.high) + std::fabs(ba.high)) * cLift.high;
  if (std::fabs(det.high) > kPairError * permanent || !(permanent < kLargestPermanent)) return signOf(det.high);

  const Expansion<2> eax(ax), eay(ay), ebx(bx), eby(by), ecx(cx), ecy(cy);
  const auto byA = minor(ebx, eby, ecx, ecy) * lift(eax, eay);
  const auto byB = minor(ecx, ecy, eax, eay) * lift(ebx, eby);
  const auto byC = minor(eax, eay, ebx, eby) * lift(ecx, ecy);
  return (byA + byB + byC).sign();
}

}  // namespace triscope::detail
