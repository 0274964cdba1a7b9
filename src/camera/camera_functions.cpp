// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/camera_functions.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo CameraFunctions::vocabulary = described<CameraFunctions>([] {
    using F = Field<CameraFunctions>;
    return schema<CameraFunctions>(
        "user_defined",
        {"Where rays start, or where they go: location { } and direction { }.",
         "camera { user_defined location { function { 4*x } function { 1 + 3*y } function { -4 } } "
         "direction { function { 0 } function { 0 } function { 1 } } }"},
        F{"x", &CameraFunctions::x, positional, "x as a function of x and y in the picture"},
        F{"y", &CameraFunctions::y, positional, "y as a function of x and y in the picture"},
        F{"z", &CameraFunctions::z, positional, "z as a function of x and y in the picture"});
});

Vec3 CameraFunctions::at(double u, double v) const {
    const std::array<double, 3> place{u, v, 0};
    return {x->value(place), y->value(place), z->value(place)};
}

}  // namespace candelabra
