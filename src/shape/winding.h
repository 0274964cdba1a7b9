// SPDX-License-Identifier: GPL-3.0-or-later
// Which way the curves of a prism or a text are drawn, which decides the normals that trace()
// tells. Called for the function of the language only.
#pragma once

#include "shape/prism.h"

#include <optional>

namespace candelabra {

/// Where the ray meets a side, nearest to t: whether the outside is on the right of the curve, in
/// the direction in which it is drawn. Nothing where an end is nearer.
std::optional<bool> outside_right_at(const BuiltPrism&, const Ray&, double t);

}  // namespace candelabra
