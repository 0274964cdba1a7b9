// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/mesh_camera.h"

#include "vocabulary/schema.h"

#include <algorithm>

namespace candelabra {

const ItemInfo MeshRays::vocabulary = described<MeshRays>([] {
    using F = Field<MeshRays>;
    return schema<MeshRays>(
        "mesh_camera",
        {"Rays from the faces of meshes, which stand in its braces.",
         "camera { mesh_camera { 2, 2 mesh { triangle { <-3, 0, -4>, <3, 0, -4>, <0, 4, -4> } } "
         "smooth } direction z }"},
        F{"rays", &MeshRays::rays, positional, "rays of each pixel", between(1, 1e6)},
        F{"distribution", &MeshRays::distribution, positional,
          "which face: 0 by the pixel's number, the n-th ray from the n-th mesh; 1 counted through "
          "all meshes; 2 meshes side by side; 3 by u and v",
          between(0, 3)},
        F{"smooth", &MeshRays::smooth, flag, "with distribution 3, along the smooth normals"});
});

namespace {

constexpr int cells_along = 128;

int cell_of(double place) {
    return std::clamp(static_cast<int>(place * cells_along), 0, cells_along - 1);
}

/// Weight of each corner at a point; empty when the point lies outside.
std::optional<Vec3> weights_at(const std::array<Vec2, 3>& corners, Vec2 p) {
    const auto area = [](Vec2 a, Vec2 b, Vec2 c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    const double whole = area(corners[0], corners[1], corners[2]);
    if (whole == 0) return std::nullopt;
    const Vec3 weights = Vec3(area(corners[1], corners[2], p), area(corners[2], corners[0], p),
                              area(corners[0], corners[1], p)) /
                         whole;
    constexpr double rounding = -1e-9;
    if (weights.x < rounding || weights.y < rounding || weights.z < rounding) return std::nullopt;
    return weights;
}

Vec3 blended(const std::array<Vec3, 3>& corners, const Vec3& weights) {
    return weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
}

}  // namespace

MeshLens::MeshLens(MeshRays rays, double offset, bool reversed)
    : rays_(std::move(rays)), offset_(offset), reversed_(reversed) {
    if (rays_.distribution == 3) sort_uvs();
}

void MeshLens::sort_uvs() {
    cells_.resize(static_cast<std::size_t>(cells_along) * cells_along);
    for (std::uint32_t mesh = 0; mesh < rays_.meshes.size(); ++mesh) {
        const auto& faces = *rays_.meshes[mesh].faces;
        for (std::uint32_t face = 0; face < faces.size(); ++face) {
            const auto& uv = faces[face].uvs;
            const Vec2 low = glm::min(glm::min(uv[0], uv[1]), uv[2]);
            const Vec2 high = glm::max(glm::max(uv[0], uv[1]), uv[2]);
            for (int j = cell_of(low.y); j <= cell_of(high.y); ++j)
                for (int i = cell_of(low.x); i <= cell_of(high.x); ++i)
                    cells_[static_cast<std::size_t>(j * cells_along + i)].push_back({mesh, face});
        }
    }
}

MeshLens::Found MeshLens::numbered(std::size_t mesh, std::size_t face) const {
    if (mesh >= rays_.meshes.size() || face >= rays_.meshes[mesh].faces->size()) return {};
    return {&rays_.meshes[mesh], face};
}

MeshLens::Found MeshLens::counted_through(std::size_t face) const {
    for (const CameraMesh& mesh : rays_.meshes) {
        if (face < mesh.faces->size()) return {&mesh, face};
        face -= mesh.faces->size();
    }
    return {};
}

MeshLens::Found MeshLens::side_by_side(const PictureSample& at) const {
    const int width = std::max(1, at.width / static_cast<int>(rays_.meshes.size()));
    return numbered(static_cast<std::size_t>(at.x / width),
                    static_cast<std::size_t>(at.y * width + at.x % width));
}

MeshLens::Found MeshLens::at_uv(Vec2 place) const {
    const int cell = cell_of(place.y) * cells_along + cell_of(place.x);
    for (const Place& each : cells_[static_cast<std::size_t>(cell)]) {
        const CameraMesh& mesh = rays_.meshes[each.mesh];
        const auto weights = weights_at((*mesh.faces)[each.face].uvs, place);
        if (weights) return {&mesh, each.face, *weights};
    }
    return {};
}

Ray MeshLens::ray(const PictureSample& at) const {
    const std::size_t pixel = static_cast<std::size_t>(at.y) * static_cast<std::size_t>(at.width) +
                              static_cast<std::size_t>(at.x);
    const Found found = rays_.distribution == 0   ? numbered(at.number, pixel)
                        : rays_.distribution == 1 ? counted_through(pixel)
                        : rays_.distribution == 2 ? side_by_side(at)
                                                  : at_uv({at.u, at.v});
    if (!found.mesh) return {Vec3(0), Vec3(0)};
    const CameraFace& face = (*found.mesh->faces)[found.face];
    const Vec3 flat = cross(face.corners[2] - face.corners[0], face.corners[1] - face.corners[0]);
    const bool smooth = rays_.smooth && rays_.distribution == 3;
    const Vec3 normal =
        unit(found.mesh->transform.normal(smooth ? blended(face.normals, found.weights) : flat));
    const Vec3 start = found.mesh->transform.point(blended(face.corners, found.weights));
    return {start + offset_ * normal, reversed_ ? -normal : normal};
}

}  // namespace candelabra
