// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/pages.h"

#include <cstdint>
#include <new>

#include <sys/mman.h>

namespace candelabra {

void* new_pages(bool all) {
    // Twice as much has such a block in it; the rest is given back.
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

}  // namespace candelabra
