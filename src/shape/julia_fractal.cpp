// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/julia_fractal.h"

#include "base/elementary.h"
#include "shape/julia_formula.h"
#include "shape/julia_orbit.h"
#include "shape/line_search.h"
#include "shape/sphere.h"
#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo JuliaFractal::vocabulary = described<JuliaFractal>([] {
    using F = Field<JuliaFractal>;
    constexpr auto function = &JuliaFractal::function;
    return schema<JuliaFractal>(
        "julia_fractal",
        {"A slice of a Julia set of four dimensions.",
         "julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 20 "
         "translate y }",
         "julia_fractal { <-0.745, 0, 0.113, 0.05> quaternion cube slice <0, 0, 0, 1>, 0 translate "
         "y }",
         "julia_fractal { <-0.5, 0.2, 0, 0> hypercomplex pwr(3, 0) translate y }"},
        F{"parameter", &JuliaFractal::parameter, positional, "the c of q -> F(q) + c"},
        chooses("quaternion", &JuliaFractal::algebra, quaternions, "the numbers are quaternions"),
        chooses("hypercomplex", &JuliaFractal::algebra, hypercomplex_numbers,
                "the numbers are hypercomplex"),
        chooses("sqr", function, julia_sqr, "F is the square"),
        chooses("cube", function, julia_cube, "F is the cube"),
        chooses("exp", function, julia_exp, "F is the exponential function"),
        chooses("ln", function, julia_ln, "F is the logarithm"),
        chooses("reciprocal", function, julia_reciprocal, "F is 1 / q"),
        chooses("sin", function, julia_sin, "F is the sine"),
        chooses("asin", function, julia_asin, "F is the arc sine"),
        chooses("sinh", function, julia_sinh, "F is the hyperbolic sine"),
        chooses("asinh", function, julia_asinh, "F is its inverse"),
        chooses("cos", function, julia_cos, "F is the cosine"),
        chooses("acos", function, julia_acos, "F is the arc cosine"),
        chooses("cosh", function, julia_cosh, "F is the hyperbolic cosine"),
        chooses("acosh", function, julia_acosh, "F is its inverse"),
        chooses("tan", function, julia_tan, "F is the tangent"),
        chooses("atan", function, julia_atan, "F is the arc tangent"),
        chooses("tanh", function, julia_tanh, "F is the hyperbolic tangent"),
        chooses("atanh", function, julia_atanh, "F is its inverse"),
        F{"pwr", &JuliaFractal::exponent, item, "F is a power: the exponent's two parts"},
        F{"max_iteration", &JuliaFractal::max_iteration, item, "steps of each orbit",
          between(1, 1000)},
        F{"precision", &JuliaFractal::precision, item, "steps of a ray in a unit of length",
          above(0)},
        F{"slice", &JuliaFractal::slice, item, "normal of the three dimensions that are seen"},
        F{"distance", &JuliaFractal::distance, following, "theirs from 0"});
});

namespace {

/// Maximum number of steps along one ray.
constexpr int max_steps = 100'000;
/// A place that near, in steps, is that where a ray begins; border() is more exact.
constexpr double at_once = 1e-9;

Vec3 normal_at(const JuliaSet& julia, const Vec3& p, const Vec3& direction, bool entering) {
    Vec3 slope;
    if (julia.by_formula) {
        slope = formula_slope(julia, p);
        return normal_against((dot(slope, direction) < 0) == entering ? slope : -slope, direction,
                              entering);
    }
    constexpr double step = 1e-6;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 aside(0);
        aside[axis] = step;
        slope[axis] = math::log(julia_size(julia, p + aside) + 1e-300) -
                      math::log(julia_size(julia, p - aside) + 1e-300);
    }
    return normal_against(slope, direction, entering);
}

/// Bisects for the boundary of the set between two places of a ray.
double border(const JuliaSet& julia, const Ray& ray, double first, double last, bool stays) {
    constexpr int enough = 32;
    for (int i = 0; i < enough; ++i) {
        const double middle = 0.5 * (first + last);
        (julia_contains(julia, ray.at(middle)) == stays ? first : last) = middle;
    }
    return 0.5 * (first + last);
}

/// Advances `t` in steps of the given size while the quick test finds the set there, up to the end.
/// Returns the number of steps.
int pass_inside(const JuliaSet& julia, const Ray& ray, double step, double end, double& t) {
    int steps = 0;
    for (int stays = 4; stays == 4 && steps < max_steps; steps += stays) {
        std::array<double, 4> places;
        for (double before = t; double& place : places) before = place = before + step;
        if (!(places[3] < end)) break;
        stays = julia_stays(julia, ray, places);
        if (stays > 0) t = places[static_cast<std::size_t>(stays - 1)];
    }
    return steps;
}

