// SPDX-License-Identifier: GPL-3.0-or-later
// A camera whose rays start at the faces of meshes, one at each, along their normals. Made by the
// evaluator, and used by the renderer in place of a Projection's own rays.
#pragma once

#include "base/handle.h"
#include "base/ray.h"
#include "base/transform.h"
#include "vocabulary/item_info.h"

#include <optional>

namespace candelabra {

struct CameraFace {
    std::array<Vec3, 3> corners;
    std::array<Vec3, 3> normals;
    std::array<Vec2, 3> uvs;
};

/// A mesh of a camera; its faces may be shared with meshes under other transforms.
struct CameraMesh {
    Handle<std::vector<CameraFace>> faces;
    Transform transform;
};

/// Settings of mesh_camera { }.
struct MeshRays {
    int rays = 1;          ///< of each pixel
    int distribution = 0;  ///< 0: the n-th ray of a pixel uses the n-th mesh, and its face with the
                           ///< pixel's number; 1: all meshes are one, and the n-th rays of all
                           ///< pixels continue where the others end; 2: the meshes stand side by
                           ///< side in the picture; 3: the face that contains the pixel's u and v
    bool smooth = false;   ///< with 3: along the smooth normal
    std::vector<CameraMesh> meshes;

    static const ItemInfo vocabulary;
};

/// A sample of the picture for which a ray is generated.
struct PictureSample {
    int x, y, width, height;
    std::uint32_t number;  ///< of the ray, below rays_per_pixel()
    double u, v;           ///< from 0 to 1, rightwards and upwards
};

/// Generates the rays of a mesh camera.
class MeshLens {
public:
    /// Rays start at this offset along the normal, and run against it when `reversed`.
    MeshLens(MeshRays rays, double offset, bool reversed);

    int rays_per_pixel() const { return rays_.rays; }
    /// The direction has unit length; it is zero where the picture has no ray.
    Ray ray(const PictureSample&) const;

private:
    struct Found {
        const CameraMesh* mesh = nullptr;
        std::size_t face = 0;
        Vec3 weights = Vec3(1.0 / 3);
    };
    Found numbered(std::size_t mesh, std::size_t face) const;
    Found counted_through(std::size_t face) const;
    Found side_by_side(const PictureSample&) const;
    Found at_uv(Vec2) const;
    void sort_uvs();

    MeshRays rays_;
    double offset_;
    bool reversed_;
    /// A face, stored for each cell of the unit square of u and v that its bounds overlap.
    struct Place {
        std::uint32_t mesh, face;
    };
    std::vector<std::vector<Place>> cells_;
};

}  // namespace candelabra
