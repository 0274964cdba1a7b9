// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/cone.h"

#include "base/infinity.h"
#include "vocabulary/schema.h"

#include "shape/slab_interval.h"

namespace candelabra {

const ItemInfo Cone::vocabulary = described<Cone>([] {
    using F = Field<Cone>;
    return schema<Cone>("cone",
                        {"A cone or a frustum with flat ends.", "cone { 0, 1, 1.8*y, 0.3 }",
                         "cone { 0, 1, 1.8*y, 0.3 open }"},
                        F{"base", &Cone::base, positional, "centre of one end"},
                        F{"base_radius", &Cone::base_radius, positional,
                          "radius at that end; the side goes through the axis when one is below 0"},
                        F{"cap", &Cone::cap, positional, "centre of the other end"},
                        F{"cap_radius", &Cone::cap_radius, positional, "radius there"},
                        F{"open", &Cone::open, flag, "leaves the ends out"});
});

namespace {

constexpr Interval nowhere{infinity, -infinity};

/// The straight line between the centres of the ends.
struct Axis {
    explicit Axis(const Cone& cone)
        : height(length(cone.cap - cone.base)),
          up((cone.cap - cone.base) / height),
          slope((cone.cap_radius - cone.base_radius) / height) {}

    Vec3 across(const Vec3& v) const { return v - dot(v, up) * up; }

    double height;
    Vec3 up;
    double slope;  ///< growth of the radius along the axis
};

/// A ray relative to the cone: its offset from the axis, and the cone's radius at the same height,
/// at t = 0 and per t.
struct Line {
    Vec3 radial, radial_step;
    double radius, radius_step;

