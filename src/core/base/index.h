// Numbers that count things of one kind, of their own type: a vertex's is not taken for a triangle's.
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace triscope {

/// The number of one of the things of a kind, from 0; made without a number, it is that of none. `Kind` is but a name.
template <class Kind, class Word = std::int32_t>
struct Index {
  Word n = static_cast<Word>(-1);

  constexpr Index() = default;
  template <std::integral Number>
  constexpr explicit Index(Number number) : n(static_cast<Word>(number)) {}

  [[nodiscard]] constexpr bool exists() const {
    if constexpr (std::signed_integral<Word>) return n >= 0;
    return n != static_cast<Word>(-1);
  }
  /// As events and files have it: none is the largest number there is.
  [[nodiscard]] constexpr std::uint32_t word() const { return static_cast<std::uint32_t>(n); }
  constexpr Index& operator++() {
    ++n;
    return *this;
  }
  constexpr Index operator++(int) { return Index(n++); }
  friend constexpr auto operator<=>(Index, Index) = default;
};

/// All numbers of things of a kind, from the first to that before the last.
template <class Key>
struct Keys {
  struct Iterator {
    Key key;
    constexpr Key operator*() const { return key; }
    constexpr Iterator& operator++() {
      ++key;
      return *this;
    }
    friend constexpr bool operator==(Iterator, Iterator) = default;
  };
  Key first;
  Key last;
  [[nodiscard]] constexpr Iterator begin() const { return {first}; }
  [[nodiscard]] constexpr Iterator end() const { return {last}; }
};

/// A list with one value for each thing of a kind, looked up by the thing's number.
template <class Key, class Value>
struct Per : std::vector<Value> {
  using List = std::vector<Value>;
  using List::List;

  [[nodiscard]] Value& operator[](Key key) { return List::operator[](static_cast<std::size_t>(key.n)); }
  [[nodiscard]] const Value& operator[](Key key) const { return List::operator[](static_cast<std::size_t>(key.n)); }
  [[nodiscard]] bool has(Key key) const { return key.n >= 0 && static_cast<std::size_t>(key.n) < List::size(); }
  [[nodiscard]] Keys<Key> keys() const { return {Key(0), next()}; }
  /// The number that a value put behind the others gets.
  [[nodiscard]] Key next() const { return Key(List::size()); }
};

}  // namespace triscope
