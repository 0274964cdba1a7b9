// SPDX-License-Identifier: GPL-3.0-or-later
// What the samples of a pixel see by turns, such as the moments of an open shutter.
#pragma once

#include "base/random.h"

#include <cstdint>

namespace candelabra {

/// What is seen by turns. The turns of one are independent of those of the other.
enum class Turns : std::uint8_t { moments, camera_rays };

/// Returns the item, below `count`, whose turn it is at the key's sample. As many samples in a row
/// as there are items see each of them once, and fewer see items that lie apart. The pixel draws
/// the item of its first sample, so the mean over any number of samples is unbiased.
/// Precondition: count > 0.
std::uint32_t item_in_turn(Turns, std::uint32_t count, const Key&);

}  // namespace candelabra
