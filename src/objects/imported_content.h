// SPDX-License-Identifier: GPL-3.0-or-later
// A model file as objects: its meshes are read once and shared by all parts that show them. Called
// by model_block.cpp.
//
// Files are right-handed and scenes left-handed, so z changes its sign: a picture of a model is not
// mirrored, and what a file has in front (+z in glTF) is in front for a camera that looks along z.
#pragma once

#include "objects/imported_looks.h"
#include "reading/binder.h"

#include <memory>

namespace candelabra {

/// The file with its meshes as the scene has them.
struct ImportedContent {
    ImportedModel model;               ///< without the lists of its meshes and pictures
    std::vector<Handle<Mesh>> meshes;  ///< null: it has no faces
    std::vector<ImportedLook> looks;   ///< of each material
    std::vector<LoadedWeb> webs;       ///< of each profile of its lights; null: it cannot be read
    /// What has been made of it without other looks, by the name of the part; "": the whole.
    std::map<std::string, ObjectHandle, std::less<>> objects;
};

/// Looks of the scene that replace those of materials, by their names.
using ReplacedLooks = std::map<std::string, ImportedLook, std::less<>>;

/// Reads the file, or returns what has been read before; null after a diagnostic.
std::shared_ptr<ImportedContent> imported_content(OpenBlock&, const std::string& file);

/// The whole model, or the part of that name with all that belongs to it, which keeps its size and
/// its direction and stands on the origin. Null after a diagnostic.
ObjectHandle imported_object(OpenBlock&, const ImportedContent&, const std::string& part,
                             const ReplacedLooks&);

}  // namespace candelabra
