// SPDX-License-Identifier: GPL-3.0-or-later
// What the system is told of pages of memory: those that nobody reads any more, while the block
// that they are part of is still in use (a long list is read once and another one written from it,
// and both need not be there as a whole), and those that rays jump about in. Called by the kd-tree
// and its builder.
#pragma once

#include <cstddef>

/// Nobody reads these bytes any more: whole pages among them go back at once, and read as zeros
/// from then on. They may be written again, and are freed with their block.
void give_back_pages(void* begin, std::size_t bytes);

/// What was freed goes back, whichever thread used it: threads that built something large together
/// may keep as much as that takes. Looks at all that was freed, so it is for large things only.
void give_back_freed();

/// Who jumps about in many megabytes waits less for addresses when their pages are huge. A wish
/// only: contents stay, and where the system knows no huge pages nothing changes.
void use_huge_pages(void* begin, std::size_t bytes);

/// The same for memory that nothing was written to yet: it costs nothing until then, and spares
/// use_huge_pages() the work of moving it.
void expect_huge_pages(void* begin, std::size_t bytes);
