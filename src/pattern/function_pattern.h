// SPDX-License-Identifier: GPL-3.0-or-later
// A function of the language as a pattern.
#pragma once

#include "base/handle.h"
#include "base/vector.h"
#include "formula/formula.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// A pattern given by the function itself: pigment { function { sin(x) } ... }.
struct FunctionPattern {
    Handle<Formula> formula = nullptr;  ///< of x, y and z; null: 0 everywhere

    static const ItemInfo vocabulary;
};

/// Values above 1 wrap around to 0. The value is 0 where the function is undefined.
double evaluate(const FunctionPattern&, const Vec3&);

}  // namespace candelabra
