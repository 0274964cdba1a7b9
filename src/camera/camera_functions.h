// SPDX-License-Identifier: GPL-3.0-or-later
// A vector of the rays of a `user_defined` camera: functions of the place in the picture.
#pragma once

#include "base/vector.h"
#include "formula/formula.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// Coordinates as functions of x and y (or u and v), which go from -1/2 at the left and the bottom
/// of the picture to 1/2.
struct CameraFunctions {
    Handle<Formula> x, y, z;  ///< null: not given

    bool given() const { return x && y && z; }
    /// The vector for a place; not finite where a function has no value. Precondition: given().
    Vec3 at(double u, double v) const;

    static const ItemInfo vocabulary;
};

}  // namespace candelabra
