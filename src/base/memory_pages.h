// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of the process's memory: large blocks of them, huge pages, and pages that go back to the
// system. Called by Pool, by the index of boxes and by its builder.
#pragma once

#include <cstddef>

namespace candelabra {

/// The size of a huge page.
inline constexpr std::size_t page_block = std::size_t{1} << 21;

/// A block of that size, at a multiple of it, all zero. To get it page by page, as it is touched,
/// would cost as much as to make what is put there. `all` says that most of it will be used: it is
/// then one huge page, where the system has them. Throws std::bad_alloc.
void* new_pages(bool all);
void free_pages(void* block);

/// Gives back to the system what the process has freed, whichever thread used it: threads that
/// built something large together may keep as much as that takes. It looks at all that was freed,
/// so it is for large things only.
void give_back_freed();

/// Puts bytes that are read in no order into huge pages: their addresses are then found sooner.
/// Contents stay. Where the system has no huge pages nothing changes.
void use_huge_pages(void* begin, std::size_t bytes);

/// The same for memory that nothing was written to yet: it costs nothing until then, and spares
/// use_huge_pages() the work of moving it.
void expect_huge_pages(void* begin, std::size_t bytes);

}  // namespace candelabra
