// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/isosurface.h"

#include "shape/line_search.h"
#include "vocabulary/parts.h"
#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo Container::vocabulary = described<Container>([] {
    return schema<Container>("contained_by", "What a surface is cut off by.",
                             parts<&Container::boxes>("box", "a box"),
                             parts<&Container::spheres>("sphere", "a sphere"));
});

const ItemInfo Isosurface::vocabulary = described<Isosurface>([] {
    using F = Field<Isosurface>;
    return schema<Isosurface>(
        "isosurface",
        {"Where a function of x, y, z has a value.",
         "isosurface { function { x*x + y*y + z*z - 1 + 0.2*sin(9*x)*sin(9*y)*sin(9*z) } "
         "max_gradient 5 contained_by { sphere { 0, 1.3 } } translate 1.1*y }",
         "isosurface { function { abs(x) + abs(y) + abs(z) } threshold 1 accuracy 0.001 evaluate "
         "2, 1.2, 0.99 contained_by { box { -1, 1 } } open translate y }",
         "isosurface { function { 1 - x*x - y*y - z*z } polarity 1 max_gradient 4 max_trace 4 "
         "contained_by { box { -1, 1 } } translate y }",
         "isosurface { function { x*x + z*z - 0.2 } max_gradient 4 all_intersections contained_by "
         "{ box { -1, 1 } } translate y }"},
        F{"function", &Isosurface::function, positional, "the function; inside it is lower"},
        parts<&Isosurface::containers>("contained_by", "box or sphere that closes the surface"),
        F{"threshold", &Isosurface::threshold, item, "value on the surface"},
        F{"polarity", &Isosurface::polarity, item, "above 0: inside it is higher"},
        F{"accuracy", &Isosurface::accuracy, item,
          "size of the smallest detail; not above 0: the usual one"},
        F{"max_gradient", &Isosurface::max_gradient, item,
          "greatest slope of a function that is not written out, and near poles; not above 0: "
          "the usual one"},
        F{"evaluate", &Isosurface::evaluate1, item, "accepted, and not needed"},
        F{"evaluate 2", &Isosurface::evaluate2, following, "accepted"},
        F{"evaluate 3", &Isosurface::evaluate3, following, "accepted"},
        F{"max_trace", &Isosurface::max_trace, item, "accepted: all crossings are found"},
        F{"all_intersections", &Isosurface::all_intersections, flag, "accepted, and always so"},
        F{"open", &Isosurface::open, flag, "leaves out the surface of the container"});
});

