// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/memory_pages.h"

#include <cstdint>
#include <new>

#include <sys/mman.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace candelabra {

namespace {

/// MADV_COLLAPSE of Linux 6.1 and later, which older headers do not define.
constexpr int collapse = 25;

/// Advises the system about the whole pages among the bytes.
void advise(void* begin, std::size_t bytes, std::uintptr_t page, int advice) {
    const auto first = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t from = (first + page - 1) & ~(page - 1);
    const std::uintptr_t to = (first + bytes) & ~(page - 1);
    if (from < to) madvise(reinterpret_cast<void*>(from), to - from, advice);
}

}  // namespace

void* new_pages(bool all) {
    // Twice the size certainly contains an aligned block; the rest is unmapped.
    void* const found = mmap(nullptr, 2 * page_block, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (found == MAP_FAILED) throw std::bad_alloc();
    const auto begin = reinterpret_cast<std::uintptr_t>(found);
    const std::uintptr_t block = (begin + page_block - 1) & ~(page_block - 1);
    const std::size_t before = block - begin;
    if (before > 0) munmap(found, before);
    munmap(reinterpret_cast<void*>(block + page_block), page_block - before);
    void* const result = reinterpret_cast<void*>(block);
    if (all) madvise(result, page_block, MADV_HUGEPAGE);
    return result;
}

void free_pages(void* block) { munmap(block, page_block); }

void expect_huge_pages(void* begin, std::size_t bytes) {
    advise(begin, bytes, page_block, MADV_HUGEPAGE);
}

void use_huge_pages(void* begin, std::size_t bytes) {
    expect_huge_pages(begin, bytes);
    advise(begin, bytes, page_block, collapse);  // at once, instead of in the background
}

void give_back_freed() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

}  // namespace candelabra
