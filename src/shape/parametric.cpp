// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/parametric.h"

#include "shape/triangle.h"
#include "vocabulary/parts.h"
#include "vocabulary/schema.h"

#include <algorithm>

const ItemInfo Parametric::vocabulary = described<Parametric>([] {
    using F = Field<Parametric>;
    return schema<Parametric>(
        "parametric", "A surface whose points are functions of u and v.",
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

constexpr Interval whole_line{-std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::infinity()};

/// Facets in each direction.
constexpr int fineness = 128;
constexpr std::size_t row = fineness + 1;

bool finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

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

/// Where the ray meets the surface itself, by Newton's method from a place on a facet.
struct Place {
    Vec2 uv;
    double t;
};

std::optional<Place> polished(const BuiltParametric& surface, const Ray& ray, Place from) {
    Place at = from;
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

}  // namespace

Vec3 BuiltParametric::at(const Vec2& uv) const {
    const std::span<const double> arguments(&uv.x, 2);
    return {functions[0]->value(arguments), functions[1]->value(arguments),
            functions[2]->value(arguments)};
}

std::string problem(const Parametric& surface) {
    for (const auto& function : {surface.x, surface.y, surface.z}) {
        if (!function) return "a `parametric` needs three functions";
        // Without names of its own, a function has x, y, z, of which u, v are the first.
        if (function->parameters() != 2 && function->parameters() != 3)
            return "the functions of a `parametric` have the parameters u, v";
    }
    return surface.first.x != surface.last.x && surface.first.y != surface.last.y
               ? ""
               : "a `parametric` needs a range of u and of v";
}

BuiltParametric build(const Parametric& surface) {
    BuiltParametric result;
    result.functions = {surface.x, surface.y, surface.z};
    result.first = surface.first;
    result.step = (surface.last - surface.first) / double{fineness};
    result.container = container_shape(surface.containers);
    for (std::size_t i = 0; i < row * row; ++i)
        result.net.push_back(
            result.at(result.first + result.step * Vec2(static_cast<double>(i % row),
                                                        static_cast<double>(i / row))));
    std::vector<Box> boxes;
    for (std::size_t v = 0; v < fineness; ++v)
        for (std::size_t u = 0; u < fineness; ++u) {
            Box box;
            for (const std::size_t i :
                 {v * row + u, v * row + u + 1, (v + 1) * row + u, (v + 1) * row + u + 1})
                if (finite(result.net[i])) box = join(box, result.net[i]);
            boxes.push_back(box);
        }
    result.index = PartIndex(std::move(boxes));
    return result;
}

Box bounds(const BuiltParametric& surface) {
    return std::visit([](const auto& shape) { return bounds(shape); }, surface.container);
}

void crossings(const BuiltParametric& surface, const Ray& ray, Crossings& found) {
    if (ray.direction == Vec3(0)) return;
    const ShearedRay sheared(ray, Edges::one);
    const auto meet = [&](std::uint32_t part, const std::array<std::size_t, 3>& corners) {
        const auto& net = surface.net;
        const TriangleHit hit =
            sheared.meet(net[corners[0]], net[corners[1]], net[corners[2]], whole_line);
        if (!(hit.t < whole_line.max)) return;
        const auto place = [&](std::size_t i) {
            return Vec2(static_cast<double>(i % row), static_cast<double>(i / row));
        };
        const Vec2 at = (1 - hit.weight2 - hit.weight3) * place(corners[0]) +
                        hit.weight2 * place(corners[1]) + hit.weight3 * place(corners[2]);
        const Place facet{surface.first + surface.step * at, hit.t};
        const Place exact = polished(surface, ray, facet).value_or(facet);
        const auto [by_u, by_v] = slopes(surface, exact.uv);
        const Vec3 normal = unit(cross(by_u, by_v));
        if (normal == Vec3(0) || !finite(normal) || !std::isfinite(exact.t) ||
            !contains(surface.container, ray.at(exact.t)))
            return;
        found.add({exact.t, normal, dot(ray.direction, normal) < 0, part});
    };
    surface.index.along(ray, whole_line, [&](std::uint32_t part) {
        const std::size_t first = part / fineness * row + part % fineness;
        meet(part, {first, first + 1, first + row + 1});
        meet(part, {first, first + row + 1, first + row});
    });
}

bool inside(const BuiltParametric&, const Vec3&) { return false; }

Vec2 parameters_at(const BuiltParametric& surface, const Vec3& point,
                   std::optional<std::uint32_t> part) {
    Vec2 mesh(0.5);
    if (part) {
        mesh += Vec2(*part % fineness, *part / fineness);
    } else {
        const auto off = [&](const Vec3& p) { return length(p - point); };
        const auto nearest = std::ranges::min_element(surface.net, {}, off) - surface.net.begin();
        const auto i = static_cast<std::size_t>(nearest);
        mesh = Vec2(static_cast<double>(i % row), static_cast<double>(i / row));
    }
    Vec2 at = surface.first + surface.step * mesh;
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
