// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/tessellation.h"

#include "base/circle.h"
#include "base/elementary.h"
#include "base/long_work.h"
#include "shape/triangle.h"

#include <iterator>
#include <numbers>
#include <unordered_map>

namespace candelabra {

namespace {

using std::numbers::pi;

// ---- marching

/// Minimum distance of vertices from the ends of an edge, as a fraction of its length, so that no
/// two of them coincide.
constexpr double apart = 0.03;
/// Number of bisections of an edge to find the surface.
constexpr int halvings = 18;

/// A cube is split into six tetrahedra around its diagonal. Each is a path from corner 0 to corner
/// 7 along three edges: successive corners differ in one bit (x 1, y 2, z 4).
constexpr auto tetrahedra = std::array<std::array<int, 4>, 6>{
    {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}}};

class Marcher {
public:
    Marcher(const Box& box, FunctionRef<bool(const Vec3&)> inside, int cells) : inside_(inside) {
        cell_ = max_component(box.size()) / cells;
        if (!(cell_ > 0)) return;
        // One more layer of cells on all sides, offset against the box: axis-aligned surfaces would
        // otherwise pass through the corners of cells.
        low_ = box.low - 1.37 * Vec3(cell_);
        for (int axis = 0; axis < 3; ++axis)
            size_[axis] = static_cast<std::int64_t>(std::ceil(box.size()[axis] / cell_)) + 4;
    }

    Mesh march() {
        if (!(cell_ > 0)) return {};
        within_.resize(static_cast<std::size_t>(size_[0] * size_[1] * size_[2]));
        for (std::int64_t i = 0; i < std::ssize(within_); ++i) {
            count_work(1);
            within_[static_cast<std::size_t>(i)] = inside_(place(i)) ? 1 : 0;
        }
        for (std::int64_t z = 0; z + 1 < size_[2]; ++z)
            for (std::int64_t y = 0; y + 1 < size_[1]; ++y)
                for (std::int64_t x = 0; x + 1 < size_[0]; ++x)
                    take_cell(x + size_[0] * (y + size_[1] * z));
        return std::move(mesh_);
    }

private:
    std::int64_t step(int corner) const {
        return (corner & 1) + size_[0] * ((corner >> 1 & 1) + size_[1] * (corner >> 2 & 1));
    }
    bool within(std::int64_t i) const { return within_[static_cast<std::size_t>(i)] != 0; }
    Vec3 place(std::int64_t i) const {
        const std::int64_t row = i / size_[0];
        return low_ + cell_ * Vec3(static_cast<double>(i % size_[0]),
                                   static_cast<double>(row % size_[1]),
                                   static_cast<double>(row / size_[1]));
    }

    void take_cell(std::int64_t first) {
        int inside = 0;
        for (int corner = 0; corner < 8; ++corner) inside += within(first + step(corner));
        if (inside == 0 || inside == 8) return;
        for (const std::array<int, 4>& corners : tetrahedra) take_tetrahedron(first, corners);
    }

    void take_tetrahedron(std::int64_t first, const std::array<int, 4>& corners) {
        std::array<std::int64_t, 4> in{}, out{};
        std::size_t ins = 0, outs = 0;
        for (const int corner : corners) {
            const std::int64_t at = first + step(corner);
            (within(at) ? in[ins++] : out[outs++]) = at;
        }
        if (ins == 0 || outs == 0) return;
        Vec3 outward(0);
        for (std::size_t i = 0; i < outs; ++i) outward += place(out[i]) / static_cast<double>(outs);
        for (std::size_t i = 0; i < ins; ++i) outward -= place(in[i]) / static_cast<double>(ins);
        if (ins == 1) {
            add({corner(in[0], out[0]), corner(in[0], out[1]), corner(in[0], out[2])}, outward);
        } else if (outs == 1) {
            add({corner(in[0], out[0]), corner(in[1], out[0]), corner(in[2], out[0])}, outward);
        } else {
            const int a = corner(in[0], out[0]), b = corner(in[0], out[1]),
                      c = corner(in[1], out[1]), d = corner(in[1], out[0]);
            add({a, b, c}, outward);
            add({a, c, d}, outward);
        }
    }

    void add(Face face, const Vec3& outward) {
        const auto at = [&](std::size_t i) -> const Vec3& {
            return mesh_.vertices[static_cast<std::size_t>(face[i])];
        };
        if (dot(cross(at(1) - at(0), at(2) - at(0)), outward) < 0) std::swap(face[1], face[2]);
        mesh_.faces.push_back(face);
    }

