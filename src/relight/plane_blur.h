// SPDX-License-Identifier: GPL-3.0-or-later
// Blurs one channel of a picture. The time does not depend on the radius.
#pragma once

#include <vector>

namespace candelabra {

/// Replaces each value by a sum over its surroundings, with weights that fall linearly to 0 at
/// twice the radius, along rows and columns. Outside of the picture there is nothing.
void blur(std::vector<float>& plane, int width, int height, int radius, int threads);

}  // namespace candelabra
