// SPDX-License-Identifier: GPL-3.0-or-later
// Texture coordinates of points of a surface: u and v, mostly from 0 to 1, by POV-Ray's rules for
// each shape. Called by the world for textures with uv_mapping.
#pragma once

#include "shape/built_shape.h"

namespace candelabra {

/// The part is unknown and has to be searched for.
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
/// Default for shapes without texture coordinates.
template <ShapeKind T>
std::optional<Vec2> uv(const T&, const Vec3&, std::uint32_t) {
    return std::nullopt;
}

/// Number of the face that contains a point of the mesh.
std::uint32_t face_at(const BuiltMesh&, const Vec3& point);

/// Texture coordinates of a point of the surface; `part` is that of its Crossing, or any_part.
std::optional<Vec2> uv(const BuiltShape&, const Vec3& point, std::uint32_t part);

}  // namespace candelabra
