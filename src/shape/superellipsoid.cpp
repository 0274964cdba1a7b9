// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/superellipsoid.h"

#include "base/elementary.h"
#include "base/infinity.h"
#include "vocabulary/schema.h"

#include <optional>

namespace candelabra {

const ItemInfo Superellipsoid::vocabulary = described<Superellipsoid>([] {
    using F = Field<Superellipsoid>;
    return schema<Superellipsoid>(
        "superellipsoid",
        {"A solid between box, cylinder, sphere and octahedron.",
         "superellipsoid { <0.25, 0.25> scale 0.8 rotate <-20, 25, 0> translate 0.9*y }"},
        F{"exponents", &Superellipsoid::exponents, positional,
          "<e, n>: 1 is round, towards 0 square, 2 is straight, above it pinched", above(0)});
});

namespace {

/// A power with a shortcut for simple exponents.
class Power {
public:
    explicit Power(double exponent)
        : exponent_(exponent),
          doublings_(exponent == 1   ? 0
                     : exponent == 2 ? 1
                     : exponent == 4 ? 2
                     : exponent == 8 ? 3
                                     : none) {}

    double of(double base) const {
        if (base == 1) return 1;
        if (doublings_ == none) return math::pow(base, exponent_);
        for (int i = 0; i < doublings_; ++i) base *= base;
        return base;
    }

private:
    static constexpr int none = -1;
    double exponent_;
    int doublings_;
};

/// Implicit function of the solid: 0 on the surface, -1 in the centre; it grows linearly along rays
/// from the centre.
class Depth {
public:
    explicit Depth(const Superellipsoid& s)
        : p_(2 / s.exponents.x),
          q_(2 / s.exponents.y),
          across_(p_),
          up_(q_),
          join_(q_ / p_),
          size_(1 / q_) {}

    struct Place {
        double value;
        Vec3 gradient;
    };
    Place at(const Vec3& v) const {
        const Powers here(*this, v);
        if (here.size == 0) return {-1, Vec3(0)};
        const Vec3& part = here.part;
        // The derivative of a power is proportional to the power divided by its base.
        const auto slope = [](double raised, double part, double sign) {
            return part == 0 ? 0.0 : std::copysign(raised / part, sign);
        };
        const double whole = size_.of(here.sum), outer = whole / here.sum;
        const double inner = here.round == 0 ? 0.0 : outer * here.raised / here.round;
        return {here.size * whole - 1,
                Vec3(inner * slope(here.x, part.x, v.x), inner * slope(here.y, part.y, v.y),
                     outer * slope(here.z, part.z, v.z))};
    }
    double value(const Vec3& v) const {
        const Powers here(*this, v);
        return here.size == 0 ? -1 : here.size * size_.of(here.sum) - 1;
    }
    /// Whether the function is a norm minus 1, and so convex along every line.
    bool convex() const { return p_ >= 1 && q_ >= 1; }

private:
    /// Powers of the coordinates relative to the largest of them, so that none overflows.
    struct Powers {
        Powers(const Depth& depth, const Vec3& v)
            : size(max_abs_component(v)),
              part(size == 0 ? Vec3(0) : glm::abs(v) / size),
              x(depth.across_.of(part.x)),
              y(depth.across_.of(part.y)),
              z(depth.up_.of(part.z)),
              round(x + y),
              raised(std::fmin(depth.join_.of(round), 1e300)),
              sum(raised + z) {}

        double size;
        Vec3 part;
        double x, y, z, round, raised, sum;
    };

    double p_, q_;
    Power across_, up_, join_, size_;
};

/// The depth along a ray.
struct Profile {
    const Depth& depth;
    const Ray& ray;

    struct Place {
        double value, slope;
    };
    Place at(double t) const {
        const Depth::Place here = depth.at(ray.at(t));
        return {here.value, dot(here.gradient, ray.direction)};
    }

