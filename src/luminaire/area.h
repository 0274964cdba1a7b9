// SPDX-License-Identifier: GPL-3.0-or-later
// Any other glowing shape. Called through luminaire.h, which states what each function promises.
#pragma once

#include "luminaire/brightness.h"
#include "luminaire/luminaire.h"

LightBounds bounds(const AreaEmitter&, double luminance);
double unoccluded(const AreaEmitter&, double luminance, const Receiver&);
std::optional<LightPoint> sample(const AreaEmitter&, const Vec3& from, const Vec2& u);
std::optional<LightPoint> sample(const AreaEmitter&, const Receiver&, const Vec2& u);
void meet(const AreaEmitter&, const Receiver&, const Vec3& direction, LightMeetings&);
double emitting_area(const AreaEmitter&);
std::vector<BrightFace> flat_faces(const AreaEmitter&);