    Line moved(double t) const {
        return {radial + t * radial_step, radial_step, radius + t * radius_step, radius_step};
    }
    /// Coefficients of a t^2 + 2 b t + c, which is negative where the line is inside.
    double a() const { return dot(radial_step, radial_step) - radius_step * radius_step; }
    double b() const { return dot(radial, radial_step) - radius * radius_step; }
    double c() const {
        const double distance = length(radial);
        return (distance - radius) * (distance + radius);
    }
};

/// The interval of the line inside the infinite cone. If it hits both nappes, the one with the
/// positive radius counts; if it hits one nappe twice, the ends decide later which one it is.
Interval within_side(const Line& line) {
    const double a = line.a(), b = line.b(), c = line.c();
    if (a == 0 && b == 0) return c < 0 ? whole_line : nowhere;
    const double discriminant = b * b - a * c;
    if (a > 0 && !(discriminant > 0)) return nowhere;
    const double q = -(b + std::copysign(std::sqrt(std::fmax(discriminant, 0)), b));
    const double root = q == 0 ? 0 : c / q;
    if (a == 0) return b < 0 ? Interval{root, infinity} : Interval{-infinity, root};
    const double other = q / a;
    const Interval roots{std::fmin(root, other), std::fmax(root, other)};
    if (a > 0) return roots;
    return line.radius_step > 0 ? Interval{roots.max, infinity} : Interval{-infinity, roots.min};
}

/// Maximum relative change of a root by polishing.
constexpr double polish = 1e-9;

/// Restores the digits of a root that a flat parabola has cost, by one step of Newton's method on
/// the distance from the side. Roots of grazing lines are returned unchanged.
double polished(const Line& line, double t) {
    if (!std::isfinite(t)) return t;
    const Vec3 radial = line.radial + t * line.radial_step;
    const double distance = length(radial);
    const double change = dot(radial, line.radial_step) / distance - line.radius_step;
    const double step = (distance - line.radius - t * line.radius_step) / change;
    return std::abs(step) <= polish * std::abs(t) ? t - step : t;
}

/// Result of within_side(), computed from the deepest point of the line: b vanishes there, so a
/// grazing line loses no digits.
Interval within_side_centred(const Line& line) {
    const double a = line.a();
    const double scale =
        dot(line.radial_step, line.radial_step) + line.radius_step * line.radius_step;
    if (std::abs(a) < 1e-3 * scale || scale == 0) return within_side(line);
    const double shift = -line.b() / a;
    const Interval around = within_side(line.moved(shift));
    return {around.min + shift, around.max + shift};
}

}  // namespace

Box bounds(const Cone& cone) {
    const Vec3 u2 = Axis(cone).up * Axis(cone).up;
    const Vec3 reach = glm::min(Vec3(1), glm::sqrt(Vec3(u2.y + u2.z, u2.z + u2.x, u2.x + u2.y)));
    return join(Box{cone.base - cone.base_radius * reach, cone.base + cone.base_radius * reach},
                Box{cone.cap - cone.cap_radius * reach, cone.cap + cone.cap_radius * reach});
}

void crossings(const Cone& cone, const Ray& ray, Crossings& found) {
    const Vec3& direction = ray.direction;
    // Computed from the point of the ray nearest to the cone, so that a distant origin loses no
    // digits.
    const Vec3 middle = 0.5 * (cone.base + cone.cap);
    const double start = dot(middle - ray.origin, direction) / dot(direction, direction);
    const Vec3 near = ray.at(start);
    const Vec3 half = cone.cap - middle;
    const double widest = std::fmax(cone.base_radius, cone.cap_radius);
    if (!(dot(near - middle, near - middle) <= (widest * widest + dot(half, half)) * (1 + 1e-9)))
        return;

    const Axis axis(cone);
    const double rise = dot(direction, axis.up);
    const double below = dot(near - cone.base, axis.up), above = dot(cone.cap - near, axis.up);
    const Line line{axis.across(near - cone.base), axis.across(direction),
                    cone.base_radius + axis.slope * below, axis.slope * rise};
    const Interval slab = between_ends(below, above, rise);
    if (!(slab.min < slab.max)) return;
    Interval side = within_side_centred(line);
    // Roots that polishing cannot move into the slab are left unchanged.
    const auto far_below = [](double t, double limit) {
        return t + 2 * polish * std::abs(t) < limit;
    };
    if (side.min > side.max || far_below(side.max, slab.min) || far_below(-side.min, -slab.max))
        return;
    if (!far_below(side.min, slab.min)) side.min = polished(line, side.min);
    if (!far_below(-side.max, -slab.max)) side.max = polished(line, side.max);
    if (!(std::fmax(side.min, slab.min) < std::fmin(side.max, slab.max))) return;

    const auto crossing = [&](double t, bool at_end, bool entering) -> Crossing {
        if (at_end && entering == (rise > 0))
            return {meeting_with_end(ray, cone.base, axis.up, start + t), -axis.up, entering};
        if (at_end) return {meeting_with_end(ray, cone.cap, axis.up, start + t), axis.up, entering};
        const Vec3 outward = unit(line.radial + t * line.radial_step);
        return {start + t, axis.slope == 0 ? outward : unit(outward - axis.slope * axis.up),
                entering};
    };
    const bool first_at_end = slab.min >= side.min, last_at_end = slab.max <= side.max;
    const Crossing first = crossing(first_at_end ? slab.min : side.min, first_at_end, true);
    const Crossing last = crossing(last_at_end ? slab.max : side.max, last_at_end, false);
    const bool touches = !(first.t < last.t) || dot(direction, first.normal) >= 0 ||
                         dot(direction, last.normal) <= 0;
    if (touches) return;

    // The tip is part of the side, even when rounding makes it an end.
    const double first_radius = rise > 0 ? cone.base_radius : cone.cap_radius;
    const double last_radius = rise > 0 ? cone.cap_radius : cone.base_radius;
    if (!(cone.open && first_at_end && first_radius > 0)) found.add(first);
    if (!(cone.open && last_at_end && last_radius > 0)) found.add(last);
}

bool inside(const Cone& cone, const Vec3& point) {
    const Axis axis(cone);
    const Vec3 offset = point - cone.base;
    const double below = dot(offset, axis.up), above = dot(cone.cap - point, axis.up);
    const double distance = length(axis.across(offset)),
                 radius = cone.base_radius + axis.slope * below;
    // As in POV-Ray 3.7, the surface belongs to the inside only when the ends are open.
    if (cone.open) return below >= 0 && above >= 0 && distance <= radius;
    return below > 0 && above > 0 && distance < radius;
}

std::string problem(const Cone& cone) {
    return length(cone.cap - cone.base) > 0 ? "" : "a `cone` needs two different end points";
}

std::string vanishes(const Cone& cone) {
    return cone.base_radius == 0 && cone.cap_radius == 0 ? "both its radii are 0" : "";
}

}  // namespace candelabra
