// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/warp.h"

#include "base/elementary.h"
#include "base/revolution.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <numbers>

namespace candelabra {

const ItemInfo CylindricalWarp::vocabulary = described<CylindricalWarp>([] {
    using F = Field<CylindricalWarp>;
    return schema<CylindricalWarp>(
        "cylindrical",
        {"Wraps the plane around the y axis: once for a width of 1.",
         "pigment { checker scale 0.1 warp { cylindrical orientation z dist_exp 1 } }"},
        F{"orientation", &CylindricalWarp::orientation, item, "normal of the plane"},
        F{"dist_exp", &CylindricalWarp::dist_exp, item,
          "power of the distance by which the map is stretched"});
});

const ItemInfo SphericalWarp::vocabulary = described<SphericalWarp>([] {
    using F = Field<SphericalWarp>;
    return schema<SphericalWarp>(
        "spherical",
        {"Wraps the plane around a sphere: once for a square of 1.",
         "pigment { brick scale 0.06 warp { spherical } }",
         "pigment { checker scale 0.1 warp { spherical orientation z dist_exp 1 } }"},
        F{"orientation", &SphericalWarp::orientation, item, "normal of the plane"},
        F{"dist_exp", &SphericalWarp::dist_exp, item,
          "power of the distance by which the map is stretched"});
});

const ItemInfo ToroidalWarp::vocabulary = described<ToroidalWarp>([] {
    using F = Field<ToroidalWarp>;
    return schema<ToroidalWarp>(
        "toroidal",
        {"Wraps the plane around a ring: once for a square of 1.",
         "pigment { checker scale 0.1 warp { toroidal orientation z dist_exp 1 major_radius 0.8 } "
         "}"},
        F{"orientation", &ToroidalWarp::orientation, item, "normal of the plane"},
        F{"dist_exp", &ToroidalWarp::dist_exp, item,
          "power of the distance by which the map is stretched"},
        F{"major_radius", &ToroidalWarp::major_radius, item, "radius of the ring"});
});

const ItemInfo PlanarWarp::vocabulary = described<PlanarWarp>([] {
    using F = Field<PlanarWarp>;
    return schema<PlanarWarp>(
        "planar",
        {"Takes the pattern of a plane everywhere.",
         "pigment { onion scale 0.3 warp { planar z, 0 } }"},
        maybe(F{"orientation", &PlanarWarp::orientation, positional, "normal of the plane"}),
        maybe(F{"distance", &PlanarWarp::distance, positional, "of the plane"}));
});

const ItemInfo CubicWarp::vocabulary = described<CubicWarp>([] {
    return schema<CubicWarp>("cubic", {"Wraps the plane around a cube, as the cross of 4 by 3.",
                                       "pigment { checker scale 0.1 warp { cubic } }"});
});

const ItemInfo TurbulenceWarp::vocabulary = described<TurbulenceWarp>([] {
    using F = Field<TurbulenceWarp>;
    return schema<TurbulenceWarp>(
        "turbulence",
        {"Displaces points by noise, in its place among the transformations.",
         "pigment { checker warp { turbulence 0.4 } scale 0.3 }",
         "pigment { checker warp { turbulence 0.4 octaves 4 omega 0.6 lambda 2.5 } scale 0.3 }"},
        F{"amount", &TurbulenceWarp::amount, positional, "how far, along each axis"},
        F{"octaves", &TurbulenceWarp::octaves, item,
          "terms of the sum; below 1 counts as 1, above 10 as 10"},
        F{"omega", &TurbulenceWarp::omega, item, "size of each octave over the one before"},
        F{"lambda", &TurbulenceWarp::lambda, item, "frequency of each octave over the one before"});
});

const ItemInfo RepeatWarp::vocabulary = described<RepeatWarp>([] {
    using F = Field<RepeatWarp>;
    return schema<RepeatWarp>(
        "repeat",
        {"Repeats a slice of space along one axis.",
         "pigment { spherical warp { repeat x offset 0.2*y } scale 0.5 }",
         "pigment { agate scale 0.3 warp { repeat 0.5*x flip x } }"},
        F{"width", &RepeatWarp::width, positional,
          "axis and thickness of the slice: two components are 0"},
        F{"offset", &RepeatWarp::offset, item, "shifts each repeat against the one before"},
        F{"flip", &RepeatWarp::flip, item,
          "mirrors every other repeat along the axes that are not 0"});
});

const ItemInfo BlackHole::vocabulary = described<BlackHole>([] {
    using F = Field<BlackHole>;
    return schema<BlackHole>(
        "black_hole",
        {"Draws what is in a sphere together, or apart.",
         "pigment { checker warp { black_hole 0, 2 strength 1.2 } scale 0.4 }",
         "pigment { checker scale 0.3 warp { black_hole <0.4, 0.4, 0>, 0.5 falloff 2 strength 0.8 "
         "repeat <1, 1, 0> turbulence 0.1 inverse } }",
         "pigment { checker scale 0.3 warp { black_hole 0, 1 type 0 } }"},
        F{"centre", &BlackHole::centre, positional, "middle of the sphere"},
        F{"radius", &BlackHole::radius, positional, "radius of the hole", above(0)},
        F{"strength", &BlackHole::strength, item, "how strong it is in the middle"},
        F{"falloff", &BlackHole::falloff, item, "power by which it weakens outwards"},
        F{"repeat", &BlackHole::repeat, item, "distances at which it is repeated; 0: not"},
        F{"turbulence", &BlackHole::turbulence, item, "how far each repeat is moved at random"},
        F{"type", &BlackHole::type, item, "0; others have no effect"},
        F{"inverse", &BlackHole::inverse, flag, "drives apart what it would draw together"});
});

namespace {

using std::numbers::pi;

/// Precision is lost beyond this distance.
constexpr double farthest = 1e17;

double limited(double x) { return x > farthest ? farthest : x >= -farthest ? x : -farthest; }

/// Rotates u, v, w so that the map's plane faces the orientation.
Vec3 oriented(const Vec3& orientation, double u, double v, double w) {
    const Vec3 n = unit(orientation);
    return {n.x * w + n.y * u + n.z * u, n.x * v - n.y * w + n.z * v, -n.x * u + n.y * v + n.z * w};
}

double stretch(const MapWarp& warp, double distance) {
    return warp.dist_exp == 0 ? 1 : math::pow(distance, warp.dist_exp);
}

Vec3 warped(const TurbulenceWarp& warp, const Vec3& p) {
    const Octaves octaves = {warp.octaves, static_cast<float>(warp.omega),
                             static_cast<float>(warp.lambda)};
    return p + warp.amount * turbulence(p, octaves);
}

Vec3 warped(const RepeatWarp& warp, const Vec3& p) {
    const int axis = warp.width.x != 0 ? 0 : warp.width.y != 0 ? 1 : 2;
    const double width = single_precision(warp.width[axis]);
    if (width == 0) return p;
    const double count = std::floor(p[axis] / width);
    Vec3 result = p;
    result[axis] -= count * width;
    if (std::fmod(std::abs(count), 2) == 1) {
        for (int i = 0; i < 3; ++i)
            if (warp.flip[i] != 0) result[i] = -result[i];
        if (warp.flip[axis] != 0) result[axis] += width;
    }
    return result + count * warp.offset;
}

Vec3 warped(const BlackHole& hole, const Vec3& p) {
    Vec3 centre = hole.centre;
    if (hole.repeat != Vec3(0)) {
        Vec3 block(0);
        for (int i = 0; i < 3; ++i)
            if (hole.repeat[i] >= 1e-10) block[i] = std::floor(p[i] / hole.repeat[i]);
        if (hole.turbulence != Vec3(0)) {
            const auto whole = [&](int i) { return static_cast<std::int64_t>(limited(block[i])); };
            const std::size_t hash = cell_hash(whole(0), whole(1), whole(2));
            const auto random = random_table().subspan(hash, 3);
            centre += hole.turbulence * Vec3(random[0], random[1], random[2]);
        }
        centre += hole.repeat * block;
    }
    const Vec3 away = p - centre;
    // Avoids the square root for most points.
    constexpr double surely_outside = 1.0001;
    if (dot(away, away) > surely_outside * hole.radius * hole.radius) return p;
    const double distance = length(away);
    if (distance >= hole.radius || hole.type != 0) return p;
    const double share = math::pow((hole.radius - distance) / hole.radius, hole.falloff);
    const double force = std::min(1.0, hole.strength * share);
    return hole.inverse ? p - force * away : p + force * away;
}

Vec3 warped(const CylindricalWarp& warp, const Vec3& p) {
    const double distance = std::sqrt(p.x * p.x + p.z * p.z);
    if (distance == 0) return p;
    return oriented(warp.orientation, turn(p.x, p.z) * stretch(warp, distance), p.y, distance);
}

Vec3 warped(const SphericalWarp& warp, const Vec3& p) {
    const double distance = length(p);
    if (distance == 0) return p;
    const double height = 0.5 + math::asin(std::clamp(p.y / distance, -1.0, 1.0)) / pi;
    const double around = p.x == 0 && p.z == 0 ? 0 : turn(p.x, p.z);
    const double factor = stretch(warp, distance);
    return oriented(warp.orientation, around * factor, height * factor, distance);
}

Vec3 warped(const ToroidalWarp& warp, const Vec3& p) {
    const double away = std::sqrt(p.x * p.x + p.z * p.z);
    if (away == 0) return p;
    const double outwards = away - warp.major_radius;
    const double distance = std::sqrt(outwards * outwards + p.y * p.y);
    if (distance == 0) return p;
    const double factor = stretch(warp, distance);
    return oriented(warp.orientation, turn(p.x, p.z) * factor, turn_of_tube(outwards, p.y) * factor,
                    distance);
}

Vec3 warped(const PlanarWarp& warp, const Vec3& p) {
    return oriented(warp.orientation, p.x, p.y, warp.distance);
}

/// The faces of the cube form a cross: +y, +z, -y in the second column, -x, +z, +x, -z in the
/// middle row.
Vec3 warped(const CubicWarp&, const Vec3& p) {
    const auto half = [](double t) { return (t + 1) / 2; };
    const Vec3 size = glm::abs(p);
    if (p == Vec3(0)) return p;
    if (p.x >= 0 && p.x >= size.y && p.x >= size.z)
        return {0.75 - 0.25 * half(p.z / p.x), (1 + half(p.y / p.x)) / 3, p.x};
    if (p.y >= 0 && p.y >= size.x && p.y >= size.z)
        return {0.25 + 0.25 * half(p.x / p.y), 1 - half(p.z / p.y) / 3, p.y};
    if (p.z >= 0 && p.z >= size.x && p.z >= size.y)
        return {0.25 + 0.25 * half(p.x / p.z), (1 + half(p.y / p.z)) / 3, p.z};
    if (p.x < 0 && size.x >= size.y && size.x >= size.z)
        return {0.25 * half(p.z / size.x), (1 + half(p.y / size.x)) / 3, size.x};
    if (p.y < 0 && size.y >= size.x && size.y >= size.z)
        return {0.25 + 0.25 * half(p.x / size.y), half(p.z / size.y) / 3, size.y};
    return {1 - 0.25 * half(p.x / size.z), (1 + half(p.y / size.z)) / 3, size.z};
}

}  // namespace

Vec3 warped(const Warp& warp, const Vec3& point) {
    return std::visit([&](const auto& kind) { return warped(kind, point); }, warp);
}

Vec3 within_reach(const Vec3& p) { return {limited(p.x), limited(p.y), limited(p.z)}; }

Vec3 undone(const WarpStep& step, const Vec3& point) {
    if (const auto* transform = std::get_if<Transform>(&step))
        return transform->inverse_point(point);
    return within_reach(warped(std::get<Warp>(step), point));
}

Vec3 warped(std::span<const WarpStep> steps, Vec3 point) {
    for (std::size_t i = steps.size(); i-- > 0;) point = undone(steps[i], point);
    return within_reach(point);
}

void fit_blocks(BlackHole& hole) {
    for (int i = 0; i < 3; ++i) {
        if (!(hole.repeat[i] > 0)) continue;
        hole.centre[i] = std::max(hole.centre[i], hole.radius);
        hole.repeat[i] =
            std::max(hole.repeat[i], hole.centre[i] + hole.radius + hole.turbulence[i]);
    }
}

}  // namespace candelabra
