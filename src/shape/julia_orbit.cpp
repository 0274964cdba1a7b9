// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/julia_orbit.h"

#include "base/elementary.h"
#include "base/target_clones.h"
#include "base/work_watch.h"
#include "shape/julia_formula.h"

#include <algorithm>

namespace candelabra {

namespace {

/// See count_work(): iterations of a polynomial. One of a formula counts by itself.
constexpr int steps_of_count = 8;

/// Counts one orbit of so many iterations.
void count_orbit(const JuliaFractal& julia, int iterations) {
    const int steps = is_by_formula(julia) ? 2 * iterations : iterations / steps_of_count;
    count_work(static_cast<std::uint32_t>(1 + steps));
}

double size2(const Vec4& q) { return glm::dot(q, q); }

// The polynomials, for single numbers or vectors of numbers.

template <class Quaternion>
Quaternion hypercomplex_square(const Quaternion& q) {
    return {q.x * q.x - q.y * q.y - q.z * q.z + q.w * q.w, 2 * (q.x * q.y - q.z * q.w),
            2 * (q.x * q.z - q.y * q.w), 2 * (q.x * q.w + q.y * q.z)};
}

template <class Quaternion>
Quaternion square(const Quaternion& q) {
    return {q.x * q.x - q.y * q.y - q.z * q.z - q.w * q.w, 2 * q.x * q.y, 2 * q.x * q.z,
            2 * q.x * q.w};
}

template <class Quaternion>
Quaternion cube(const Quaternion& q) {
    const auto d = q.y * q.y + q.z * q.z + q.w * q.w, sum = 3 * q.x * q.x - d;
    return {q.x * (q.x * q.x - 3 * d), q.y * sum, q.z * sum, q.w * sum};
}

/// Calls use(F), where F maps a point to its image: it is chosen once for a whole orbit.
template <class Use>
auto with_function(const JuliaFractal& julia, Use use) {
    if (is_by_formula(julia)) return use([&](const Vec4& q) { return formula_image(julia, q); });
    if (julia.algebra == hypercomplex_numbers)
        return use([](const Vec4& q) { return hypercomplex_square(q); });
    if (function_of(julia) == julia_sqr) return use([](const Vec4& q) { return square(q); });
    return use([](const Vec4& q) { return cube(q); });
}

/// Lower bound of the distance to the set, from an orbit that escapes. Quaternions have one size. A
/// hypercomplex number is two complex ones with a set each; its distance is that from the further
/// set.
class DistanceBound {
public:
    DistanceBound(bool two_numbers, bool cubic) : two_(two_numbers), cubic_(cubic) {}

    /// Multiplies by the function's derivative, 2 q or 3 q^2.
    void follow(const Vec4& q) {
        const Vec2 sizes = sizes2(q);
        product2_ *= cubic_ ? sizes * sizes : sizes;
        factor_ /= cubic_ ? 3 : 2;
    }
    /// |q_n| ln|q_n| / (2 |q_n'|), where q_n' is the product of all derivatives.
    double at(const Vec4& q) const {
        const Vec2 sizes = sizes2(q);
        const double first = bound(sizes.x, product2_.x);
        if (!two_) return first;
        // Distances in the plane of both numbers are larger by a factor of sqrt(2).
        return std::max(first, bound(sizes.y, product2_.y)) / std::sqrt(2.0);
    }

private:
    Vec2 sizes2(const Vec4& q) const {
        if (!two_) return Vec2(size2(q), 1);
        const Vec2 a(q.x - q.w, q.y + q.z), b(q.x + q.w, q.y - q.z);
        return {glm::dot(a, a), glm::dot(b, b)};
    }
    double bound(double size2, double product2) const {
        const double step = 0.25 * factor_ * std::sqrt(size2 / product2) * math::log(size2);
        return std::isfinite(step) && size2 > 1 ? step : 0;
    }