    /// The vertex where the surface crosses the edge between two corners of cells.
    int corner(std::int64_t in, std::int64_t out) {
        const std::int64_t low = std::min(in, out), high = std::max(in, out);
        const auto key = static_cast<std::uint64_t>(low) << 32 ^ static_cast<std::uint64_t>(high);
        const auto [known, added] =
            known_.try_emplace(key, static_cast<int>(mesh_.vertices.size()));
        if (!added) return known->second;
        count_work(halvings);
        const Vec3 from = place(in), to = place(out);
        double least = 0, most = 1;
        for (int i = 0; i < halvings; ++i) {
            const double middle = 0.5 * (least + most);
            (inside_(glm::mix(from, to, middle)) ? least : most) = middle;
        }
        mesh_.vertices.push_back(
            glm::mix(from, to, std::clamp(0.5 * (least + most), apart, 1 - apart)));
        return known->second;
    }

    FunctionRef<bool(const Vec3&)> inside_;
    double cell_ = 0;
    Vec3 low_ = Vec3(0);
    std::array<std::int64_t, 3> size_{};  ///< numbers of corners of cells
    std::vector<char> within_;
    std::unordered_map<std::uint64_t, int> known_;
    Mesh mesh_;
};

// ---- shapes with dedicated triangulations

struct Axes {
    Vec3 origin, out, up, side;
};

/// A line of points <radius, height> turned about the axis `up`; seen with `up` upwards, the
/// outside is on its right. A point of radius 0 becomes a single vertex.
Mesh revolved(const std::vector<Vec2>& line, const Axes& axes, int around) {
    Mesh mesh;
    std::vector<int> starts;
    for (const Vec2& p : line) {
        starts.push_back(static_cast<int>(mesh.vertices.size()));
        for (int i = 0; i < (p.x > 0 ? around : 1); ++i) {
            const double angle = 2 * pi * i / around;
            mesh.vertices.push_back(axes.origin + p.y * axes.up +
                                    p.x * on_circle(angle, axes.out, axes.side));
        }
    }
    for (std::size_t row = 0; row + 1 < line.size(); ++row) {
        const bool low_ring = line[row].x > 0, high_ring = line[row + 1].x > 0;
        for (int i = 0; i < around; ++i) {
            const int next = (i + 1) % around;
            const int a = starts[row] + (low_ring ? i : 0), b = starts[row] + (low_ring ? next : 0);
            const int c = starts[row + 1] + (high_ring ? next : 0),
                      d = starts[row + 1] + (high_ring ? i : 0);
            if (low_ring) mesh.faces.push_back({a, b, c});
            if (high_ring) mesh.faces.push_back({a, c, d});
        }
    }
    return mesh;
}

Axes axes_about(const Vec3& origin, const Vec3& up) {
    const auto [x, y] = perpendiculars(up);
    // (out, side, up) is right-handed, as perpendiculars() returns it.
    return {origin, x, up, y};
}

Mesh triangles_of(const Sphere& s, int cells) {
    std::vector<Vec2> line;
    for (int i = 0; i <= cells; ++i) {
        const double angle = pi * i / cells;
        line.push_back(
            {i % cells == 0 ? 0 : s.radius * math::sin(angle), -s.radius * math::cos(angle)});
    }
    return revolved(line, axes_about(s.centre, Vec3(0, 1, 0)), 2 * cells);
}

Mesh triangles_of(const Cone& c, int cells) {
    const double height = length(c.cap - c.base);
    std::vector<Vec2> line = {{c.base_radius, 0}, {c.cap_radius, height}};
    if (!c.open && c.base_radius > 0) line.insert(line.begin(), Vec2(0));
    if (!c.open && c.cap_radius > 0) line.push_back({0, height});
    return revolved(line, axes_about(c.base, (c.cap - c.base) / height), 2 * cells);
}

Mesh triangles_of(const Cylinder& c, int cells) {
    return triangles_of(Cone{c.base, c.radius, c.cap, c.radius, c.open}, cells);
}

Mesh triangles_of(const Disc& d, int cells) {
    return revolved({{d.radius, 0}, {d.hole, 0}}, axes_about(d.centre, unit(d.normal)), 2 * cells);
}

Mesh triangles_of(const Torus& t, int cells) {
    if (!(t.minor > 0) || t.minor >= t.major)
        return marched(
            bounds(t), [&](const Vec3& p) { return inside(t, p); }, cells);
    Mesh mesh;
    const int around = 2 * cells, across = std::max(16, cells / 2);
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double turn = 2 * pi * i / around, lift = 2 * pi * j / across;
            const double radius = t.major + t.minor * math::cos(lift);
            mesh.vertices.push_back(
                {radius * math::cos(turn), t.minor * math::sin(lift), radius * math::sin(turn)});
        }
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const auto at = [&](int k, int l) {
                return (i + k) % around * across + (j + l) % across;
            };
            mesh.faces.push_back({at(0, 0), at(0, 1), at(1, 1)});
            mesh.faces.push_back({at(0, 0), at(1, 1), at(1, 0)});
        }
    return mesh;
}

