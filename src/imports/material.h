// SPDX-License-Identifier: GPL-3.0-or-later
// Materials of Assimp as ours. Called by importer.cpp.
#pragma once

#include "imports/imported_model.h"

#include <assimp/scene.h>

namespace candelabra {

/// Reads a material of the scene, and adds its pictures to the model.
ImportedMaterial imported_material(const aiScene&, const aiMaterial&, ImportedModel&);

/// Number of the texture coordinates that its pictures use.
unsigned uv_set(const aiMaterial&);

}  // namespace candelabra
