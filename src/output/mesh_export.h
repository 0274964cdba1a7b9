// SPDX-License-Identifier: GPL-3.0-or-later
// Exports a scene as one mesh to a file, for --export-mesh. Called after the scene has been
// evaluated.
#pragma once

#include "scene/scene.h"
#include "text/diagnostic.h"

#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

enum class MeshFormat { ply, obj };

/// Returns the format for the extension of the file's name, ignoring case; nothing for others.
std::optional<MeshFormat> mesh_format(std::string_view file);

/// Returns the file with all surfaces of the scene. Warns of objects without bounded surfaces. If
/// no surface is left, reports an error and returns an empty text.
std::string exported_mesh(const Scene&, MeshFormat, Diagnostics&);

}  // namespace candelabra
