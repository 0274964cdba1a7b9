// SPDX-License-Identifier: GPL-3.0-or-later
// Luminaires of all kinds in all positions for tests.
#pragma once

#include "luminaire/luminaire.h"
#include "support/draw.h"

namespace candelabra {

inline Luminaire glowing(const Emitter& emitter, double radiance = 1) {
    Luminaire result;
    result.emitter = emitter;
    result.radiance = Rgb(radiance);
    result.primitive = 0;
    return result;
}

/// Number of kinds that emitter() can make.
inline constexpr int emitter_kinds = 11;

/// A pyramid without ground, whose edges look round.
inline BuiltShape pyramid(const Vec3& top, const std::array<Vec3, 3>& ground) {
    Mesh mesh;
    mesh.vertices = {top, ground[0], ground[1], ground[2]};
    for (const Vec3& vertex : mesh.vertices)
        mesh.normals.push_back(vertex - 0.25 * (top + ground[0] + ground[1] + ground[2]));
    mesh.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
    return Shared<BuiltMesh>(build(mesh));
}

/// An emitter about as large as `size` near `place`: sphere, triangle, box, disc, ring, cylinder,
/// tube, cone, mesh, rectangle, stretched sphere.
inline Emitter emitter(int kind, const Vec3& place, double size, Draw& draw) {
    const Vec3 a = place + size * draw.direction(), b = place + size * draw.direction(),
               up = draw.direction();
    switch (kind) {
        case 0:
            return SphereEmitter{place, size};
        case 1:
            return TriangleEmitter{a, b, place};
        case 2:
            return AreaEmitter{Cuboid{a, b}, {}};
        case 3:
            return AreaEmitter{Disc{place, up, size, 0}, {}};
        case 4:
            return AreaEmitter{Disc{place, up, size, size / 2}, {}};
        case 5:
            return AreaEmitter{Cylinder{place, a, size / 3, false}, {}};
        case 6:
            return AreaEmitter{Cylinder{place, a, size / 3, true}, {}};
        case 7:
            return AreaEmitter{Cone{place, size / 2, a, size / 5, false}, {}};
        case 8:
            return AreaEmitter{pyramid(place, {a, b, place + size * up}), {}};
        case 9: {
            const auto [x, y] = perpendiculars(up);
            return RectangleEmitter{place, size * x, size / 2 * y};
        }
        default:
            break;
    }
    Transform map =
        Transform::scaling({size, size / 2, size / 4}).then(Transform::rotation(draw.point(180)));
    map = map.then(Transform::translation(place));
    return AreaEmitter{Sphere{Vec3(0), 1}, make_handle<Transform>(map)};
}

/// Density per steradian with which a luminaire, or an emitter, gives this direction from the
/// point; 0 where it cannot.
template <class Light>
double density(const Light& light, const Vec3& from, const Vec3& direction) {
    LightHits met;
    intersect(light, {from, Vec3(0), Horizon::none}, direction, met);
    double sum = 0;
    for (const LightHit& meeting : met) sum += meeting.density;
    return sum;
}

inline Horizon lit_from(bool both_sides) {
    return both_sides ? Horizon::both_sides : Horizon::one_side;
}

/// A point somewhere around an emitter of that place and size: inside, on, near or far.
inline Vec3 point_around(const Vec3& place, double size, Draw& draw) {
    return place +
           size * std::pow(10, draw.between(-1, draw.number() < 0.2 ? 6 : 0.7)) * draw.direction();
}

/// Irradiance from the luminaire by its own samples, over a grid of steps x steps.
inline double sampled_irradiance(const Luminaire& luminaire, const Receiver& point, int steps) {
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const auto s =
                sample(luminaire, point.position, {(i + 0.5) / steps, (j + 0.5) / steps});
            if (!s) continue;
            const double cosine = point.cosine(s->direction);
            if (cosine > 0) sum += cosine / s->density;
        }
    return luminance(luminaire.radiance) * sum / (steps * steps);
}

}  // namespace candelabra
