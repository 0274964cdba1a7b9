// SPDX-License-Identifier: GPL-3.0-or-later
// A model as one piece of bytes, on its way from the process that reads it. It is not
// trusted, since what the process has read may have broken it. Called by model_import.cpp.
#pragma once

#include "imports/imported_model.h"
#include "shape/mesh.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// Number of bytes that pack() writes.
std::size_t packed_size(const ImportedModel&);
void pack(const ImportedModel&, char* to);

/// A model with the lists of its meshes as those of the language, in the space of the file.
struct UnpackedModel {
    ImportedModel model;  ///< without the lists of its meshes
    std::vector<Mesh> meshes;
};

/// Reads what pack() has made, of which it copies all before it checks anything. Returns an error
/// as a sentence, or, with a complete result, an empty string. In the result, each index is one of
/// an entry or below 0, each number of a mesh is finite, and parents come before their children.
std::string unpack(std::string_view bytes, UnpackedModel&);

}  // namespace candelabra
