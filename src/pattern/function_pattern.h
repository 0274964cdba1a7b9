// SPDX-License-Identifier: GPL-3.0-or-later
// A function of the language as a pattern.
#pragma once

#include "base/handle.h"
#include "base/vector.h"
#include "formula/formula.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// Named by the function itself: pigment { function { sin(x) } ... }.
struct FunctionPattern {
    Handle<Formula> formula = nullptr;  ///< of x, y and z; null: 0 everywhere

    static const ItemInfo vocabulary;
};

/// What is above 1 begins again at 0; where the function has no value it is 0.
double evaluate(const FunctionPattern&, const Vec3&);

}  // namespace candelabra
