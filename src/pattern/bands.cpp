// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/bands.h"

#include "base/elementary.h"
#include "vocabulary/schema.h"

#include <numbers>

namespace candelabra {

const ItemInfo Gradient::vocabulary = described<Gradient>([] {
    using F = Field<Gradient>;
    return schema<Gradient>(
        "gradient",
        {"A value that grows along a direction and starts again at each whole step.",
         "pigment { gradient x scale 0.4 }",
         "pigment { gradient x color_map { [0 rgb <0.1, 0.3, 0.7>] [0.5 rgb 1] [1 rgb <0.9, 0.5, "
         "0.2>] } }"},
        F{"direction", &Gradient::direction, positional,
          "direction of growth; only its direction counts"});
});

const ItemInfo Marble::vocabulary = described<Marble>([] {
    return schema<Marble>("marble", {"Layers across the x axis, disturbed by turbulence.",
                                     "pigment { marble turbulence 0.6 scale 0.4 }"});
});

const ItemInfo Wood::vocabulary = described<Wood>([] {
    return schema<Wood>("wood", {"Rings around the z axis, disturbed by turbulence.",
                                 "pigment { wood turbulence 0.05 scale 0.15 }"});
});

const ItemInfo Onion::vocabulary = described<Onion>([] {
    return schema<Onion>(
        "onion", {"Spheres within spheres, each of thickness 1.", "pigment { onion scale 0.2 }"});
});

const ItemInfo Leopard::vocabulary = described<Leopard>([] {
    return schema<Leopard>("leopard", {"Regular round spots.", "pigment { leopard scale 0.05 }"});
});

const ItemInfo Radial::vocabulary = described<Radial>([] {
    return schema<Radial>("radial", {"A value that grows once around the y axis.",
                                     "pigment { radial rotate 90*x frequency 6 }"});
});

const ItemInfo Spiral1::vocabulary = described<Spiral1>([] {
    using F = Field<Spiral1>;
    return schema<Spiral1>(
        "spiral1", {"A spiral around the z axis.", "pigment { spiral1 4 scale 0.3 }"},
        F{"arms", &Spiral1::arms, positional, "number of arms", between(-32768, 32767)});
});

const ItemInfo Spiral2::vocabulary = described<Spiral2>([] {
    using F = Field<Spiral2>;
    return schema<Spiral2>(
        "spiral2",
        {"A spiral around the z axis, laid over rings.", "pigment { spiral2 4 scale 0.3 }"},
        F{"arms", &Spiral2::arms, positional, "number of arms", between(-32768, 32767)});
});

namespace {

using std::numbers::pi;

/// Returns the amount that the statement's turbulence adds to a value, scaled by its x component.
double added_turbulence(const PatternPoint& at) {
    const double amount = at.modifiers.turbulence.x;
    if (amount == 0) return 0;
    return amount *
           scalar_turbulence(at.position, at.modifiers.noise_octaves(), at.noise_generator());
}

/// Grows along z and outwards, and by 1 per turn around the z axis for each arm.
double spiral(int arms, const PatternPoint& at) {
    const Vec3& p = at.position;
    const double away = std::sqrt(p.x * p.x + p.y * p.y);
    double angle = 0;
    if (away != 0) {
        const double rise = math::asin(p.y / away);
        angle = p.x < 0 ? 1.5 * pi - rise : 0.5 * pi + rise;
    }
    return p.z + away + arms * angle / (2 * pi) + added_turbulence(at);
}

}  // namespace

double evaluate(const Gradient& gradient, const Vec3& point) {
    const double along = dot(point, unit(gradient.direction));
    return along > 1 ? std::fmod(along, 1) : along;
}

double evaluate(const Marble&, const PatternPoint& at) {
    return at.position.x + added_turbulence(at);
}

double evaluate(const Wood&, const PatternPoint& at) {
    double x = at.position.x, y = at.position.y;
    const Vec3& amount = at.modifiers.turbulence;
    if (amount != Vec3(0)) {
        const Vec3 moved = turbulence(at.position, at.modifiers.noise_octaves());
        x += cycle((x + moved.x) * amount.x);
        y += cycle((y + moved.y) * amount.y);
    }
    return std::sqrt(x * x + y * y);
}

double evaluate(const Onion&, const Vec3& point) { return std::fmod(length(point), 1); }

double evaluate(const Leopard&, const Vec3& point) {
    const double mean = (math::sin(point.x) + math::sin(point.y) + math::sin(point.z)) / 3;
    return mean * mean;
}

double evaluate(const Radial&, const Vec3& point) {
    constexpr double axis = 0.001;  // half the width of the square around the axis
    if (std::abs(point.x) < axis && std::abs(point.z) < axis) return 0.25;
    return 0.25 + (math::atan2(point.x, point.z) + pi) / (2 * pi);
}

double evaluate(const Spiral1& kind, const PatternPoint& at) { return spiral(kind.arms, at); }

double evaluate(const Spiral2& kind, const PatternPoint& at) {
    const Vec3& p = at.position;
    return triangle(std::sqrt(p.x * p.x + p.y * p.y)) + triangle(spiral(kind.arms, at));
}

}  // namespace candelabra
