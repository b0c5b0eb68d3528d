// Exact sums and products of doubles as expansions: a number held as the unevaluated sum of components that do
// not overlap, smallest magnitude first, none of them zero (J. R. Shewchuk, "Adaptive Precision Floating-Point
// Arithmetic and Fast Robust Geometric Predicates", 1997; T. J. Dekker, "A Floating-Point Technique for
// Extending the Available Precision", 1971). Exact as long as nothing overflows or underflows.
// Needs round-to-nearest-even and no contraction into fused multiply-add.
#pragma once

#include <cmath>

namespace triscope::exact {

/// A number as `high + low`, high being the sum rounded to a double.
struct Pair {
  double high = 0.0;
  double low = 0.0;
};

inline Pair twoSum(double a, double b) {
  const double sum = a + b;
  const double bPart = sum - a;
  const double aPart = sum - bPart;
  return {sum, (a - aPart) + (b - bPart)};
}

/// As twoSum, for |a| >= |b| or a == 0.
inline Pair fastTwoSum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

inline Pair twoDifference(double a, double b) {
  const double difference = a - b;
  const double bPart = a - difference;
  const double aPart = difference + bPart;
  return {difference, (a - aPart) + (bPart - b)};
}

/// a as the sum of two halves of at most 26 significant bits each.
inline Pair split(double a) {
  const double scaled = 134217729.0 * a;  // 2^27 + 1
  const double high = scaled - (scaled - a);
  return {high, a - high};
}

inline Pair twoProduct(double a, Pair aHalves, double b, Pair bHalves) {
  const double product = a * b;
  const double rest =
      ((aHalves.high * bHalves.high - product) + aHalves.high * bHalves.low) + aHalves.low * bHalves.high;
  return {product, rest + aHalves.low * bHalves.low};
}
inline Pair twoProduct(double a, double b) { return twoProduct(a, split(a), b, split(b)); }

/// An expansion of at most N components; what lies past `size` is not initialised.
template <int N>
struct Expansion {
  static constexpr int capacity = N;
  int size = 0;
  double part[N];  // NOLINT: left uninitialised on purpose

  Expansion() {}  // NOLINT(modernize-use-equals-default): must not clear `part`
  explicit Expansion(Pair pair)
    requires(N >= 2)
  {
    append(pair.low);
    append(pair.high);
  }
  void append(double value) {
    if (value != 0.0) part[size++] = value;
  }
  /// The sign of the whole is that of the largest component.
  [[nodiscard]] int sign() const { return size == 0 ? 0 : (part[size - 1] > 0.0 ? 1 : -1); }
  /// Nearest double but for an error of one unit in the last place.
  [[nodiscard]] double estimate() const {
    double sum = 0.0;
    for (int i = 0; i < size; ++i) sum += part[i];
    return sum;
  }
};

/// e + f, or e - f with `sign` -1, into h, which is neither and has room for e.size + f.size components:
/// all are merged by magnitude, then carried upwards.
template <int M, int N, int H>
void addInto(const Expansion<M>& e, const Expansion<N>& f, double sign, Expansion<H>& h) {
  h.size = 0;
  double carry = 0.0;
  int i = 0;
  int j = 0;
  while (i < e.size || j < f.size) {
    const bool fromE = j == f.size || (i < e.size && std::fabs(e.part[i]) < std::fabs(f.part[j]));
    const Pair sum = twoSum(carry, fromE ? e.part[i++] : sign * f.part[j++]);
    h.append(sum.low);
    carry = sum.high;
  }
  h.append(carry);
}

template <int M, int N>
Expansion<M + N> operator+(const Expansion<M>& e, const Expansion<N>& f) {
  Expansion<M + N> h;
  addInto(e, f, 1.0, h);
  return h;
}

template <int M, int N>
Expansion<M + N> operator-(const Expansion<M>& e, const Expansion<N>& f) {
  Expansion<M + N> h;
  addInto(e, f, -1.0, h);
  return h;
}

template <int N>
Expansion<2 * N> scaled(const Expansion<N>& e, double factor) {
  Expansion<2 * N> h;
  if (e.size == 0) return h;
  const Pair halves = split(factor);
  const Pair first = twoProduct(e.part[0], split(e.part[0]), factor, halves);
  h.append(first.low);
  double carry = first.high;
  for (int i = 1; i < e.size; ++i) {
    const Pair product = twoProduct(e.part[i], split(e.part[i]), factor, halves);
    const Pair sum = twoSum(carry, product.low);
    h.append(sum.low);
    const Pair top = fastTwoSum(product.high, sum.high);
    h.append(top.low);
    carry = top.high;
  }
  h.append(carry);
  return h;
}

template <int M, int N>
Expansion<2 * M * N> operator*(const Expansion<M>& e, const Expansion<N>& f) {
  // Two buffers by turns, so that no step copies a long array.
  Expansion<2 * M * N> even;
  Expansion<2 * M * N> odd;
  for (int j = 0; j < f.size; ++j) {
    const auto row = scaled(e, f.part[j]);
    if ((j & 1) == 0) {
      addInto(even, row, 1.0, odd);
    } else {
      addInto(odd, row, 1.0, even);
    }
  }
  return (f.size & 1) == 0 ? even : odd;
}

}  // namespace triscope::exact