enum class Start { anywhere, surface };

/// Calls take(crossing) for the crossings in the range, in ascending order, until it returns false.
template <class Take>
void walk(const JuliaFractal& fractal, const Ray& ray, const Interval& range, Start begins,
          Take take) {
    const double speed = length(ray.direction);
    if (!(speed > 0)) return;
    const Vec3 u = ray.direction / speed;
    const double start = -dot(ray.origin, u);
    const Ray near{ray.origin + start * u, u};
    Crossings ends;
    crossings(Sphere{Vec3(0), julia_radius(fractal)}, near, ends);
    if (ends.size() != 2) return;
    const JuliaSet julia(fractal);
    const double first = std::fmin(ends[0].t, ends[1].t), last = std::fmax(ends[0].t, ends[1].t);
    const double least = 1 / fractal.precision;
    const double until = std::fmin(last, range.max * speed - start);
    // The sphere is outside of the set, whatever rounding says. But as in POV-Ray, the set of a
    // formula, which may fill space, has no surface there.
    const bool goes_on = julia.by_formula;
    // Which crossings are found depends on the steps. So a ray makes the same ones whatever part of
    // it is asked for.
    double t = std::fmax(first, std::fmin(range.min, 0) * speed - start);
    const bool within = t > first;
    const double origin = t;
    JuliaOrbit here = julia_orbit(julia, near.at(goes_on ? t + 1e-7 : t));
    here.stays = here.stays && (goes_on || within);
    // A ray that leaves the surface may start in a part of the set smaller than a step.
    if (here.stays && within && (begins == Start::surface || goes_on))
        here = julia_orbit(julia, near.at(t = std::fmin(t + least, until)));
    for (int n = 0; n < max_steps && t < until; ++n) {
        if (here.stays) n += pass_inside(julia, near, least, std::fmin(until, last), t);
        const double next = std::fmin(last, t + std::fmax(least, here.stays ? 0 : here.step));
        if (goes_on && next == last) return;
        const JuliaOrbit there = next < last ? julia_orbit(julia, near.at(next)) : JuliaOrbit{};
        if (there.stays != here.stays) {
            const double at = border(julia, near, t, next, here.stays);
            const Vec3 normal = normal_at(julia, near.at(at), u, there.stays);
            // A ray that begins on the surface does not cross it there.
            const bool leaves = within && at - origin <= at_once * least;
            if (!leaves && !take({(start + at) / speed, normal, there.stays})) return;
        }
        here = there;
        t = next;
    }
    // The steps ran out within the set: it ends at the sphere.
    if (here.stays && !goes_on && t < until) take({(start + last) / speed, u, false});
}

}  // namespace

std::string problem(const JuliaFractal& julia) {
    if (julia.slice.w == 0)
        return "the `slice` of a `julia_fractal` needs a fourth component that is not 0";
    const bool simple =
        (julia.function == julia_sqr || julia.function == julia_cube) && julia.exponent == Vec2(0);
    return simple || julia.algebra == hypercomplex_numbers
               ? ""
               : "a `julia_fractal` of quaternions has `sqr` and `cube` only";
}

Box bounds(const JuliaFractal& julia) {
    const Vec3 reach(julia_radius(julia));
    return {-reach, reach};
}

void crossings(const JuliaFractal& julia, const Ray& ray, Crossings& found) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    crossings_between(julia, ray, {-infinity, infinity}, found);
}

void crossings_between(const JuliaFractal& julia, const Ray& ray, const Interval& range,
                       Crossings& found) {
    walk(julia, ray, range, Start::anywhere, [&](const Crossing& crossing) {
        found.add(crossing);
        return true;
    });
}

void nearest_crossings(const JuliaFractal& julia, const Ray& ray, const Interval& range,
                       Crossings& found) {
    walk(julia, ray, range, Start::surface, [&](const Crossing& crossing) {
        found.add(crossing);
        return !range.contains(crossing.t);
    });
}

bool inside(const JuliaFractal& julia, const Vec3& point) {
    return dot(point, point) <= julia_radius(julia) * julia_radius(julia) &&
           julia_contains(julia, point);
}

bool is_by_formula(const JuliaFractal& julia) {
    return julia.algebra == hypercomplex_numbers && function_of(julia) != julia_sqr &&
           function_of(julia) != julia_cube;
}

}  // namespace candelabra
