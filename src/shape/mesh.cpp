// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/mesh.h"

#include "vocabulary/schema.h"

#include "shape/mesh_area.h"
#include "shape/triangle.h"

namespace candelabra {

const ItemInfo Mesh::vocabulary = described<Mesh>([] {
    using F = Field<Mesh>;
    return schema<Mesh>(
        "mesh2",
        {"Triangles over a list of shared vertices.",
         "mesh2 { vertex_vectors { 4, <-1, 0, -1>, <1, 0, -1>, <0, 0, 1>, <0, 1.7, 0> } "
         "face_indices { 4, <0, 1, 2>, <0, 1, 3>, <1, 2, 3>, <2, 0, 3> } inside_vector y }",
         "mesh2 { vertex_vectors { 3, <-1, 0, 0>, <1, 0, 0>, <0, 1.6, 0> } normal_vectors { 3, "
         "<-1, 0, -1>, <1, 0, -1>, <0, 1, -1> } uv_vectors { 3, <0, 0>, <1, 0>, <0.5, 1> } "
         "face_indices { 1, <0, 1, 2> } normal_indices { 1, <0, 1, 2> } uv_indices { 1, <0, 1, 2> "
         "} }"},
        F{"vertex_vectors", &Mesh::vertices, list, "corners"},
        F{"normal_vectors", &Mesh::normals, list, "surface normals, for smooth shading"},
        F{"uv_vectors", &Mesh::uvs, list, "places in a picture that is mapped on the faces"},
        F{"face_indices", &Mesh::faces, list,
          "three vertices for each face, counted from 0; then its textures by number, if any"},
        F{"face textures", &Mesh::looks, following, "numbers in the `texture_list`"},
        F{"normal_indices", &Mesh::normal_faces, list,
          "three normals for each face, counted from 0"},
        F{"uv_indices", &Mesh::uv_faces, list, "three of `uv_vectors` for each face"},
        F{"inside_vector", &Mesh::inside_vector, item,
          "direction in which to count crossings to tell inside from outside"});
});

namespace {

struct Noun {
    const char* one;
    const char* many;
};
constexpr Noun vertex{"vertex", "vertices"}, normal{"normal", "normals"}, triangle{"face", "faces"},
    uv_vector{"uv vector", "uv vectors"};

std::string number_of(std::size_t n, const Noun& noun) {
    return (n == 0 ? "no" : std::to_string(n)) + " " + (n == 1 ? noun.one : noun.many);
}

/// Describes the first entry of a list that is not a valid index, as a sentence.
std::string wrong_index(const std::vector<Face>& list, const std::string& list_name,
                        std::size_t count, const Noun& noun) {
    for (std::size_t i = 0; i < list.size(); ++i)
        for (const int index : list[i])
            if (index < 0 || static_cast<std::size_t>(index) >= count)
                return "entry " + std::to_string(i) + " of `" + list_name + "` names " + noun.one +
                       " " + std::to_string(index) + ", but there " +
                       (count == 1 ? "is " : "are ") + number_of(count, noun) + ", counted from 0";
    return {};
}

/// Indices of the normals of a face; null when it is flat.
const Face* normals_of(const Mesh& mesh, std::size_t i) {
    if (!mesh.normal_faces.empty())
        return i < mesh.normal_faces.size() ? &mesh.normal_faces[i] : nullptr;
    return mesh.normals.empty() ? nullptr : &mesh.faces[i];
}

const Vec3& corner(const Mesh& mesh, std::size_t face, std::size_t i) {
    return mesh.vertices[static_cast<std::size_t>(mesh.faces[face][i])];
}

Vec3 normal_at(const MeshTriangle& face, const Vec3& own, const TriangleHit& hit) {
    if (!face.smooth) return own;
    const Vec3 smooth = unit((1 - hit.weight2 - hit.weight3) * face.normals[0] +
                             hit.weight2 * face.normals[1] + hit.weight3 * face.normals[2]);
    return smooth == Vec3(0) ? own : smooth;
}

/// A ray prepared for the faces of a mesh.
class MeshRay {
public:
    MeshRay(const Mesh& mesh, const Ray& ray)
        : mesh_(mesh), direction_(ray.direction), sheared_(ray, Edges::one) {}

