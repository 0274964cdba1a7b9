// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/bump.h"

#include "surface/map_place.h"
#include "surface/normal_map.h"
#include "surface/normal_space.h"
#include "surface/pigment.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <numbers>

namespace candelabra {

const ItemInfo BumpSettings::vocabulary = described<BumpSettings>([] {
    using F = Field<BumpSettings>;
    return schema<BumpSettings>(
        "normal",
        {"Bumps by a pattern: the name of a pattern, then these.",
         "normal { bumps 0.8 scale 0.15 }",
         "normal { dents 1.5 scale 0.15 }",
         "normal { wrinkles 1 scale 0.3 }",
         "normal { ripples 4 scale 0.15 }",
         "normal { waves 3 scale 0.15 }",
         "normal { quilted 1.2 scale 0.3 }",
         "normal { granite 0.4 scale 0.5 accuracy 0.01 }",
         "normal { crackle 0.8 scale 0.25 }",
         "normal { leopard 0.8 scale 0.05 bump_size 0.5 }",
         "normal { brick 0.6 scale 0.06 }",
         "normal { onion 0.8 sine_wave scale 0.15 }",
         "normal { hexagon 0.6 rotate 90*x scale 0.15 }",
         "normal { marble 0.6 turbulence 0.5 scale 0.3 }",
         "normal { wood 0.8 sine_wave scale 0.2 }",
         "normal { gradient x 1 slope_map { [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] } scale 0.3 }",
         "normal { gradient y normal_map { [0.5 bumps 1 scale 0.1] [0.5 dents 1.5 scale 0.1] } "
         "translate 0.5*y }",
         "normal { average normal_map { [1 ripples 1 scale 0.1] [1 granite 0.5] } }",
         "normal { spiral1 5 1 rotate 90*x scale 0.3 }",
         "normal { bumps 0.8 scale 0.15 no_bump_scale }"},
        maybe(F{"amount", &BumpSettings::bump_size, positional, "height of the bumps"}),
        F{"bump_size", &BumpSettings::bump_size, item,
          "depth of the bumps, another name of amount"},
        F{"accuracy", &BumpSettings::accuracy, item,
          "distance over which the pattern's slope is measured", above(0)},
        F{"no_bump_scale", &BumpSettings::no_bump_scale, flag,
          "bumps get flatter when the pattern is scaled up"});
});

namespace {

/// A place in the pattern's space with the context of its evaluation.
struct BumpPoint {
    const PatternedBump& bump;
    Vec3 normal;
    Vec3 place;
    const PatternScene& scene;
    bool keep_length;  ///< intermediate normals are not normalised

