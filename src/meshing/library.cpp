// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/library.h"

#include "base/elementary.h"
#include "base/loaded_library.h"
#include "base/long_work.h"
#include "models/model_file.h"
#include "text/message.h"
#include "text/printable.h"

#include <map>

namespace candelabra {

namespace {

Vec3 vector(const Polyhedron::Point& p) { return {p[0], p[1], p[2]}; }

/// The angle at `corner` between the directions to a and b.
double angle(const Vec3& corner, const Vec3& a, const Vec3& b) {
    const Vec3 u = a - corner, v = b - corner;
    return math::atan2(length(cross(u, v)), dot(u, v));
}

}  // namespace

const Polyhedra* modelling_library(Diagnostics& diagnostics, Span asked_at) {
    static const LoadedFunction library = load_function(polyhedra_library, polyhedra_function);
    if (!library.address) {
        diagnostics.add(
            error(Fault::io, asked_at,
                  message("the library of polyhedra cannot be opened: ", library.problem)));
        return nullptr;
    }
    static const Polyhedra* const polyhedra =
        reinterpret_cast<const Polyhedra* (*)()>(library.address)();
    return polyhedra;
}

Polyhedron polyhedron(const Mesh& mesh) {
    constexpr std::uint64_t work_of_corner = 10;
    count_long_work(work_of_corner * mesh.vertices.size());
    Polyhedron made;
    std::map<Polyhedron::Point, int> known;
    std::vector<int> places;
    for (const Vec3& v : mesh.vertices) {
        const Polyhedron::Point point{v.x, v.y, v.z};
        const auto [found, added] = known.try_emplace(point, static_cast<int>(made.points.size()));
        if (added) made.points.push_back(point);
        places.push_back(found->second);
    }
    const auto place = [&](int corner) { return places[static_cast<std::size_t>(corner)]; };
    for (const Face& face : mesh.faces)
        made.faces.push_back({place(face[0]), place(face[1]), place(face[2])});
    return made;
}

Mesh mesh(const Polyhedron& from) {
    Mesh made;
    made.vertices.reserve(from.points.size());
    for (const Polyhedron::Point& p : from.points) made.vertices.push_back(vector(p));
    made.faces.reserve(from.faces.size());
    for (const Polyhedron::Face& face : from.faces)
        made.faces.push_back({face[0], face[1], face[2]});
    return made;
}

Mesh smooth_mesh(const Polyhedron& from) {
    Mesh made = mesh(from);
    made.normals.assign(made.vertices.size(), Vec3(0));
    for (const Face& face : made.faces) {
        std::array<Vec3, 3> p;
        for (std::size_t i = 0; i < 3; ++i) p[i] = made.vertices[static_cast<std::size_t>(face[i])];
        const Vec3 normal = unit(cross(p[1] - p[0], p[2] - p[0]));
        for (std::size_t i = 0; i < 3; ++i)
            made.normals[static_cast<std::size_t>(face[i])] +=
                angle(p[i], p[(i + 1) % 3], p[(i + 2) % 3]) * normal;
    }
    for (Vec3& normal : made.normals) normal = unit(normal);
    return made;
}

std::optional<MeshFile> read_mesh_file(const Found& file, Diagnostics& diagnostics, Span asked_at) {
    MeshFile made;
    const std::string problem = read_model(file.path, file.text, made.shape, made.look);
    if (problem.empty()) return made;
    diagnostics.add(
        error(Fault::io, asked_at,
              message("cannot read the mesh `", printable(file.path), "`: ", printable(problem))));
    return std::nullopt;
}

void dress(Mesh& mesh, const PolyhedronLook& look) {
    const auto copy = [](const std::vector<Polyhedron::Face>& from, std::vector<Face>& to) {
        for (const auto& [a, b, c] : from) to.push_back({a, b, c});
    };
    for (const auto& [u, v] : look.uvs) mesh.uvs.emplace_back(u, v);
    copy(look.uv_faces, mesh.uv_faces);
    if (!mesh.normals.empty()) return;
    for (const Polyhedron::Point& normal : look.normals) mesh.normals.push_back(vector(normal));
    copy(look.normal_faces, mesh.normal_faces);
}

}  // namespace candelabra