    std::optional<Crossing> meet(std::uint32_t i) const {
        const TriangleHit hit = sheared_.meet(corner(mesh_, i, 0), corner(mesh_, i, 1),
                                              corner(mesh_, i, 2), whole_line);
        if (!(hit.t < whole_line.max)) return {};
        const MeshTriangle met = face(mesh_, i);
        const Vec3 own = triangle_normal(met.corners[0], met.corners[1], met.corners[2]);
        if (own == Vec3(0)) return {};
        const Vec3 shown = normal_at(met, own, hit);
        return Crossing{hit.t, shown, dot(direction_, shown) < 0, i};
    }

private:
    const Mesh& mesh_;
    Vec3 direction_;
    ShearedRay sheared_;
};

}  // namespace

std::string problem(const Mesh& mesh) {
    if (mesh.vertices.empty()) return "a `mesh2` needs `vertex_vectors`";
    if (mesh.faces.empty()) return "a `mesh2` needs at least one face in `face_indices`";
    const std::string wrong = wrong_index(mesh.faces, "face_indices", mesh.vertices.size(), vertex);
    if (!wrong.empty()) return wrong;
    if (mesh.normal_faces.empty() && !mesh.normals.empty() &&
        mesh.normals.size() != mesh.vertices.size())
        return "a `mesh2` with " + number_of(mesh.normals.size(), normal) + " for " +
               number_of(mesh.vertices.size(), vertex) + " needs `normal_indices`";
    if (mesh.normal_faces.size() > mesh.faces.size())
        return "`normal_indices` has " + std::to_string(mesh.normal_faces.size()) +
               " entries, but there " + (mesh.faces.size() == 1 ? "is only " : "are only ") +
               number_of(mesh.faces.size(), triangle);
    const std::string wrong_normal =
        wrong_index(mesh.normal_faces, "normal_indices", mesh.normals.size(), normal);
    if (!wrong_normal.empty()) return wrong_normal;
    if (!mesh.uv_faces.empty() && mesh.uv_faces.size() != mesh.faces.size())
        return "`uv_indices` has " + std::to_string(mesh.uv_faces.size()) + " entries, but there " +
               (mesh.faces.size() == 1 ? "is " : "are ") + number_of(mesh.faces.size(), triangle);
    if (mesh.uv_faces.empty() && mesh.uvs.size() > 1 && mesh.uvs.size() != mesh.vertices.size())
        return "a `mesh2` with " + number_of(mesh.uvs.size(), uv_vector) + " for " +
               number_of(mesh.vertices.size(), vertex) + " needs `uv_indices`";
    return wrong_index(mesh.uv_faces, "uv_indices", mesh.uvs.size(), uv_vector);
}

MeshTriangle face(const Mesh& mesh, std::size_t i) {
    MeshTriangle result{{corner(mesh, i, 0), corner(mesh, i, 1), corner(mesh, i, 2)}, {}, false};
    const Vec3 own = triangle_normal(result.corners[0], result.corners[1], result.corners[2]);
    result.normals = {own, own, own};
    if (const Face* places = normals_of(mesh, i)) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 given = unit(mesh.normals[static_cast<std::size_t>((*places)[k])]);
            if (given != Vec3(0)) result.normals[k] = given;
        }
        // As in POV-Ray, three equal normals leave a face flat, and its winding decides its side.
        const std::array<Vec3, 3>& n = result.normals;
        result.smooth = n[0] != n[1] || n[1] != n[2];
        if (!result.smooth) result.normals = {own, own, own};
    }
    return result;
}

std::array<Vec2, 3> face_uvs(const Mesh& mesh, std::size_t i) {
    std::array<Vec2, 3> result = {Vec2(0), Vec2(0), Vec2(0)};
    if (mesh.uvs.empty()) return result;
    const Face* const places = !mesh.uv_faces.empty() ? &mesh.uv_faces[i]
                               : mesh.uvs.size() == 1 ? nullptr
                                                      : &mesh.faces[i];
    for (std::size_t k = 0; k < 3; ++k)
        result[k] = mesh.uvs[places ? static_cast<std::size_t>((*places)[k]) : 0];
    return result;
}

BuiltMesh build(const Mesh& mesh, const RayIndex& index) {
    std::vector<Box> boxes;
    boxes.reserve(mesh.faces.size());
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        Box box;
        for (std::size_t k = 0; k < 3; ++k) box = join(box, corner(mesh, i, k));
        boxes.push_back(box);
    }
    return {make_handle<Mesh>(mesh), PartIndex(std::move(boxes), index),
            make_handle<MeshArea>(mesh)};
}

Box bounds(const BuiltMesh& built) { return built.index.bounds(); }

void crossings(const BuiltMesh& built, const Ray& ray, Crossings& found) {
    if (ray.direction == Vec3(0)) return;
    const MeshRay along(*built.mesh, ray);
    built.index.along(ray, whole_line, [&](std::uint32_t i) {
        if (const auto crossing = along.meet(i)) found.add(*crossing);
    });
}

void nearest_crossings(const BuiltMesh& built, const Ray& ray, const Interval& range,
                       Crossings& found) {
    if (ray.direction == Vec3(0)) return;
    const MeshRay along(*built.mesh, ray);
    // Of faces that are hit at the same t, as at their edges, the first one counts, independent of
    // the order of the tests.
    std::optional<Crossing> nearest;
    std::uint32_t face = 0;
    built.index.nearest(ray, range, [&](std::uint32_t i, Interval& left) {
        const auto crossing = along.meet(i);
        if (!crossing) return;
        const bool earlier = nearest && crossing->t == nearest->t && i < face;
        if (!earlier && !left.contains(crossing->t)) return;
        left.max = crossing->t;
        nearest = crossing;
        face = i;
    });
    if (nearest) found.add(*nearest);
}

bool inside(const BuiltMesh& built, const Vec3& point) {
    const std::optional<Vec3>& direction = built.mesh->inside_vector;
    if (!direction || *direction == Vec3(0)) return false;
    Crossings found;
    crossings(built, Ray{point, *direction}, found);
    bool result = false;
    for (std::size_t i = 0; i < found.size(); ++i) result ^= found[i].t > 0;
    return result;
}

}  // namespace candelabra
