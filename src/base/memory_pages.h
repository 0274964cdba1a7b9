// SPDX-License-Identifier: GPL-3.0-or-later
// Memory pages of the process: large blocks, huge pages, and returning pages to the system. Used by
// Pool, by the index of boxes and by its builder.
#pragma once

#include <cstddef>

namespace candelabra {

/// The size of a huge page.
inline constexpr std::size_t page_block = std::size_t{1} << 21;

/// Returns a zeroed block of this size, aligned to it. Fetching it page by page on first touch
/// would cost as much as creating its contents. `all` means that most of it will be used: then it
/// is one huge page, if the system has them. Throws std::bad_alloc.
void* new_pages(bool all);
void free_pages(void* block);

/// Returns to the system the memory that the process has freed, by any thread: threads that built
/// something large together may hold on to as much memory as that takes. Inspects all freed memory,
/// so it is only for large things.
void give_back_freed();

/// Moves bytes that are read in random order into huge pages, which makes their addresses faster to
/// translate. Contents are kept. Does nothing if the system has no huge pages.
void use_huge_pages(void* begin, std::size_t bytes);

/// The same for memory that has not been written to: costs nothing until then, and saves
/// use_huge_pages() from moving it.
void expect_huge_pages(void* begin, std::size_t bytes);

}  // namespace candelabra
