// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/mesh_export.h"

#include "meshing/obj.h"
#include "meshing/object_mesh.h"
#include "meshing/ply.h"
#include "text/ascii.h"
#include "text/message.h"

#include <algorithm>

namespace candelabra {

namespace {

/// Number of cells along the longest side of a shape: fine enough for round shapes, coarse enough
/// for scenes with many thousand spheres.
constexpr int cells = 32;

/// Maximum number of faces that the indices in a file, and the memory of most machines, can hold.
constexpr std::size_t max_faces = 100'000'000;

}  // namespace

std::optional<MeshFormat> mesh_format(std::string_view file) {
    const std::string_view ending = file.substr(std::min(file.size(), file.rfind('.')));
    if (same_letters(ending, ".ply")) return MeshFormat::ply;
    if (same_letters(ending, ".obj")) return MeshFormat::obj;
    return std::nullopt;
}

std::string exported_mesh(const Scene& scene, MeshFormat format, Diagnostics& diagnostics) {
    const Polyhedra* library = modelling_library(diagnostics, {});
    if (!library) return {};
    Mesh all;
    for (const ObjectHandle& object : scene.objects) {
        const Mesh part = surface_mesh(object, cells, library);
        if (part.faces.empty())
            diagnostics.add(
                warning(Fault::degenerate, object->span,
                        "this object is not in the mesh: it has no end, or is too thin"));
        const int first = static_cast<int>(all.vertices.size());
        all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
        for (const Face& face : part.faces)
            all.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
        if (all.faces.size() > max_faces) {
            diagnostics.add(error(Fault::out_of_range, object->span,
                                  message("the mesh would have more than ", max_faces,
                                          " faces from this object on")));
            return {};
        }
    }
    if (!all.faces.empty()) return format == MeshFormat::obj ? obj(all) : ply(all);
    diagnostics.add(error(Fault::degenerate, {}, "there is no surface to write"));
    return {};
}

}  // namespace candelabra
