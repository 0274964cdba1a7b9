// SPDX-License-Identifier: GPL-3.0-or-later
// A light source of no size. Called through luminaire.h, which documents each function; rays never
// meet one.
#pragma once

#include "luminaire/luminaire.h"

namespace candelabra {

LightBounds bounds(const SourceEmitter&, double luminance);
double unoccluded(const SourceEmitter&, double luminance, const Receiver&);
std::optional<LightPoint> sample(const SourceEmitter&, const Vec3& from, const Vec2& u);
void intersect(const SourceEmitter&, const Receiver&, const Vec3& direction, LightHits&);
std::optional<EmittedRay> emit(const SourceEmitter&, double inner, const EmissionDraw&);
double emitting_area(const SourceEmitter&);

}  // namespace candelabra
