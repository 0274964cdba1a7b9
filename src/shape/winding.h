// SPDX-License-Identifier: GPL-3.0-or-later
// Direction in which the curves of a prism or a text are drawn, which decides the normals that
// trace() returns. Called for the function of the language only.
#pragma once

#include "shape/prism.h"

#include <optional>

namespace candelabra {

/// Whether the outside is on the right of the curve, in its drawing direction, where the ray hits
/// the side nearest to t. Empty if an end is nearer.
std::optional<bool> outside_right_at(const BuiltPrism&, const Ray&, double t);

}  // namespace candelabra
