// SPDX-License-Identifier: GPL-3.0-or-later
// Gives memory back to the system while the block that it is part of is still in use: where a long
// list is read once and another one written from it, both need not be there as a whole. Called by
// the builder of the kd-tree.
#pragma once

#include <cstddef>

/// Nobody reads these bytes any more: whole pages among them go back at once, and read as zeros
/// from then on. They may be written again, and are freed with their block.
void give_back_pages(void* begin, std::size_t bytes);
