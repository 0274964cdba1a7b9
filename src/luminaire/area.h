// SPDX-License-Identifier: GPL-3.0-or-later
// Glowing shapes other than spheres and triangles. Called through luminaire.h, which documents each
// function.
#pragma once

#include "luminaire/brightness.h"
#include "luminaire/luminaire.h"

namespace candelabra {

LightBounds bounds(const AreaEmitter&, double luminance);
double unoccluded(const AreaEmitter&, double luminance, const Receiver&);
std::optional<LightPoint> sample(const AreaEmitter&, const Vec3& from, const Vec2& u);
std::optional<LightPoint> sample(const AreaEmitter&, const Receiver&, const Vec2& u);
void intersect(const AreaEmitter&, const Receiver&, const Vec3& direction, LightHits&);
std::optional<EmittedRay> emit(const AreaEmitter&, double inner, const EmissionDraw&);
double emitting_area(const AreaEmitter&);
std::vector<BrightFace> flat_faces(const AreaEmitter&);

}  // namespace candelabra
