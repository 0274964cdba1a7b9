// SPDX-License-Identifier: GPL-3.0-or-later
// Memory from the system in large blocks. Asking for it page by page, as it is touched, costs as
// much as making what is put there; so blocks may come in huge pages, where the system has them.
// Called by Pool.
#pragma once

#include <cstddef>

namespace candelabra {

inline constexpr std::size_t page_block = std::size_t{1} << 21;

/// A block of that size, at a multiple of it, all zero. `all` says that most of it will be used.
/// Throws std::bad_alloc.
void* new_pages(bool all);
void free_pages(void* block);

}  // namespace candelabra
