// The allocator of the program, which a sanitizer replaces by its own.
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <new>
#include <vector>

namespace triscope::large_blocks_test {
namespace {

constexpr std::size_t kLargePage = std::size_t{1} << 21;
#ifdef __SANITIZE_ADDRESS__
constexpr bool kOurs = false;
#else
constexpr bool kOurs = true;
#endif

TEST(LargeBlocks, AnArrayThatGrowsKeepsWhatItHolds) {
  std::vector<std::uint32_t> list;
  constexpr std::uint32_t kCount = 3'000'000;  // from a few bytes to 12 MB
  for (std::uint32_t k = 0; k < kCount; ++k) list.push_back(k);
  for (std::uint32_t k = 0; k < kCount; ++k) ASSERT_EQ(list[k], k);
}

TEST(LargeBlocks, LongArraysBeginWithAPage) {
  if (!kOurs) GTEST_SKIP() << "the allocator of a sanitizer";
  for (const std::size_t bytes : {2 * kLargePage, 2 * kLargePage + 1, 5 * kLargePage}) {
    const std::vector<char> list(bytes);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(list.data()) % kLargePage, 0u) << bytes;
  }
}

TEST(LargeBlocks, MoreThanThereIsThrows) {
  if (!kOurs) GTEST_SKIP() << "the allocator of a sanitizer, which ends the program";
  for (const std::size_t bytes : {std::numeric_limits<std::size_t>::max(), std::size_t{1} << 62}) {
    EXPECT_THROW(::operator delete(::operator new(bytes)), std::bad_alloc) << bytes;
  }
}

}  // namespace
}  // namespace triscope::large_blocks_test
