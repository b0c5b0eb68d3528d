#include "core/mesh/ids.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "core/mesh/mesh.h"

namespace triscope::ids_test {
namespace {

template <class L, class R>
concept Comparable = requires(L l, R r) { l == r; };
template <class List, class Key>
concept LookedUpBy = requires(List list, Key key) { list[key]; };

// What the types are for: one kind's number is not taken for another's, nor a plain one for any.
static_assert(!std::is_convertible_v<Vertex, Slot> && !std::is_constructible_v<Slot, Vertex>);
static_assert(!std::is_convertible_v<int, Vertex> && !std::is_convertible_v<Vertex, int>);
static_assert(Comparable<Vertex, Vertex> && !Comparable<Vertex, Slot> && !Comparable<Vertex, int>);
using Points = decltype(Mesh::points);
static_assert(LookedUpBy<Points, Vertex> && !LookedUpBy<Points, Slot> && !LookedUpBy<Points, std::size_t>);

// And what they cost.
static_assert(sizeof(Half) == 4 && sizeof(TriangleId) == 4 && std::is_trivially_copyable_v<Half>);
static_assert(sizeof(Triangle) == 24);

TEST(Ids, NoneIsWhatOneIsWithoutANumber) {
  EXPECT_FALSE(Vertex().exists());
  EXPECT_TRUE(Vertex(0).exists());
  EXPECT_FALSE(TriangleId().exists());
  EXPECT_TRUE(TriangleId(0x80000000u).exists()) << "ids go up to all but the last of 32 bits";
  EXPECT_EQ(Vertex().word(), 0xffffffffu) << "as events have it";
  EXPECT_EQ(Vertex(Vertex().word()), Vertex());
  EXPECT_EQ(TriangleId(TriangleId(0xfffffffeu).word()), TriangleId(0xfffffffeu));
}

TEST(Ids, AListKnowsItsKeys) {
  Per<Vertex, int> list;
  EXPECT_FALSE(list.has(Vertex(0)));
  EXPECT_EQ(list.next(), Vertex(0));
  list.push_back(7);
  list.push_back(8);
  EXPECT_TRUE(list.has(Vertex(1)));
  EXPECT_FALSE(list.has(Vertex(2)));
  EXPECT_FALSE(list.has(Vertex()));
  int sum = 0;
  for (const Vertex v : list.keys()) sum += list[v] * (v.n + 1);
  EXPECT_EQ(sum, 7 + 2 * 8);
}

TEST(Ids, AHalfEdgeIsACornerOfASlot) {
  for (const int slot : {0, 1, 5, 715827881})
    for (int corner = 0; corner < 3; ++corner) {
      const Half half = halfOf(Slot(slot), corner);
      EXPECT_EQ(triangleOf(half), Slot(slot));
      EXPECT_EQ(cornerOf(half), corner);
    }
}

}  // namespace
}  // namespace triscope::ids_test