    bool two_;
    bool cubic_;
    double factor_ = 1;
    Vec2 product2_ = Vec2(1);
};

/// Numbers processed at once.
using Four [[gnu::vector_size(4 * sizeof(double))]] = double;

struct FourPoints {
    Four x, y, z, w;
};

/// Number of leading orbits, of four, that stay; each is computed as in julia_orbit().
template <class Image>
[[gnu::always_inline]] inline int staying(const JuliaSet& set, const Ray& ray,
                                          const std::array<double, 4>& places, Image image) {
    const Four t{places[0], places[1], places[2], places[3]};
    const Vec3 &o = ray.origin, &d = ray.direction;
    const Vec4 &s = set.slice, &c = set.julia.parameter;
    FourPoints q{o.x + t * d.x, o.y + t * d.y, o.z + t * d.z, {}};
    q.w = (set.julia.distance - s.x * q.x - s.y * q.y - s.z * q.z) / s.w;
    int stays = 4;
    for (int n = 0; n < set.julia.max_iteration; ++n) {
        const Four size2 = (q.x * q.x + q.y * q.y) + (q.z * q.z + q.w * q.w);
        for (int i = 0; i < stays; ++i)
            if (size2[i] > set.limit2) stays = i;
        if (stays == 0) return 0;
        q = image(q);
        q = {q.x + c.x, q.y + c.y, q.z + c.z, q.w + c.w};
    }
    return stays;
}

CANDELABRA_TARGET_CLONES int squares_stay(const JuliaSet& set, const Ray& ray,
                                          const std::array<double, 4>& places) {
    return staying(set, ray, places, [](const FourPoints& q) { return square(q); });
}
CANDELABRA_TARGET_CLONES int cubes_stay(const JuliaSet& set, const Ray& ray,
                                        const std::array<double, 4>& places) {
    return staying(set, ray, places, [](const FourPoints& q) { return cube(q); });
}
CANDELABRA_TARGET_CLONES int hypercomplex_squares_stay(const JuliaSet& set, const Ray& ray,
                                                       const std::array<double, 4>& places) {
    return staying(set, ray, places, [](const FourPoints& q) { return hypercomplex_square(q); });
}

double limit2(const JuliaFractal& julia) {
    if (julia.algebra == hypercomplex_numbers) return 16;
    const double radius = julia_radius(julia);
    return radius * radius + 1e-7;
}

}  // namespace

double julia_radius(const JuliaFractal& julia) {
    if (julia.algebra == hypercomplex_numbers) return 4;
    return std::fmin(2, 1 + std::sqrt(size2(julia.parameter)) + 1e-7);
}

JuliaSet::JuliaSet(const JuliaFractal& fractal)
    : julia(fractal),
      by_formula(is_by_formula(fractal)),
      slice(fractal.slice / std::sqrt(size2(fractal.slice))),
      limit2(candelabra::limit2(fractal)) {}

Vec4 JuliaSet::place(const Vec3& p) const {
    return {p.x, p.y, p.z,
            (julia.distance - slice.x * p.x - slice.y * p.y - slice.z * p.z) / slice.w};
}

JuliaOrbit julia_orbit(const JuliaSet& set, const Vec3& point) {
    const JuliaFractal& julia = set.julia;
    const bool cubic = function_of(julia) == julia_cube && julia.algebra != hypercomplex_numbers;
    return with_function(julia, [&](const auto& image) -> JuliaOrbit {
        Vec4 q = set.place(point);
        DistanceBound bound(julia.algebra == hypercomplex_numbers, cubic);
        for (int n = 0; n < julia.max_iteration; ++n) {
            if (const double distance2 = size2(q); distance2 > set.limit2) {
                count_orbit(julia, n);
                return {false, distance2, set.by_formula ? 0 : bound.at(q)};
            }
            bound.follow(q);
            q = image(q) + julia.parameter;
        }
        count_orbit(julia, julia.max_iteration);
        return {true, size2(q), 0};
    });
}

bool julia_contains(const JuliaSet& set, const Vec3& point) {
    return julia_orbit(set, set.by_formula ? formula_place(set.julia, point) : point).stays;
}

int julia_stays(const JuliaSet& set, const Ray& ray, const std::array<double, 4>& places) {
    if (set.by_formula) return 0;
    count_orbit(set.julia, set.julia.max_iteration);
    if (set.julia.algebra == hypercomplex_numbers)
        return hypercomplex_squares_stay(set, ray, places);
    return function_of(set.julia) == julia_sqr ? squares_stay(set, ray, places)
                                               : cubes_stay(set, ray, places);
}

double julia_size(const JuliaSet& set, const Vec3& point) {
    const JuliaFractal& julia = set.julia;
    return with_function(julia, [&](const auto& image) {
        Vec4 q = set.place(point);
        int n = 0;
        for (; n < julia.max_iteration && size2(q) < 1e100; ++n) q = image(q) + julia.parameter;
        count_orbit(julia, n);
        return size2(q);
    });
}

}  // namespace candelabra
