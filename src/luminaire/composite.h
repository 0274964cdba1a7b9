// SPDX-License-Identifier: GPL-3.0-or-later
// A glowing leaf of a composite: any shape at all, whole or cut. Called through luminaire.h, which
// states what each function promises. Its points are found by looking: rays towards triangles near
// its surface, and within the cone of a sphere around it, or all around from within.
#pragma once

#include "luminaire/luminaire.h"

namespace candelabra {

/// The emitter, with its size as seen from far away, which is measured once by some rays. With
/// `guided` it also gets triangles to look at, if its surface can be made of some; that takes
/// milliseconds and some hundred kilobytes.
CompositeEmitter composite_emitter(Handle<Composite>, std::uint32_t leaf, bool guided = true);

/// Of a luminaire whose glow varies: the triangles are smaller, and looked at as much as they are
/// bright. `luminance` is asked at points near the surface. Some megabytes.
CompositeEmitter bright_composite_emitter(Handle<Composite>, std::uint32_t leaf,
                                          FunctionRef<double(const Vec3&)> luminance);

LightBounds bounds(const CompositeEmitter&, double luminance);
double unoccluded(const CompositeEmitter&, double luminance, const Receiver&);
std::optional<LightDirection> draw_direction(const CompositeEmitter&, const Vec3& from,
                                             const Vec2& u);
double direction_density(const CompositeEmitter&, const Vec3& from, const Vec3& direction);
std::optional<LightPoint> sample(const CompositeEmitter&, const Vec3& from, const Vec2& u);
void intersect(const CompositeEmitter&, const Receiver&, const Vec3& direction, LightHits&);
std::optional<EmittedRay> emit(const CompositeEmitter&, const Vec2& where, const Vec2& direction);
double emitting_area(const CompositeEmitter&);

}  // namespace candelabra
