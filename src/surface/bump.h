// SPDX-License-Identifier: GPL-3.0-or-later
// Normals that patterns disturb: what makes a smooth surface look bumpy. POV-Ray's normal { }.
#pragma once

#include "base/handle.h"
#include "base/transform.h"
#include "pattern/modifiers.h"
#include "pattern/nesting.h"

namespace candelabra {

struct PatternedBump;  // this, its settings and the entries of maps: normal_map.h
struct BumpSettings;
struct NormalStop;
struct SlopeStop;
using NormalMap = std::vector<NormalStop>;
using SlopeMap = std::vector<SlopeStop>;

/// How the normal of a surface is changed. Default: not at all.
struct Bump {
    Handle<PatternedBump> pattern;  ///< null: smooth
    Transform transform;            ///< after all steps of the pattern: to the object's space
    bool uv = false;                ///< as in Pigment
    Handle<BumpSettings> settings;  ///< of a smooth one, for patterns that follow; null: none
    Handle<Transform> frame = {};   ///< what normals pass besides on u and v; null: nothing
};

Nesting nesting(const Bump&);

/// The unit normal at a point of the surface, in the space that the bump's transform leads to.
/// `normal` is unit and on the side of the viewer.
Vec3 bumped(const Bump&, const Vec3& normal, const Vec3& point, const PatternScene& = {});

}  // namespace candelabra
