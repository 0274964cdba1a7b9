// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/shape.h"

namespace candelabra {

std::string problem(const Shape& shape) {
    return visit_shape([](const auto& s) { return problem(s); }, shape);
}

std::string vanishes(const Shape& shape) {
    return visit_shape([](const auto& s) { return vanishes(s); }, shape);
}

}  // namespace candelabra
