// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/sphere_sweep.h"

#include "base/order.h"
#include "vocabulary/schema.h"

#include "base/roots.h"

#include <algorithm>

namespace candelabra {

const ItemInfo SphereSweep::vocabulary = described<SphereSweep>([] {
    using F = Field<SphereSweep>;
    return schema<SphereSweep>(
        "sphere_sweep",
        {"The solid that a moving sphere fills.",
         "sphere_sweep { linear_spline 3, <-1, 0.3, 0>, 0.3, <0, 1.5, 0>, 0.2, <1, 0.4, 0>, 0.4 }",
         "sphere_sweep { cubic_spline 6, <-2, 0.4, 0>, 0.3, <-1.2, 0.4, 0>, 0.3, <-0.4, 1.5, 0>, "
         "0.2, <0.5, 0.5, 0>, 0.35, <1.2, 1.2, 0>, 0.15, <2, 1, 0>, 0.1 }",
         "sphere_sweep { b_spline 5, <-2, 0.4, 0>, 0.3, <-1.2, 0.4, 0>, 0.3, <0, 2.2, 0>, 0.2, "
         "<1.2, 0.5, 0>, 0.3, <2, 1, 0>, 0.1 tolerance 1e-5 }"},
        F{"spheres", &SphereSweep::spheres, counted, "centre, radius of each"},
        chooses("linear_spline", &SphereSweep::spline, linear_way,
                "straight from sphere to sphere"),
        chooses("cubic_spline", &SphereSweep::spline, cubic_way,
                "smooth; the first and the last sphere only shape the way"),
        chooses("b_spline", &SphereSweep::spline, b_way, "smoother; the way passes by the spheres"),
        F{"tolerance", &SphereSweep::tolerance, item,
          "has no effect: surfaces are as exact as numbers are", above(0)});
});

namespace {

using Piece = BuiltSphereSweep::Piece;

/// Coefficients of a polynomial of u, from its four control values.
struct Basis {
    std::array<std::array<double, 4>, 4> rows;  ///< by power of u, then control value
};

constexpr Basis linear{{{{1, 0, 0, 0}, {-1, 1, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}}};
constexpr Basis catmull_rom{
    {{{0, 1, 0, 0}, {-0.5, 0, 0.5, 0}, {1, -2.5, 2, -0.5}, {-0.5, 1.5, -1.5, 0.5}}}};
constexpr double sixth = 1.0 / 6;
constexpr Basis uniform_b{{{{sixth, 4 * sixth, sixth, 0},
                            {-0.5, 0, 0.5, 0},
                            {0.5, -1, 0.5, 0},
                            {-sixth, 0.5, -0.5, sixth}}}};

const Basis& basis(int spline) {
    return spline == linear_way ? linear : spline == cubic_way ? catmull_rom : uniform_b;
}

std::size_t used(int spline) { return spline == linear_way ? 2 : 4; }

Piece piece(const Basis& basis, std::span<const Ball> controls) {
    Piece result{};
    for (std::size_t power = 0; power < 4; ++power)
        for (std::size_t i = 0; i < controls.size(); ++i) {
            result.centres[power] += basis.rows[power][i] * controls[i].centre;
            result.radii[power] += basis.rows[power][i] * controls[i].radius;
        }
    return result;
}

/// Exact bounds, from the extremes of each coordinate of the sphere's side.
Box bounds(const Piece& p) {
    Box box;
    for (const double u : {0.0, 1.0}) {
        const Vec3 r(std::abs(p.radius(u)));
        box = join(box, {p.centre(u) - r, p.centre(u) + r});
    }
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            std::array<double, 3> slope{};
            for (std::size_t i = 1; i < 4; ++i)
                slope[i - 1] = static_cast<double>(i) * (p.centres[i][axis] + side * p.radii[i]);
            for (const double u : sign_changes(slope, {0, 1})) {
                const double end = p.centre(u)[axis] + side * p.radius(u);
                box.low[axis] = std::fmin(box.low[axis], end);
                box.high[axis] = std::fmax(box.high[axis], end);
            }
        }
    return box;
}

/// A ray of unit length is inside the sphere at u between along(u) - sqrt(spare(u)) and along(u) +
/// sqrt(spare(u)), where spare(u) is not below 0.
struct SweepProfile {
    std::array<double, 4> along{};
    std::array<double, 7> spare{};

    SweepProfile(const Piece& p, const Ray& ray) {
        std::array<Vec3, 4> across;
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3 to = i == 0 ? p.centres[0] - ray.origin : p.centres[i];
            along[i] = dot(to, ray.direction);
            across[i] = to - along[i] * ray.direction;
        }
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j)
                spare[i + j] += p.radii[i] * p.radii[j] - dot(across[i], across[j]);
    }

    /// The derivative of `spare`.
    std::array<double, 6> growth() const {
        std::array<double, 6> result{};
        for (std::size_t i = 1; i < 7; ++i) result[i - 1] = static_cast<double>(i) * spare[i];
        return result;
    }

    /// Zero where the first or the last point of the ray in the sphere is extreme: there along' =
    /// +- spare' / (2 sqrt(spare)).
    std::array<double, 11> extremes() const {
        std::array<double, 11> result{};
        std::array<double, 3> slope{};
        const std::array<double, 6> fall = growth();
        for (std::size_t i = 1; i < 4; ++i) slope[i - 1] = static_cast<double>(i) * along[i];
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                for (std::size_t k = 0; k < 7; ++k)
                    result[i + j + k] += 4 * slope[i] * slope[j] * spare[k];
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < 6; ++j) result[i + j] -= fall[i] * fall[j];
        return result;
    }
};

