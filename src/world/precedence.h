// SPDX-License-Identifier: GPL-3.0-or-later
// Which of two surfaces in one place a ray meets. Rounding has no say in it: a glass that stands on
// a table touches it all over, and what is seen through its foot is the one or the other.
#pragma once

#include "world/world.h"

/// Around a primitive, or around a composite, counted from world.leaves_begin() on.
Box item_bounds(const World&, std::uint32_t item);

/// Whether the ray meets an item before another one that it meets at the same distance.
/// Precondition: neither is endless. As in POV-Ray, the one whose box it enters first; of two that
/// it enters together, and of two that it begins in, the one with the lower number.
bool precedes(const World&, std::uint32_t item, std::uint32_t other, const Ray&);
