// SPDX-License-Identifier: GPL-3.0-or-later
// Which copies of a mesh are taken apart into triangles of the world. Used by flatten().
#pragma once

#include "shape/mesh.h"

#include <cstddef>
#include <unordered_map>

namespace candelabra {

/// Rays find triangles faster than what is behind a place of its own, but a whole copy takes hardly
/// any memory: of a mesh with many copies only the first ones are taken apart.
class MeshCopies {
public:
    /// The meshes outlive this.
    explicit MeshCopies(std::size_t max_faces = 1 << 16) : max_faces_(max_faces) {}

    /// Whether the next copy is: the first one, and others while all together have at most so many
    /// faces.
    bool takes_apart(const Mesh& mesh) {
        std::size_t& faces = faces_[&mesh];
        if (faces > 0 && faces + mesh.faces.size() > max_faces_) return false;
        faces += mesh.faces.size();
        return true;
    }

private:
    std::size_t max_faces_;
    std::unordered_map<const Mesh*, std::size_t> faces_;  ///< of the copies up to now
};

}  // namespace candelabra
