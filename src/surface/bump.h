// SPDX-License-Identifier: GPL-3.0-or-later
// Normals perturbed by patterns, which make a smooth surface look bumpy. POV-Ray's normal { }.
#pragma once

#include "base/handle.h"
#include "base/transform.h"
#include "pattern/modifiers.h"
#include "pattern/nesting.h"

namespace candelabra {

struct PatternedBump;  // this, its settings and map entries: normal_map.h
struct BumpSettings;
struct NormalStop;
struct SlopeStop;
using NormalMap = std::vector<NormalStop>;
using SlopeMap = std::vector<SlopeStop>;

/// How a surface's normal is perturbed. Default: not at all.
struct Bump {
    Handle<PatternedBump> pattern;  ///< null: smooth
    Transform transform;            ///< after all steps of the pattern: to the object's space
    bool uv = false;                ///< as in Pigment
    Handle<BumpSettings> settings;  ///< of a smooth bump, for patterns that follow; null: none
    Handle<Transform> frame = {};   ///< further transform of normals of uv mapped bumps; null:
                                    ///< identity
};

Nesting nesting(const Bump&);

/// Returns the unit normal at a point of the surface, in the space to which the bump's transform
/// leads. `normal` is a unit vector on the viewer's side.
Vec3 bumped(const Bump&, const Vec3& normal, const Vec3& point, const PatternScene& = {});

}  // namespace candelabra
