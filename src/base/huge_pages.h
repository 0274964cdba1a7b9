// SPDX-License-Identifier: GPL-3.0-or-later
// Asks the system to keep memory in huge pages: whoever jumps about in many megabytes waits less
// for the addresses of pages. Called for what rays read of the kd-tree and of the spheres.
#pragma once

#include <cstddef>

/// A wish only: contents stay, and where the system knows no huge pages nothing changes.
void use_huge_pages(const void* begin, std::size_t bytes);
