// SPDX-License-Identifier: GPL-3.0-or-later
// The glowing rectangle. Called through luminaire.h, which documents each function.
#pragma once

#include "luminaire/luminaire.h"

namespace candelabra {

LightBounds bounds(const RectangleEmitter&, double luminance);
double unoccluded(const RectangleEmitter&, double luminance, const Receiver&);
std::optional<LightPoint> sample(const RectangleEmitter&, const Vec3& from, const Vec2& u);
/// Only points that may be above the receiver's horizon.
std::optional<LightPoint> sample(const RectangleEmitter&, const Receiver&, const Vec2& u);
void intersect(const RectangleEmitter&, const Receiver&, const Vec3& direction, LightHits&);
std::optional<EmittedRay> emit(const RectangleEmitter&, double inner, const EmissionDraw&);
double emitting_area(const RectangleEmitter&);

}  // namespace candelabra
