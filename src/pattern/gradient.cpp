// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/gradient.h"

#include "vocabulary/schema.h"

const ItemInfo Gradient::vocabulary = described<Gradient>([] {
    using F = Field<Gradient>;
    return schema<Gradient>(
        "gradient", "A value that grows along a direction and starts again at each whole step.",
        F{"direction", &Gradient::direction, positional,
          "direction of growth; only its direction counts"});
});

double evaluate(const Gradient& gradient, const Vec3& point) {
    double along = dot(point, unit(gradient.direction));
    if (along > 1) along = std::fmod(along, 1);
    // POV-Ray's ramp: a whole step of exactly 1 stays 1, and negative values are wrapped a hair
    // later.
    along = std::fmod(along, 1.00001);
    return along < 0 ? along - std::floor(along) : along;
}
