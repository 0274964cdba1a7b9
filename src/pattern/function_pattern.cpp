// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/function_pattern.h"

#include "vocabulary/schema.h"

#include <array>
#include <cmath>

namespace candelabra {

const ItemInfo FunctionPattern::vocabulary = described<FunctionPattern>([] {
    return schema<FunctionPattern>("function",
                                   {"A function of x, y and z: function { expression }.",
                                    "pigment { function { 0.5 + 0.5*sin(9*x)*cos(9*y) } }"});
});

double evaluate(const FunctionPattern& kind, const Vec3& point) {
    if (!kind.formula) return 0;
    const double value = kind.formula->value(std::array{point.x, point.y, point.z});
    if (std::isnan(value)) return 0;
    return value > 1 ? std::fmod(value, 1.0) : value;
}

}  // namespace candelabra
