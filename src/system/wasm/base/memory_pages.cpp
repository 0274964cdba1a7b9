// SPDX-License-Identifier: GPL-3.0-or-later
// The memory of WebAssembly has no pages that could be advised about, and never shrinks.
#include "base/memory_pages.h"

#include <cstdlib>
#include <cstring>
#include <new>

namespace candelabra {

void* new_pages(bool) {
    void* const block = std::aligned_alloc(page_block, page_block);
    if (!block) throw std::bad_alloc();
    return std::memset(block, 0, page_block);
}

void free_pages(void* block) { std::free(block); }
void expect_huge_pages(void*, std::size_t) {}
void use_huge_pages(void*, std::size_t) {}
void give_back_freed() {}

}  // namespace candelabra
