// SPDX-License-Identifier: GPL-3.0-or-later
// What Assimp does not take from cameras of Collada files: an angle from the bottom to the top
// without an aspect, parallel rays, and all optics of a camera without a name. Called by
// importer.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// Aspects that say more than an aspect: below 0, rays are parallel, and the degrees of the angle
/// are half of the width of the picture; this one means that the aspect is not known.
inline constexpr double parallel_without_aspect = -1048576;

/// The file with cameras that Assimp reads; nothing if the file itself will do. `bytes` are those
/// of a .dae file, which may be damaged.
std::optional<std::string> with_told_cameras(std::string_view bytes);

}  // namespace candelabra
