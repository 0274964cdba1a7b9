// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as one mesh in a file: --export-mesh. Called when the scene has been evaluated.
#pragma once

#include "scene/scene.h"
#include "text/diagnostic.h"

#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

enum class MeshFormat { ply, obj };

/// By the ending of the file's name, in any case of letters; nothing for others.
std::optional<MeshFormat> mesh_format(std::string_view file);

/// The file of all surfaces of the scene. Objects without any that have an end are warnings; if no
/// surface is left, the text is empty and there is an error.
std::string exported_mesh(const Scene&, MeshFormat, Diagnostics&);

}  // namespace candelabra
