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
    /// Each profile of its lights, as it lies in their nodes; without a web: it cannot be read.
    std::vector<WebPlace> webs;
    /// What has been made of it without other looks, by the name of the part; "": the whole.
    std::map<std::string, ObjectHandle, std::less<>> objects;
};

/// What the scene has in the place of parts of a model, by their names.
struct Replacements {
    std::map<std::string, ImportedLook, std::less<>> looks;    ///< of materials
    std::map<std::string, ObjectHandle, std::less<>> objects;  ///< of parts, in their own spaces

    bool empty() const { return looks.empty() && objects.empty(); }
};

/// Reads the file, or returns what has been read before; null after a diagnostic.
std::shared_ptr<ImportedContent> imported_content(OpenBlock&, const std::string& file);

/// The whole model, or the part of that name with all that belongs to it, which keeps its size and
/// its direction and stands on the origin. Null after a diagnostic.
ObjectHandle imported_object(OpenBlock&, const ImportedContent&, const std::string& part,
                             const Replacements&);

/// A camera of a model in the space of the scene.
struct PlacedCamera {
    Vec3 location, direction, right, up;  ///< the directions are unit
    bool parallel = false;
    double width = 0, height = 0;  ///< as in ImportedCamera
};

/// The camera of that name, which is its own or that of its part; or the first one in the part of
/// that name; "": the first one of the model. Empty after a diagnostic.
std::optional<PlacedCamera> placed_camera(OpenBlock&, const ImportedContent&,
                                          const std::string& name);

}  // namespace candelabra
