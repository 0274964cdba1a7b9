// SPDX-License-Identifier: GPL-3.0-or-later
// Where the points of a surface lie on a picture that is wrapped around it: u and v, mostly from 0
// to 1, by POV-Ray's rules for each shape. Called by the world for textures with uv_mapping.
#pragma once

#include "shape/built_shape.h"

namespace candelabra {

/// A part that is not known and has to be found.
inline constexpr std::uint32_t any_part = ~0u;

std::optional<Vec2> uv(const Sphere&, const Vec3& point, std::uint32_t part);
std::optional<Vec2> uv(const Cuboid&, const Vec3& point, std::uint32_t part);
std::optional<Vec2> uv(const Torus&, const Vec3& point, std::uint32_t part);
std::optional<Vec2> uv(const Ovus&, const Vec3& point, std::uint32_t part);
std::optional<Vec2> uv(const BuiltLathe&, const Vec3& point, std::uint32_t part);
std::optional<Vec2> uv(const BuiltSor&, const Vec3& point, std::uint32_t part);
std::optional<Vec2> uv(const BuiltBicubicPatch&, const Vec3& point, std::uint32_t part);
std::optional<Vec2> uv(const BuiltParametric&, const Vec3& point, std::uint32_t part);
std::optional<Vec2> uv(const BuiltMesh&, const Vec3& point, std::uint32_t part);
/// Shapes that nothing is wrapped around.
template <ShapeKind T>
std::optional<Vec2> uv(const T&, const Vec3&, std::uint32_t) {
    return std::nullopt;
}

/// The face that a point of the mesh lies on.
std::uint32_t face_at(const BuiltMesh&, const Vec3& point);

/// u and v of a point of the surface; `part` is that of its Crossing, or any_part.
std::optional<Vec2> uv(const BuiltShape&, const Vec3& point, std::uint32_t part);

}  // namespace candelabra
