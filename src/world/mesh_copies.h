// SPDX-License-Identifier: GPL-3.0-or-later
// Decides which copies of a mesh become triangles of the world. Used by flatten().
#pragma once

#include "shape/mesh.h"

#include <cstddef>
#include <unordered_map>

namespace candelabra {

/// Rays find triangles faster than a mesh with its own transform, but such a copy takes hardly any
/// memory: only the first copies of a mesh are taken apart.
class MeshCopies {
public:
    /// The meshes must outlive this.
    explicit MeshCopies(std::size_t max_faces = 1 << 16) : max_faces_(max_faces) {}

    /// Whether the next copy is taken apart: the first one always, further ones while all copies
    /// together have at most `max_faces` faces.
    bool takes_apart(const Mesh& mesh) {
        std::size_t& faces = faces_[&mesh];
        if (faces > 0 && faces + mesh.faces.size() > max_faces_) return false;
        faces += mesh.faces.size();
        return true;
    }

private:
    std::size_t max_faces_;
    std::unordered_map<const Mesh*, std::size_t> faces_;  ///< of the copies so far
};

}  // namespace candelabra
