// SPDX-License-Identifier: GPL-3.0-or-later
// A glowing leaf of a composite: any shape, whole or cut. Called through luminaire.h, which
// documents each function. Its points are found by tracing rays: towards triangles near its
// surface, and within the cone to a bounding sphere (from inside the sphere, in all directions).
#pragma once

#include "luminaire/luminaire.h"

namespace candelabra {

/// Returns the emitter with its mean projected area, which is measured once by tracing some rays.
/// If `with_proxy` is set, the emitter also gets triangles to aim at, if its surface can be
/// tessellated; this takes milliseconds and some hundred kilobytes.
CompositeEmitter composite_emitter(Handle<Composite>, std::uint32_t leaf, bool with_proxy = true);

/// The same for a luminaire whose radiance varies: the triangles are smaller and are chosen in
/// proportion to their brightness. `luminance` is evaluated at points near the surface. Takes some
/// megabytes.
CompositeEmitter bright_composite_emitter(Handle<Composite>, std::uint32_t leaf,
                                          FunctionRef<double(const Vec3&)> luminance);

/// An emitter that is made without tracing rays, for checks of a scene: its mean projected area is
/// that of a ball around the leaf.
CompositeEmitter unmeasured_emitter(Handle<Composite>, std::uint32_t leaf);

/// The emitter of a composite of one leaf, which is that of another emitter in another place. Both
/// share their triangles.
CompositeEmitter placed_emitter(const CompositeEmitter&, Handle<Composite>,
                                const Handle<Transform>& place);

LightBounds bounds(const CompositeEmitter&, double luminance);
double unoccluded(const CompositeEmitter&, double luminance, const Receiver&);
std::optional<LightDirection> draw_direction(const CompositeEmitter&, const Vec3& from,
                                             const Vec2& u);
double direction_density(const CompositeEmitter&, const Vec3& from, const Vec3& direction);
std::optional<LightPoint> sample(const CompositeEmitter&, const Vec3& from, const Vec2& u);
void intersect(const CompositeEmitter&, const Receiver&, const Vec3& direction, LightHits&);
std::optional<EmittedRay> emit(const CompositeEmitter&, double inner, const EmissionDraw&);
double emitting_area(const CompositeEmitter&);

}  // namespace candelabra
