// SPDX-License-Identifier: GPL-3.0-or-later
// The glowing sphere. Called through luminaire.h, which documents each function.
#pragma once

#include "luminaire/luminaire.h"

namespace candelabra {

LightBounds bounds(const SphereEmitter&, double luminance);
double unoccluded(const SphereEmitter&, double luminance, const Receiver&);
std::optional<LightPoint> sample(const SphereEmitter&, const Vec3& from, const Vec2& u);
std::optional<LightPoint> sample(const SphereEmitter&, const Receiver&, const Vec2& u);
void intersect(const SphereEmitter&, const Receiver&, const Vec3& direction, LightHits&);
std::optional<EmittedRay> emit(const SphereEmitter&, double inner, const EmissionDraw&);
double emitting_area(const SphereEmitter&);

}  // namespace candelabra
