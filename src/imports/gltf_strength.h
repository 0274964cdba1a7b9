// SPDX-License-Identifier: GPL-3.0-or-later
// The strength of emission in glTF files (KHR_materials_emissive_strength), which Assimp reads from
// version 5.3 on only. Called by importer.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// Returns the file with its strengths multiplied into the emission of its materials; nothing if it
/// has none, or cannot be read. `bytes` are those of a .gltf or .glb file.
std::optional<std::string> with_strengths(std::string_view bytes);

}  // namespace candelabra
