// SPDX-License-Identifier: GPL-3.0-or-later
// The glowing triangle. Called through luminaire.h, which documents each function.
#pragma once

#include "luminaire/luminaire.h"

namespace candelabra {

LightBounds bounds(const TriangleEmitter&, double luminance);
double unoccluded(const TriangleEmitter&, double luminance, const Receiver&);
std::optional<LightPoint> sample(const TriangleEmitter&, const Vec3& from, const Vec2& u);
void intersect(const TriangleEmitter&, const Receiver&, const Vec3& direction, LightHits&);
std::optional<EmittedRay> emit(const TriangleEmitter&, double inner, const EmissionDraw&);
double emitting_area(const TriangleEmitter&);

}  // namespace candelabra
