// SPDX-License-Identifier: GPL-3.0-or-later
// A camera whose rays start at the faces of meshes, one for each, and go along their normals. Made
// by the evaluator, asked by the renderer in place of a Projection's own rays.
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

/// A mesh of a camera: its faces may be shared by many that stand elsewhere.
struct CameraMesh {
    Handle<std::vector<CameraFace>> faces;
    Transform transform;
};

/// What mesh_camera { } says.
struct MeshRays {
    int rays = 1;          ///< of each pixel
    int distribution = 0;  ///< 0: the n-th ray of a pixel asks the n-th mesh for the face of the
                           ///< pixel's number; 1: all meshes are one, and the n-th rays of all
                           ///< pixels go on where the others end; 2: the meshes stand side by side
                           ///< in the picture; 3: the face that has the pixel's u and v
    bool smooth = false;   ///< of 3: along the smooth normal
    std::vector<CameraMesh> meshes;

    static const ItemInfo vocabulary;
};

/// Where in the picture a ray is wanted.
struct PictureSample {
    int x, y, width, height;
    std::uint32_t number;  ///< of the sample in the pixel
    double u, v;           ///< from 0 to 1: to the right, and upwards
};

/// The rays of a mesh camera, ready to be asked.
class MeshLens {
public:
    /// Rays start this far along the normal, and go against it when `reversed`.
    MeshLens(MeshRays rays, double offset, bool reversed);

    int rays_per_pixel() const { return rays_.rays; }
    /// Direction of unit length; zero where the picture has no ray.
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
    /// Faces by the part of the square of u and v that they touch.
    struct Place {
        std::uint32_t mesh, face;
    };
    std::vector<std::vector<Place>> cells_;
};

}  // namespace candelabra
