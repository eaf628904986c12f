// The program's memory: large arrays get large pages (geom/large_pages.h). Reading a file, building
// and updating a model fill hundreds of megabytes once, and each page fault costs as much as
// writing the page; so half of the time in the operating system goes. The program alone does this:
// a library has no business with the allocator of others.
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

#include "geom/large_pages.h"

namespace {

constexpr std::size_t large_page = std::size_t{1} << 21;
constexpr std::size_t large_array = 2 * large_page;

void* allocate(std::size_t bytes, std::size_t alignment) {
  const bool is_large = bytes >= large_array;
  if (is_large) alignment = std::max(alignment, large_page);
  // aligned_alloc wants a multiple; an overflow is more than there can be.
  const std::size_t rounded =
      (std::max<std::size_t>(bytes, 1) + alignment - 1) / alignment * alignment;
  if (rounded < bytes) throw std::bad_alloc();
  for (;;) {
    void* const memory = std::aligned_alloc(alignment, rounded);
    if (memory != nullptr) {
      if (is_large) cocoon::prefer_large_pages(memory, bytes);
      return memory;
    }
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

}  // namespace

void* operator new(std::size_t bytes) { return allocate(bytes, alignof(std::max_align_t)); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return allocate(bytes, std::max(alignof(std::max_align_t), static_cast<std::size_t>(alignment)));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
