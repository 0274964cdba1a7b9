// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/parametric.h"

#include "base/work_watch.h"
#include "shape/triangle.h"
#include "vocabulary/parts.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace candelabra {

const ItemInfo Parametric::vocabulary = described<Parametric>([] {
    using F = Field<Parametric>;
    return schema<Parametric>(
        "parametric",
        {"A surface whose points are functions of u and v.",
         "parametric { function { (1 + 0.3*cos(v))*cos(u) }, function { 0.3*sin(v) + 0.08*u }, "
         "function { (1 + 0.3*cos(v))*sin(u) } <0, 0>, <2*pi, 2*pi> contained_by { box { -2, 2 } } "
         "translate 0.5*y }",
         "parametric { function { u }, function { 0.3*sin(3*u)*cos(3*v) }, function { v } <-1, "
         "-1>, <1, 1> accuracy 0.001 max_gradient 3 precompute 8 x, y, z translate 0.6*y }"},
        F{"x", &Parametric::x, positional, "x as a function of u, v"},
        F{"y", &Parametric::y, positional, "y as a function of u, v"},
        F{"z", &Parametric::z, positional, "z as a function of u, v"},
        F{"first", &Parametric::first, positional, "least u and v"},
        F{"last", &Parametric::last, positional, "greatest u and v"},
        parts<&Parametric::containers>("contained_by", "box or sphere outside of which is nothing"),
        F{"accuracy", &Parametric::accuracy, item, "accepted, and not needed"},
        F{"max_gradient", &Parametric::max_gradient, item, "accepted, and not needed"},
        F{"precompute", &Parametric::precompute, item, "accepted, and not needed"},
        F{"precompute 1", &Parametric::precomputed1, following, "accepted"},
        F{"precompute 2", &Parametric::precomputed2, following, "accepted"},
        F{"precompute 3", &Parametric::precomputed3, following, "accepted"});
});