    /// The root between two places with values of different signs.
    double root(double low, double high, bool negative_at_low) const {
        double t = 0.5 * (low + high);
        for (int step = 0; step < 100; ++step) {
            const Place here = at(t);
            ((here.value < 0) == negative_at_low ? low : high) = t;
            double next = t - here.value / here.slope;
            if (!(next > low && next < high)) next = 0.5 * (low + high);
            const double moved = std::abs(next - t);
            t = next;
            if (moved <= 1e-15 * (std::abs(low) + std::abs(high)) || !(low < t && t < high)) break;
        }
        return t;
    }
};

/// A place of a convex profile with its value and slope.
struct Foot {
    double t, value, slope;
};

Foot foot(const Profile& profile, double t) {
    const Profile::Place here = profile.at(t);
    return {t, here.value, here.slope};
}

/// A place where a convex profile is below 0, with the nearest known places on both sides where it
/// is above.
struct Below {
    Foot low, high;
    double within;
};

/// Follows the tangents at two places, which bound the profile from below, to their intersection,
/// the next place to evaluate. Returns nothing when the profile is nowhere below 0.
std::optional<Below> place_below(const Profile& profile, const Interval& range) {
    Foot low = foot(profile, range.min), high = foot(profile, range.max);
    for (int step = 0; step < 60 && low.slope < 0 && high.slope > 0; ++step) {
        double t = (low.value - high.value + high.slope * high.t - low.slope * low.t) /
                   (high.slope - low.slope);
        if (!(low.value + low.slope * (t - low.t) < 0)) break;
        if (!(t > low.t && t < high.t)) t = 0.5 * (low.t + high.t);
        const Foot here = foot(profile, t);
        if (here.value < 0) return Below{low, high, t};
        (here.slope < 0 ? low : high) = here;
    }
    return std::nullopt;
}

/// The root of a convex profile between a place above 0 and one below. From above, Newton's method
/// approaches it from one side only, and doubles the digits at each step.
double root_from(const Profile& profile, Foot at, double within) {
    for (int step = 0; step < 100; ++step) {
        const double next = at.t - at.value / at.slope, moved = std::abs(next - at.t);
        const bool between = (next > at.t) == (within > at.t) && (next < within) == (at.t < within);
        if (!between) return at.t;
        if (moved <= 1e-9 * std::abs(within - at.t)) return next;
        at = foot(profile, next);
    }
    return at.t;
}

/// An end of a stretch of the ray.
struct End {
    double t;
    bool is_inside;
};

End end_at(const Profile& profile, double t) {
    return {t, profile.depth.value(profile.ray.at(t)) < 0};
}

/// Finds roots within one octant, where the distances from all three planes are monotonic: their
/// minima and maxima bound the depth.
template <class Take>
void bisect(const Profile& profile, const End& first, const End& last, int level, Take take) {
    const Vec3 a = glm::abs(profile.ray.at(first.t)), b = glm::abs(profile.ray.at(last.t));
    if (profile.depth.value(glm::min(a, b)) > 0 || profile.depth.value(glm::max(a, b)) < 0) return;
    const bool differ = first.is_inside != last.is_inside;
    if (differ && level >= 4) return take(profile.root(first.t, last.t, first.is_inside));
    if (level >= 12) return;
    const End middle = end_at(profile, 0.5 * (first.t + last.t));
    bisect(profile, first, middle, level + 1, take);
    bisect(profile, middle, last, level + 1, take);
}

/// Ends of the parts of the range between the planes that separate the octants.
std::vector<double> octants(const Ray& ray, const Interval& range) {
    std::vector<double> ends = {range.min, range.max};
    for (int axis = 0; axis < 3; ++axis) {
        const double t = -ray.origin[axis] / ray.direction[axis];
        if (range.contains(t)) ends.push_back(t);
    }
    std::sort(ends.begin(), ends.end());
    return ends;
}

}  // namespace

Box bounds(const Superellipsoid&) { return {Vec3(-1), Vec3(1)}; }

void crossings(const Superellipsoid& s, const Ray& ray, Crossings& found) {
    nearest_crossings(s, ray, {infinity, infinity}, found);
}

void nearest_crossings(const Superellipsoid& s, const Ray& ray, const Interval& wanted,
                       Crossings& found) {
    if (ray.direction == Vec3(0)) return;
    // Slightly larger than the solid, so that the ends of the range are outside.
    const Interval range = clip(ray, {Vec3(-1.001), Vec3(1.001)}, {-infinity});
    if (!(range.min < range.max)) return;
    const Depth depth(s);
    // Computed from the middle of the range, so that a distant origin loses no digits.
    const double start = 0.5 * (range.min + range.max), half = 0.5 * (range.max - range.min);
    const Ray near{ray.at(start), ray.direction};
    const Profile profile{depth, near};
    const auto take = [&](double t) {
        const Vec3 normal = unit(depth.at(near.at(t)).gradient);
        if (normal != Vec3(0) && std::isfinite(normal.x + normal.y + normal.z))
            found.add({start + t, normal, dot(ray.direction, normal) < 0});
    };
    if (depth.convex()) {
        const std::optional<Below> below = place_below(profile, {-half, half});
        if (!below) return;
        const double entry = root_from(profile, below->low, below->within);
        take(entry);
        if (!wanted.contains(start + entry)) take(root_from(profile, below->high, below->within));
        return;
    }
    const std::vector<double> ends = octants(near, {-half, half});
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        bisect(profile, end_at(profile, ends[i]), end_at(profile, ends[i + 1]), 0, take);
}

bool inside(const Superellipsoid& s, const Vec3& point) { return Depth(s).value(point) <= 0; }

}  // namespace candelabra
