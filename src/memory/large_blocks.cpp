// Long arrays in large pages of memory, where the system has them. A mesh of a million triangles that is read here and
// there has more small pages than the processor can look up at once; in large ones it is made in some 0.8 of the time.
//
// The program's operator new, since arrays of every part grow long: cells, triangles, text. Not under a sanitizer,
// which has its own.
#include <cstdlib>
#include <memory>
#include <new>

#ifdef __linux__
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace {

constexpr std::size_t kLargePage = std::size_t{1} << 21;  // of x86-64, and of most others
constexpr std::size_t kLargeBlock = 2 * kLargePage;       // from here on: less than a third of it is lost

void* largeBlock(std::size_t size) {
  const std::size_t whole = (size + kLargePage - 1) & ~(kLargePage - 1);
  void* const block = whole >= size ? std::aligned_alloc(kLargePage, whole) : nullptr;
#ifdef __linux__
  if (block != nullptr) static_cast<void>(madvise(block, whole, MADV_HUGEPAGE));  // refused: only slower
#endif
  return block;
}

#ifdef __GLIBC__
/// What is shorter lies in the heap. It is asked for in one piece, of which only what is touched becomes memory, and
/// what is freed stays in it: to give pages back and to be given them anew costs more than to make the mesh in them.
const bool heapIsLarge = [] {
  constexpr int kHeap = 64 << 20;
  mallopt(M_MMAP_THRESHOLD, static_cast<int>(kLargeBlock));
  mallopt(M_TRIM_THRESHOLD, kHeap);
  mallopt(M_TOP_PAD, kHeap);
  void* const first = std::malloc(kLargePage / 2);  // the heap grows to hold it
  void* begin = first;
  auto room = static_cast<std::size_t>(static_cast<char*>(sbrk(0)) - static_cast<char*>(first));
  const bool large = std::align(kLargePage, kLargePage, begin, room) != nullptr &&
                     madvise(begin, room & ~(kLargePage - 1), MADV_HUGEPAGE) == 0;
  std::free(first);
  return large;
}();
#endif

}  // namespace

void* operator new(std::size_t size) {
  for (;;) {
    void* const block = size >= kLargeBlock ? largeBlock(size) : std::malloc(size > 0 ? size : 1);
    if (block != nullptr) return block;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