namespace {

/// Number of facets in each direction.
constexpr int fineness = 128;
constexpr std::size_t row = fineness + 1;
/// Number of points of the net along a side of a square, and of squares along a side of the net.
constexpr std::size_t side = 8, squares = (row + side - 1) / side;

bool finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Maximum number of divisions of a cell of the net.
constexpr int max_divisions = 12;

bool contains(const ContainerShape& container, const Vec3& p) {
    return std::visit([&](const auto& shape) { return inside(shape, p); }, container);
}

struct Slopes {
    Vec3 by_u, by_v;
};

Slopes slopes(const BuiltParametric& surface, const Vec2& uv) {
    const Vec2 h = 1e-4 * surface.step;
    const Vec2 u(h.x, 0), v(0, h.y);
    return {(surface.at(uv + u) - surface.at(uv - u)) / (2 * h.x),
            (surface.at(uv + v) - surface.at(uv - v)) / (2 * h.y)};
}

/// A place on a facet, the start of Newton's method, or on the surface itself.
struct FacetPlace {
    Vec2 uv;
    double t;
};

std::optional<FacetPlace> polished(const BuiltParametric& surface, const Ray& ray,
                                   FacetPlace from) {
    FacetPlace at = from;
    for (int i = 0; i < 8; ++i) {
        const auto [by_u, by_v] = slopes(surface, at.uv);
        const Vec3 off = ray.at(at.t) - surface.at(at.uv);
        const Vec3 normal = cross(by_u, by_v);
        const double size = -dot(normal, ray.direction);
        if (size == 0) return std::nullopt;
        const double t = dot(normal, off) / size;
        const Vec3 rest = off + t * ray.direction;
        const double n2 = dot(normal, normal);
        const Vec2 move(dot(cross(rest, by_v), normal) / n2, dot(cross(by_u, rest), normal) / n2);
        at = {at.uv + move, at.t + t};
        const Vec2 away = glm::abs(at.uv - from.uv) / glm::abs(surface.step);
        if (!(away.x < 2 && away.y < 2)) return std::nullopt;
        const Vec2 share = glm::abs(move) / glm::abs(surface.step);
        if (share.x < 1e-9 && share.y < 1e-9) return at;
    }
    return at;
}

Box box_of(const ParametricPiece& piece) {
    Box box;
    for (const Vec3& corner : piece.corners)
        if (finite(corner)) box = join(box, corner);
    return box;
}

/// Both halves of a piece, split across its longer direction.
std::array<ParametricPiece, 2> halves(const BuiltParametric& surface, const ParametricPiece& piece,
                                      int divisions) {
    const auto& [a, b, c, d] = piece.corners;
    const double along_u = length(b - a) + length(c - d), along_v = length(d - a) + length(c - b);
    const bool known = std::isfinite(along_u) && std::isfinite(along_v);
    const Vec2 step = piece.step;
    if (known ? along_u > along_v : divisions % 2 == 0) {
        const Vec2 half(0.5 * step.x, step.y), beyond(half.x, 0);
        const Vec3 near = surface.at(piece.first + beyond), far = surface.at(piece.first + half);
        return {ParametricPiece{piece.first, half, {a, near, far, d}},
                {piece.first + beyond, half, {near, b, c, far}}};
    }
    const Vec2 half(step.x, 0.5 * step.y), beyond(0, half.y);
    const Vec3 near = surface.at(piece.first + beyond), far = surface.at(piece.first + half);
    return {ParametricPiece{piece.first, half, {a, b, far, near}},
            {piece.first + beyond, half, {near, far, c, d}}};
}

/// Adds the parts of a piece that are not far from the container. A piece larger than the container
/// is divided; if its parts are still too large, there is a pole and no surface.
void add(BuiltParametric& surface, const ParametricPiece& piece, int divisions) {
    const Box room = bounds(surface), box = box_of(piece);
    const bool whole =
        std::ranges::all_of(piece.corners, [](const Vec3& corner) { return finite(corner); });
    if (box.empty() || (whole && clip(room, box).empty())) return;
    const bool large = length(box.size()) > length(room.size());
    if (divisions > 0 && (large || !whole)) {
        for (const ParametricPiece& half : halves(surface, piece, divisions))
            add(surface, half, divisions - 1);
    } else if (!large) {
        surface.pieces.push_back(piece);
    }
}

}  // namespace

Vec3 BuiltParametric::at(const Vec2& uv) const {
    // Functions without named parameters have a third one; see problem().
    count_work(6);
    const std::array arguments = {uv.x, uv.y, 0.0};
    return {functions[0]->value(arguments), functions[1]->value(arguments),
            functions[2]->value(arguments)};
}

std::string problem(const Parametric& surface) {
    for (const auto& function : {surface.x, surface.y, surface.z}) {
        if (!function) return "a `parametric` needs three functions";
        // A function without named parameters has x, y, z, the first two of which are u, v.
        if (function->parameters() != 2 && function->parameters() != 3)
            return "the functions of a `parametric` have the parameters u, v";
    }
    return {};
}

std::string vanishes(const Parametric& surface) {
    if (surface.first.x == surface.last.x) return "its range of u is empty";
    return surface.first.y == surface.last.y ? "its range of v is empty" : "";
}

BuiltParametric build(const Parametric& surface, const RayIndex& index) {
    BuiltParametric result;
    result.functions = {surface.x, surface.y, surface.z};
    result.first = surface.first;
    result.step = (surface.last - surface.first) / double{fineness};
    result.container = container_shape(surface.containers);
    for (std::size_t i = 0; i < row * row; ++i)
        result.net.push_back(
            result.at(result.first + result.step * Vec2(static_cast<double>(i % row),
                                                        static_cast<double>(i / row))));
    result.net_boxes.resize(squares * squares);
    for (std::size_t i = 0; i < row * row; ++i) {
        Box& box = result.net_boxes[i / row / side * squares + i % row / side];
        box = join(box, result.net[i]);
    }
    for (std::size_t v = 0; v < fineness; ++v)
        for (std::size_t u = 0; u < fineness; ++u) {
            const std::size_t i = v * row + u;
            const Vec2 first = result.first + result.step * Vec2(u, v);
            const auto& net = result.net;
            add(result, {first, result.step, {net[i], net[i + 1], net[i + row + 1], net[i + row]}},
                max_divisions);
        }
    std::vector<Box> boxes;
    for (const ParametricPiece& piece : result.pieces) boxes.push_back(box_of(piece));
    result.index = PartIndex(std::move(boxes), index);
    return result;
}

