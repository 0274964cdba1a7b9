// SPDX-License-Identifier: GPL-3.0-or-later
// What moves a point before a pattern sees it, beside transformations: warp { ... }. Used by
// PatternUse; each kind has its vocabulary, as patterns have.
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

/// Where a map of two dimensions is wrapped around something: its axis, and what distance does.
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

/// The point at which the pattern is asked. Points for which a warp has no answer stay in place.
Vec3 warped(const Warp&, const Vec3& point);

/// One step on the way from a pattern's space to the one in which it is used.
using WarpStep = std::variant<Transform, Warp>;

/// Every component within 1e17 of 0, also for points that are none: whole numbers can be made of
/// them.
Vec3 within_reach(const Vec3& point);

/// Back through one step.
Vec3 undone(const WarpStep&, const Vec3& point);

/// Back through all steps, from the last to the first.
Vec3 warped(std::span<const WarpStep>, Vec3 point);

/// Moves the centre of a repeated black hole to where its blocks can hold it, as POV-Ray does.
void fit_blocks(BlackHole&);

}  // namespace candelabra