    double amount() const { return single_precision(bump.settings.bump_size); }
    const PatternModifiers& modifiers() const { return bump.use.modifiers; }
};

// For each kind of pattern that has its own formula for normals, a function returns the new normal.

Vec3 tilted(const Bumps&, const BumpPoint& at) {
    return at.normal + at.amount() * vector_noise(at.place);
}

Vec3 tilted(const Dents& dents, const BumpPoint& at) {
    const double depth = evaluate(dents, PatternPoint{at.place, at.modifiers(), at.scene});
    return at.normal + at.amount() * depth * vector_noise(at.place);
}

Vec3 tilted(const Wrinkles&, const BumpPoint& at) {
    Vec3 sum(0);
    double frequency = 1;
    for (int i = 0; i < 10; ++i, frequency *= 2)
        sum += glm::abs(vector_noise(frequency * at.place)) / frequency;
    return at.normal + at.amount() * sum;
}

Vec3 tilted(const Quilted& quilted, const BumpPoint& at) {
    return at.normal + at.amount() * quilted_tilt(quilted, at.place);
}

/// Rings of all sources; `own` is whether each source has its own frequency.
Vec3 tilted_by_rings(const BumpPoint& at, bool own) {
    Vec3 normal = at.normal;
    const auto sources = wave_sources(at.scene.number_of_waves);
    for (const WaveSource& source : sources) {
        const Vec3 away = at.place - source.centre;
        const double distance = length(away) == 0 ? 1 : length(away);
        const double frequency = own ? source.frequency : 1;
        const double height = ring(at.modifiers(), frequency, distance) / frequency;
        normal += at.amount() * height / (static_cast<double>(sources.size()) * distance) * away;
    }
    return normal;
}

Vec3 tilted(const Ripples&, const BumpPoint& at) { return tilted_by_rings(at, false); }
Vec3 tilted(const Waves&, const BumpPoint& at) { return tilted_by_rings(at, true); }

Vec3 tilted(const Facets& facets, const BumpPoint& at) {
    const Vec3 normal = unit(at.normal);
    const double closeness = facets.size < 1e-6 ? 1e6 : 1 / facets.size;
    const bool by_place = facets.coords != 0;
    const Vec3 nucleus =
        nearest_nucleus(within_reach(closeness * (by_place ? at.place : normal)), facets.metric);
    if (!by_place) return nucleus;
    Vec3 tilt = vector_noise(nucleus);
    tilt -= dot(tilt, normal) * normal;
    return normal + facets.coords * tilt;
}

/// Turns a direction of tangent space around the normal. The axes of the picture are perpendicular
/// to the normal, and to each other.
Vec3 turned(const Vec3& direction, const Vec3& normal, const SurfaceAxes& axes, const Vec2& sides) {
    Vec3 right = cross(axes.y, normal);
    if (dot(right, sides.x * axes.x) < 0) right = -right;
    Vec3 up = cross(normal, right);
    if (dot(up, sides.y * axes.y) < 0) up = -up;
    if (right == Vec3(0)) return normal;
    // A bump is a dent from behind.
    const double side = axes.behind ? -1 : 1;
    constexpr double least = 1.0 / 255;
    return side * (direction.x * unit(right) + direction.y * unit(up)) +
           std::max(direction.z, least) * normal;
}

/// The normal by a picture in tangent space. `axes` are those of the place, in the normal's space.
Vec3 turned(const BumpMap& map, const BumpPoint& at, const SurfaceAxes& axes) {
    const std::optional<Vec3> found = direction_at(map, at.place);
    if (!found) return at.normal;
    const Vec3 flat(at.amount() * found->x, at.amount() * found->y, found->z);
    return turned(flat, unit(at.normal), axes, map.repeat);
}

Vec3 tilted(const BumpMap& map, const BumpPoint& at) {
    if (map.tangent_space) return turned(map, at, at.scene.axes ? *at.scene.axes : SurfaceAxes());
    const std::optional<Vec3> bump = bump_at(map, at.place, at.amount());
    if (!bump) return at.normal;
    Vec3 up = at.normal, across = cross(up, Vec3(0, 1, 0));
    if (length(across) < 1e-10) {
        up = Vec3(0, std::abs(up.y - 1) < 1e-10 ? 1 : -1, 0);
        across = Vec3(1, 0, 0);
    }
    across = unit(across);
    return bump->x * across + bump->y * up - bump->z * unit(cross(across, up));
}

/// Perturbs a normal by a pattern that has only a value: by the slope of the value, measured
/// towards the corners of a tetrahedron.
Vec3 tilted_by_slope(const BumpPoint& at) {
    using std::numbers::sqrt2;
    constexpr double third = 1.0 / 3, wide = 2 * sqrt2 / 3, deep = 0.816496581;
    constexpr auto corners = std::array{Vec3(wide, -third, 0), Vec3(-wide / 2, -third, deep),
                                        Vec3(-wide / 2, -third, -deep), Vec3(0, 1, 0)};
    const double step = single_precision(at.bump.settings.accuracy);
    const auto* slopes = std::get_if<SlopeMap>(&at.bump.map);
    Vec3 rise(0);
    for (const Vec3& corner : corners) {
        const double value = at.bump.use.value(at.place + step * corner, at.scene);
        rise += (slopes ? look_up(*slopes, value) : value) * corner;
    }
    return at.normal - 0.1 * at.amount() / step * rise;
}

Vec3 changed(const Bump&, const Vec3& normal, const Vec3& point, const PatternScene&,
             bool keep_length);

Vec3 averaged(const NormalMap& map, const BumpPoint& at) {
    Vec3 sum(0);
    double total = 0;
    for (const NormalStop& stop : map) {
        sum += stop.value * changed(stop.bump, at.normal, at.place, at.scene, at.keep_length);
        total += stop.value;
    }
    return sum / total;
}

Vec3 mixed(const NormalMap& map, const BumpPoint& at) {
    if (std::holds_alternative<Average>(at.bump.use.pattern)) return averaged(map, at);
    const MapPlace place = place_in(map, at.bump.use.value(at.place, at.scene));
    const auto entry = [&](std::size_t i) {
        return changed(map[i].bump, at.normal, at.place, at.scene, at.keep_length);
    };
    const Vec3 below = entry(place.below);
    if (place.share == 0) return below;
    return below + place.share * (entry(place.above) - below);
}

Vec3 tilted(const BumpPoint& at) {
    if (const auto* map = std::get_if<NormalMap>(&at.bump.map)) return mixed(*map, at);
    return std::visit(
        [&](const auto& kind) {
            if constexpr (requires { tilted(kind, at); })
                return tilted(kind, at);
            else
                return tilted_by_slope(at);
        },
        at.bump.use.pattern);
}

Vec3 changed(const Bump& bump, const Vec3& normal, const Vec3& point, const PatternScene& scene,
             bool keep_length) {
    if (!bump.pattern) return normal;
    const PatternedBump& pattern = *bump.pattern;
    const bool keep = keep_length || pattern.settings.no_bump_scale;
    const NormalSpace space(pattern.use.steps, bump.transform, bump.frame.get());
    const auto made_unit = [&](const Vec3& n) { return keep ? n : unit(n); };
    const Vec3 place =
        pattern.use.place(bump.transform.inverse_point(bump.uv ? uv_place(scene) : point));
    PatternScene inside = scene;
    SurfaceAxes axes;
    if (scene.axes) {
        const auto* map = std::get_if<BumpMap>(&pattern.use.pattern);
        // Steps in u and v turn the picture, and not the space of the surface.
        if (map && map->tangent_space && (bump.uv || scene.axes->by_uv))
            return made_unit(turned(*map, {pattern, normal, place, scene, keep},
                                    space.placed(*scene.axes, bump.uv)));
        axes = space.enter(*scene.axes, bump.uv);
        inside.axes = &axes;
    }
    const BumpPoint at{pattern, made_unit(space.enter(made_unit(normal))), place, inside, keep};
    return made_unit(space.leave(made_unit(tilted(at))));
}

}  // namespace

PatternedBump::PatternedBump(PatternUse the_use, const BumpSettings& the_settings, Map the_map)
    : use(std::move(the_use)), settings(the_settings), map(std::move(the_map)) {
    nesting = candelabra::nesting(use);
    ++nesting.entries;
    if (const auto* normals = std::get_if<NormalMap>(&map))
        for (const NormalStop& stop : *normals) nesting.add(candelabra::nesting(stop.bump));
}

Nesting nesting(const Bump& bump) {
    if (!bump.pattern) return {};
    Nesting result = bump.pattern->nesting;
    result.uv |= bump.uv;
    return result;
}

double look_up(const SlopeMap& map, double value) {
    const MapPlace at = place_in(map, value);
    const SlopeStop &p = map[at.below], &q = map[at.above];
    if (at.share == 0) return p.height;
    const double t = at.share, rise = q.height - p.height;
    return t * t * t * (p.slope + q.slope - 2 * rise) - t * t * (2 * p.slope + q.slope - 3 * rise) +
           t * p.slope + p.height;
}

Vec3 bumped(const Bump& bump, const Vec3& normal, const Vec3& point, const PatternScene& scene) {
    return unit(changed(bump, normal, point, scene, false));
}

}  // namespace candelabra