namespace {

/// Below 0 inside, or not a number.
double value_at(const BuiltIsosurface& surface, const Vec3& p) {
    const double above = surface.function->value(std::span(&p.x, 3)) - surface.threshold;
    return surface.inside_is_higher ? -above : above;
}

/// Bounds of values and slopes along a ray whose direction has length 1.
Enclosure within(const BuiltIsosurface& surface, const Ray& ray, const Interval& range) {
    const Bounds promised{-surface.max_gradient, surface.max_gradient};
    if (!surface.function->written()) return {all_numbers, promised};
    const Vec3 first = ray.at(range.min), last = ray.at(range.max);
    std::array<Enclosure, 3> arguments;
    for (int i = 0; i < 3; ++i)
        arguments[static_cast<std::size_t>(i)] = {
            {std::fmin(first[i], last[i]), std::fmax(first[i], last[i])},
            {ray.direction[i], ray.direction[i]}};
    Enclosure result;
    if (!surface.function->enclose(arguments.data(), &result)) return {all_numbers, promised};
    result.value = result.value - Bounds{surface.threshold, surface.threshold};
    if (surface.inside_is_higher) {
        const Bounds zero{0, 0};
        result = {zero - result.value, zero - result.slope};
    }
    // Near a pole, or where the function has no value, the scene's bounds are better.
    if (result == Enclosure::unknown()) result.slope = promised;
    return result;
}

/// Unit normal where the ray enters or leaves, from the gradient of the function.
Vec3 normal_at(const BuiltIsosurface& surface, const Vec3& p, const Vec3& direction,
               bool entering) {
    const double step = 1e-6 * length(bounds(surface).size());
    Vec3 slope;
    for (int i = 0; i < 3; ++i) {
        Vec3 aside(0);
        aside[i] = step;
        slope[i] = value_at(surface, p + aside) - value_at(surface, p - aside);
    }
    return normal_against(slope, direction, entering);
}

/// Where the ray enters and leaves the container, with its normals there. As in POV-Ray, a
/// container without a size in all directions is empty.
std::optional<std::array<Crossing, 2>> stay(const BuiltIsosurface& surface, const Ray& ray) {
    Crossings walls;
    std::visit([&](const auto& shape) { crossings(shape, ray, walls); }, surface.container);
    const Vec3 size = bounds(surface).size();
    if (walls.size() != 2 || !(size.x > 0 && size.y > 0 && size.z > 0)) return std::nullopt;
    std::array<Crossing, 2> both{walls[0], walls[1]};
    if (both[0].t > both[1].t) std::swap(both[0], both[1]);
    return both;
}

enum class RootsWanted { all, nearest };

/// Finds the crossings in the range, or the nearest of them, and possibly others.
void search(const BuiltIsosurface& surface, const Ray& ray, const Interval& range, RootsWanted how,
            Crossings& found) {
    const double speed = length(ray.direction);
    if (!(speed > 0)) return;
    // Computed from the point nearest to the middle, so that a distant origin loses no digits.
    const Vec3 u = ray.direction / speed;
    const double start = dot(bounds(surface).centre() - ray.origin, u);
    const Ray near{ray.origin + start * u, u};
    const Interval wanted{range.min * speed - start, range.max * speed - start};
    const auto walls = stay(surface, near);
    if (!walls || (*walls)[0].t > wanted.max || (*walls)[1].t < wanted.min) return;
    const Crossing &first = (*walls)[0], &last = (*walls)[1];
    const auto add = [&](double t, const Vec3& normal, bool entering) {
        found.add({(start + t) / speed, normal, entering});
    };
    const auto at = [&](double t) { return value_at(surface, near.at(t)); };
    const auto slopes = [&](const Interval& part) { return within(surface, near, part); };
    const bool nearest = how == RootsWanted::nearest;
    if (!surface.open && first.t > wanted.min && is_below(at(first.t))) {
        add(first.t, first.normal, true);
        if (nearest) return;
    }
    bool met = false;
    const auto changes = nearest ? nearest_changes : changes_between;
    for (const SignChange& change :
         changes({at, slopes}, {first.t, last.t}, surface.accuracy, wanted)) {
        add(change.t, normal_at(surface, near.at(change.t), u, change.below), change.below);
        met |= nearest && change.t > wanted.min;
    }
    if (!met && !surface.open && last.t < wanted.max && is_below(at(last.t)))
        add(last.t, last.normal, false);
}

}  // namespace

ContainerShape container_shape(const std::vector<Container>& containers) {
    ContainerShape result = Cuboid{Vec3(-1), Vec3(1)};
    for (const Container& each : containers) {
        if (!each.boxes.empty()) result = each.boxes.back();
        if (!each.spheres.empty()) result = each.spheres.back();
    }
    return result;
}

std::string problem(const Isosurface& surface) {
    if (!surface.function) return "an `isosurface` needs a function";
    if (surface.function->parameters() != 3)
        return "the function of an `isosurface` has three parameters, but this one has " +
               std::to_string(surface.function->parameters());
    return "";
}

BuiltIsosurface build(const Isosurface& surface) {
    const auto positive = [](double value, double usual) { return value > 0 ? value : usual; };
    const Isosurface usual;
    return {surface.function,
            container_shape(surface.containers),
            surface.threshold,
            positive(surface.accuracy, usual.accuracy),
            positive(surface.max_gradient, usual.max_gradient),
            surface.open,
            surface.polarity > 0};
}

Box bounds(const BuiltIsosurface& surface) {
    return std::visit([](const auto& shape) { return bounds(shape); }, surface.container);
}

void nearest_crossings(const BuiltIsosurface& surface, const Ray& ray, const Interval& range,
                       Crossings& found) {
    search(surface, ray, range, RootsWanted::nearest, found);
}

void crossings_between(const BuiltIsosurface& surface, const Ray& ray, const Interval& range,
                       Crossings& found) {
    search(surface, ray, range, RootsWanted::all, found);
}

void crossings(const BuiltIsosurface& surface, const Ray& ray, Crossings& found) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    crossings_between(surface, ray, {-infinity, infinity}, found);
}

bool inside(const BuiltIsosurface& surface, const Vec3& point) {
    return std::visit([&](const auto& shape) { return inside(shape, point); }, surface.container) &&
           !(value_at(surface, point) > 0);
}

}  // namespace candelabra
