// SPDX-License-Identifier: GPL-3.0-or-later
// Warps, which move a point before a pattern is evaluated there, besides transformations: warp {
// ... }. Used by PatternUse. Each kind has its vocabulary, as patterns have.
#pragma once

#include "base/transform.h"
#include "pattern/modifiers.h"
#include "vocabulary/kinds.h"

namespace candelabra {

struct TurbulenceWarp {
    Vec3 amount = Vec3(0);
    int octaves = 6;
    double omega = 0.5;
    double lambda = 2;

    static const ItemInfo vocabulary;
};

struct RepeatWarp {
    Vec3 width = Vec3(1, 0, 0);
    Vec3 offset = Vec3(0);
    Vec3 flip = Vec3(0);

    static const ItemInfo vocabulary;
};

struct BlackHole {
    Vec3 centre = Vec3(0);
    double radius = 1;
    double strength = 1;
    double falloff = 2;
    Vec3 repeat = Vec3(0);
    Vec3 turbulence = Vec3(0);
    int type = 0;
    bool inverse = false;

    static const ItemInfo vocabulary;
};

/// Wraps a two-dimensional map around a shape. `orientation` is the normal of the map's plane,
/// `dist_exp` the power of the distance by which the map is stretched.
struct MapWarp {
    Vec3 orientation = Vec3(0, 0, 1);
    double dist_exp = 0;
};

struct CylindricalWarp : MapWarp {
    static const ItemInfo vocabulary;
};

struct SphericalWarp : MapWarp {
    static const ItemInfo vocabulary;
};

struct ToroidalWarp : MapWarp {
    double major_radius = 1;

    static const ItemInfo vocabulary;
};

struct PlanarWarp {
    Vec3 orientation = Vec3(0, 0, 1);
    double distance = 0;

    static const ItemInfo vocabulary;
};

struct CubicWarp {
    static const ItemInfo vocabulary;
};

using Warp = std::variant<TurbulenceWarp, RepeatWarp, BlackHole, CylindricalWarp, SphericalWarp,
                          ToroidalWarp, PlanarWarp, CubicWarp>;

/// Returns the point at which the pattern is evaluated. Points where a warp is undefined stay in
/// place.
Vec3 warped(const Warp&, const Vec3& point);

/// A step from a pattern's space towards the space in which it is used.
using WarpStep = std::variant<Transform, Warp>;

/// Clamps every component to within 1e17 of 0, so that it converts to an integer; NaN, too, becomes
/// finite.
Vec3 within_reach(const Vec3& point);

/// Maps a point back through one step.
Vec3 undone(const WarpStep&, const Vec3& point);

/// Maps a point back through all steps, from the last to the first.
Vec3 warped(std::span<const WarpStep>, Vec3 point);

/// Moves the centre of a repeated black hole, and enlarges its blocks, so that they contain it, as
/// POV-Ray does.
void fit_blocks(BlackHole&);

}  // namespace candelabra
