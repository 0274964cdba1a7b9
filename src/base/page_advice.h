// SPDX-License-Identifier: GPL-3.0-or-later
// What the system is told of pages of memory: that what was freed may go back, and which ones rays
// jump about in. Called by the index of boxes and its builder.
#pragma once

#include <cstddef>

namespace candelabra {

/// What was freed goes back, whichever thread used it: threads that built something large together
/// may keep as much as that takes. Looks at all that was freed, so it is for large things only.
void give_back_freed();

/// Who jumps about in many megabytes waits less for addresses when their pages are huge. A wish
/// only: contents stay, and where the system knows no huge pages nothing changes.
void use_huge_pages(void* begin, std::size_t bytes);

/// The same for memory that nothing was written to yet: it costs nothing until then, and spares
/// use_huge_pages() the work of moving it.
void expect_huge_pages(void* begin, std::size_t bytes);

}  // namespace candelabra
