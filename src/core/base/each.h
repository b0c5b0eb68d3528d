// A table with one value for each of a few things that an enumeration names.
#pragma once

#include <array>
#include <cstddef>

namespace triscope {

template <class Name, class Value, std::size_t Count>
struct Each : std::array<Value, Count> {
  using Table = std::array<Value, Count>;
  using Table::operator[];

  [[nodiscard]] constexpr Value& operator[](Name name) { return Table::operator[](static_cast<std::size_t>(name)); }
  [[nodiscard]] constexpr const Value& operator[](Name name) const {
    return Table::operator[](static_cast<std::size_t>(name));
  }
};

}  // namespace triscope