Box bounds(const BuiltParametric& surface) {
    return std::visit([](const auto& shape) { return bounds(shape); }, surface.container);
}

void crossings(const BuiltParametric& surface, const Ray& ray, Crossings& found) {
    if (ray.direction == Vec3(0)) return;
    const ShearedRay sheared(ray, Edges::one);
    const auto meet = [&](std::uint32_t part, bool upper) {
        const auto& [a, b, c, d] = surface.pieces[part].corners;
        const TriangleHit hit = sheared.meet(a, upper ? c : b, upper ? d : c, whole_line);
        if (!(hit.t < whole_line.max)) return;
        // Position within the piece.
        const Vec2 at = upper ? Vec2(hit.weight2, hit.weight2 + hit.weight3)
                              : Vec2(hit.weight2 + hit.weight3, hit.weight3);
        const FacetPlace facet{surface.pieces[part].first + surface.pieces[part].step * at, hit.t};
        const FacetPlace exact = polished(surface, ray, facet).value_or(facet);
        const auto [by_u, by_v] = slopes(surface, exact.uv);
        const Vec3 normal = unit(cross(by_u, by_v));
        if (normal == Vec3(0) || !finite(normal) || !std::isfinite(exact.t) ||
            !contains(surface.container, ray.at(exact.t)))
            return;
        found.add({exact.t, normal, dot(ray.direction, normal) < 0, part});
    };
    surface.index.along(ray, whole_line, [&](std::uint32_t part) {
        meet(part, false);
        meet(part, true);
    });
}

bool inside(const BuiltParametric&, const Vec3&) { return false; }

namespace {

/// Number of the point of the net that is nearest to a point; the first one of equals.
std::size_t nearest_of_net(const BuiltParametric& surface, const Vec3& point) {
    std::array<double, squares * squares> off;
    for (std::size_t i = 0; i < off.size(); ++i)
        off[i] = std::sqrt(nearest_distance2(surface.net_boxes[i], point));
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    const auto search = [&](std::size_t square) {
        if (!(off[square] <= least)) return;
        const std::size_t first_v = square / squares * side, first_u = square % squares * side;
        for (std::size_t v = first_v; v < std::min(first_v + side, row); ++v)
            for (std::size_t u = first_u; u < std::min(first_u + side, row); ++u) {
                const std::size_t i = v * row + u;
                const double here = length(surface.net[i] - point);
                if (here < least || (here == least && i < nearest)) least = here, nearest = i;
            }
    };
    const auto closest = std::ranges::min_element(off) - off.begin();
    search(static_cast<std::size_t>(closest));
    for (std::size_t i = 0; i < off.size(); ++i) search(i);
    return nearest;
}

}  // namespace

Vec2 parameters_at(const BuiltParametric& surface, const Vec3& point,
                   std::optional<std::uint32_t> part) {
    Vec2 at;
    if (part) {
        at = surface.pieces[*part].middle();
    } else {
        const std::size_t i = nearest_of_net(surface, point);
        at = surface.first + surface.step * Vec2(0.5 + static_cast<double>(i % row),
                                                 0.5 + static_cast<double>(i / row));
    }
    for (int i = 0; i < 8; ++i) {
        const auto [by_u, by_v] = slopes(surface, at);
        const Vec3 off = point - surface.at(at), normal = cross(by_u, by_v);
        const double size = dot(normal, normal);
        if (!(size > 0) || !std::isfinite(size)) break;
        const Vec2 move(dot(cross(off, by_v), normal) / size, dot(cross(by_u, off), normal) / size);
        at += glm::clamp(move, -2.0 * glm::abs(surface.step), 2.0 * glm::abs(surface.step));
    }
    return at;
}

}  // namespace candelabra