Mesh triangles_of(const Cuboid& c, int) {
    const Box box = bounds(c);
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back({(i & 1 ? box.high : box.low).x, (i & 2 ? box.high : box.low).y,
                                 (i & 4 ? box.high : box.low).z});
    mesh.faces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                  {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

void add_triangle(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
    const int first = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
    mesh.faces.push_back({first, first + 1, first + 2});
}
template <class T>
Mesh one_triangle(const T& t) {
    Mesh mesh;
    add_triangle(mesh, t.corner1, t.corner2, t.corner3);
    return mesh;
}
Mesh triangles_of(const Triangle& t, int) { return one_triangle(t); }
Mesh triangles_of(const SmoothTriangle& t, int) { return one_triangle(t); }
Mesh triangles_of(const BuiltMesh& m, int) {
    Mesh mesh;
    mesh.vertices = m.mesh->vertices;
    mesh.faces = m.mesh->faces;
    return mesh;
}
Mesh triangles_of(const BuiltBicubicPatch& patch, int) {
    Mesh mesh;
    for (const auto& facet : patch.facets)
        add_triangle(mesh, facet.corners[0], facet.corners[1], facet.corners[2]);
    return mesh;
}
Mesh triangles_of(const BuiltParametric& surface, int) {
    Mesh mesh;
    mesh.vertices = surface.net;
    const int row = static_cast<int>(std::lround(std::sqrt(surface.net.size())));
    for (int v = 0; v + 1 < row; ++v)
        for (int u = 0; u + 1 < row; ++u) {
            const int a = v * row + u, b = a + row;
            mesh.faces.push_back({a, a + 1, b + 1});
            mesh.faces.push_back({a, b + 1, b});
        }
    return mesh;
}
Mesh triangles_of(const BuiltPolygon&, int) { return {}; }

template <ShapeKind T>
Mesh triangles_of(const T& shape, int cells) {
    return marched(
        clip(bounds(shape), inside_bounds(shape)), [&](const Vec3& p) { return inside(shape, p); },
        cells);
}

}  // namespace

Mesh marched(const Box& box, FunctionRef<bool(const Vec3&)> inside, int cells) {
    if (box.empty() || !finite(box)) return {};
    return Marcher(box, inside, cells).march();
}

Mesh tessellation(const BuiltShape& shape, int cells) {
    Mesh mesh = visit_shape([&](const auto& s) { return triangles_of(s, cells); }, shape);
    constexpr std::uint64_t work_of_face = 3;
    count_long_work(work_of_face * mesh.faces.size());
    return mesh;
}

std::optional<Composite::Meeting> surface_near(const Composite& whole,
                                               const std::array<Vec3, 3>& corners,
                                               const Vec3& point, Composite::Wanted wanted) {
    const Vec3 normal = triangle_normal(corners[0], corners[1], corners[2]);
    if (normal == Vec3(0)) return std::nullopt;
    const double reach = length(corners[1] - corners[0]) + length(corners[2] - corners[0]);
    return whole.first(Ray{point - reach * normal, normal}, Interval{0, 2 * reach}, wanted);
}

void append(const Mesh& part, const Transform* map, Mesh& all) {
    count_long_work(part.faces.size());
    const int first = static_cast<int>(all.vertices.size());
    for (const Vec3& v : part.vertices) all.vertices.push_back(map ? map->point(v) : v);
    const bool mirrored = map && map->determinant() < 0;
    for (const Face& face : part.faces)
        all.faces.push_back(
            {face[0] + first, face[mirrored ? 2 : 1] + first, face[mirrored ? 1 : 2] + first});
}

Mesh seen_tessellation(const Composite& whole, std::uint32_t number, int cells) {
    const CompositeLeaf& leaf = whole.leaf(number);
    if (whole.leaf_bounds(number).empty()) return {};
    Mesh mesh;
    append(tessellation(leaf.shape, cells), leaf.transform.get(), mesh);
    const bool cut = whole.leaf_count() > 1;
    std::erase_if(mesh.faces, [&](const Face& each) {
        if (!cut) return false;
        std::array<Vec3, 3> at;
        for (std::size_t i = 0; i < 3; ++i)
            at[i] = mesh.vertices[static_cast<std::size_t>(each[i])];
        return !surface_near(whole, at, (at[0] + at[1] + at[2]) / 3.0,
                             [&](std::uint32_t other) { return other == number; });
    });
    if (leaf.inverse)
        for (Face& each : mesh.faces) std::swap(each[1], each[2]);
    return mesh;
}

Mesh seen_tessellation(const Composite& whole, int cells) {
    Mesh all;
    for (std::uint32_t leaf = 0; leaf < whole.leaf_count(); ++leaf)
        append(seen_tessellation(whole, leaf, cells), nullptr, all);
    return all;
}

}  // namespace candelabra