/// A part of the ray inside the solid, with the spheres at both ends.
struct SweepStretch {
    double first, last;
    Vec3 first_centre, last_centre;
};

/// The part of the ray covered by the spheres of a range of u, all of which it hits.
SweepStretch covered(const Piece& p, const SweepProfile& profile, const Interval& range) {
    SweepStretch result{std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity(), Vec3(0), Vec3(0)};
    const auto consider = [&](double u) {
        const double middle = polynomial(profile.along, u);
        const double half = std::sqrt(std::fmax(0, polynomial(profile.spare, u)));
        if (middle - half < result.first)
            result.first = middle - half, result.first_centre = p.centre(u);
        if (middle + half > result.last)
            result.last = middle + half, result.last_centre = p.centre(u);
    };
    consider(range.min);
    consider(range.max);
    for (const double u : sign_changes(profile.extremes(), range)) consider(u);
    // Where both ends are extreme at the same sphere, that polynomial only touches 0.
    for (const double u : sign_changes(profile.growth(), range)) consider(u);
    return result;
}

void meet(const Piece& p, const Ray& ray, std::vector<SweepStretch>& found) {
    const SweepProfile profile(p, ray);
    const Roots ends = sign_changes(profile.spare, {0, 1});
    double from = 0;
    bool met = polynomial(profile.spare, 0) > 0;
    for (std::size_t i = 0; i <= ends.size(); ++i) {
        const double to = i < ends.size() ? ends[i] : 1;
        if (met) found.push_back(covered(p, profile, {from, to}));
        from = to;
        met = !met;
    }
}

}  // namespace

BuiltSphereSweep build(const SphereSweep& sweep, const RayIndex& index) {
    BuiltSphereSweep result;
    std::vector<Box> boxes;
    const std::size_t count = used(sweep.spline);
    for (std::size_t i = 0; i + count <= sweep.spheres.size(); ++i) {
        result.pieces.push_back(
            piece(basis(sweep.spline), std::span(sweep.spheres).subspan(i, count)));
        boxes.push_back(bounds(result.pieces.back()));
    }
    result.index = PartIndex(std::move(boxes), index);
    return result;
}

std::string problem(const SphereSweep& sweep) {
    if (sweep.spline == no_way)
        return "a `sphere_sweep` needs `linear_spline`, `cubic_spline` or `b_spline` before its "
               "spheres";
    const std::size_t least = used(sweep.spline);
    if (sweep.spheres.size() < least)
        return "a `sphere_sweep` with this spline needs at least " + std::to_string(least) +
               " spheres";
    return {};
}

std::string vanishes(const SphereSweep& sweep) {
    return std::ranges::any_of(sweep.spheres, [](const Ball& each) { return each.radius > 0; })
               ? ""
               : "all its radii are 0";
}

Box bounds(const BuiltSphereSweep& sweep) { return sweep.index.bounds(); }

void crossings(const BuiltSphereSweep& sweep, const Ray& ray, Crossings& found) {
    const double speed = length(ray.direction);
    if (!(speed > 0)) return;
    // Computed from the point nearest to the middle, so that a distant origin loses no digits.
    const Vec3 u = ray.direction / speed;
    const double start = dot(sweep.index.bounds().centre() - ray.origin, u);
    const Ray near{ray.origin + start * u, u};
    std::vector<SweepStretch> stretches;
    sweep.index.along(near, {-std::numeric_limits<double>::infinity()},
                      [&](std::uint32_t i) { meet(sweep.pieces[i], near, stretches); });
    sort_stably(stretches, {}, &SweepStretch::first);
    for (std::size_t i = 0; i < stretches.size();) {
        SweepStretch whole = stretches[i];
        for (++i; i < stretches.size() && stretches[i].first <= whole.last; ++i)
            if (stretches[i].last > whole.last)
                whole.last = stretches[i].last, whole.last_centre = stretches[i].last_centre;
        const auto normal = [&](double s, const Vec3& centre, double side) {
            const Vec3 n = unit(near.at(s) - centre);
            // A sphere of radius 0 is only a point.
            return dot(n, u) * side > 0 ? n : side * u;
        };
        if (!(whole.first < whole.last)) continue;
        found.add(
            {(start + whole.first) / speed, normal(whole.first, whole.first_centre, -1), true});
        found.add({(start + whole.last) / speed, normal(whole.last, whole.last_centre, 1), false});
    }
}

bool inside(const BuiltSphereSweep& sweep, const Vec3& point) {
    bool result = false;
    sweep.index.around(point, [&](std::uint32_t n) {
        if (result) return;
        const Piece& p = sweep.pieces[n];
        std::array<double, 7> spare{};
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) {
                const Vec3 a = p.centres[i] - (i == 0 ? point : Vec3(0));
                const Vec3 b = p.centres[j] - (j == 0 ? point : Vec3(0));
                spare[i + j] += p.radii[i] * p.radii[j] - dot(a, b);
            }
        result = polynomial(spare, 0) >= 0 || polynomial(spare, 1) >= 0 ||
                 !sign_changes(spare, {0, 1}).empty();
    });
    return result;
}

}  // namespace candelabra
