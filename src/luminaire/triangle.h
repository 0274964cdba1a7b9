// SPDX-License-Identifier: GPL-3.0-or-later
// The glowing triangle. Called through luminaire.h, which states what each function promises.
#pragma once

#include "luminaire/luminaire.h"

LightBounds bounds(const TriangleEmitter&, double luminance);
double unoccluded(const TriangleEmitter&, double luminance, const Receiver&);
std::optional<LightPoint> sample(const TriangleEmitter&, const Vec3& from, const Vec2& u);
void meet(const TriangleEmitter&, const Receiver&, const Vec3& direction, LightMeetings&);
double emitting_area(const TriangleEmitter&);
