// A 64-bit digest of values, to tell two contents apart by: multiply-rotate mixing of 64-bit words, the same
// everywhere.
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/index.h"
#include "core/base/point.h"

namespace triscope {

/// The constants are odd with well-spread bits. Lists and texts bring their length, so that none runs into the next.
struct Digest {
  std::uint64_t value = 0x9e3779b97f4a7c15ull;

  void word(std::uint64_t w) {
    value = std::rotl(value ^ (w * 0xbf58476d1ce4e5b9ull), 29) * 0x94d049bb133111ebull;
    value ^= value >> 32;
  }
  void number(double d) { word(std::bit_cast<std::uint64_t>(d)); }
  void point(Point p) {
    number(p.x);
    number(p.y);
  }
  void text(std::string_view letters) {
    word(letters.size());
    for (const char c : letters) word(static_cast<unsigned char>(c));
  }
  template <class T>
  void integers(const std::vector<T>& list) {
    word(list.size());
    for (const T v : list) word(static_cast<std::uint64_t>(v));
  }
  template <class Kind, class Word>
  void integers(const std::vector<Index<Kind, Word>>& list) {
    word(list.size());
    for (const Index<Kind, Word> v : list) word(static_cast<std::uint64_t>(v.n));
  }
  void numbers(const std::vector<double>& list) {
    word(list.size());
    for (const double d : list) number(d);
  }
  void points(const std::vector<Point>& list) {
    word(list.size());
    for (const Point p : list) point(p);
  }
};

}  // namespace triscope
