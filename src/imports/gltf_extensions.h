// SPDX-License-Identifier: GPL-3.0-or-later
// Extensions of glTF files that Assimp does not read, or not as they are defined: the strength of
// emission (KHR_materials_emissive_strength; from version 5.3 on it does), pictures that are moved
// on surfaces (KHR_texture_transform), lights with measured intensities (EXT_lights_ies), and
// cameras, of which it keeps one node for each.
// Called by importer.cpp.
#pragma once

#include "imports/imported_model.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// How the picture of a material lies on surfaces: texture coordinates, with v downwards, are
/// scaled, turned, then shifted.
struct PictureMove {
    std::array<double, 2> scale{1, 1}, offset{0, 0};
    double turn = 0;  ///< radians

    /// Moves coordinates with v upwards.
    std::array<float, 2> moved(const std::array<float, 2>& uv) const;
};

struct GltfExtensions {
    /// The file with its strengths multiplied into the emission of its materials, and with numbers
    /// at the end of names; nothing if the file itself will do.
    std::optional<std::string> file;
    std::map<int, PictureMove> moves;     ///< by the number of the material
    std::map<int, ImportedLight> lights;  ///< measured ones, by the number of the node
    std::vector<ImportedFile> profiles;   ///< that they have
    std::map<int, ImportedCamera> cameras;  ///< by the number of the node
};

/// Reads the extensions. `bytes` are those of a .gltf or .glb file, which may be damaged.
GltfExtensions read_extensions(std::string_view bytes, const BesideModel&);

/// Takes a number from a name to which read_extensions() has added it; below 0: there is none.
int take_number(std::string& name);

}  // namespace candelabra
