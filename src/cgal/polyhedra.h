// SPDX-License-Identifier: GPL-3.0-or-later
// What CGAL knows of surfaces made of triangles: files, hulls, boolean operations, subdivision,
// triangulations. CGAL's headers take minutes to compile and its exact numbers need
// libraries of their own; so this module is a library that is opened when a scene first asks for
// such work. It knows plain lists of points and faces only.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

namespace candelabra {

/// Triangles over shared points. Faces name points by their place, counted from 0, in
/// counterclockwise order as seen from outside (in a right-handed space).
struct Polyhedron {
    using Point = std::array<double, 3>;
    using Face = std::array<int, 3>;

    std::vector<Point> points;
    std::vector<Face> faces;
};

/// What files say of a surface beyond its shape, as far as they do. Without faces of their own,
/// normals and places in pictures are those of the points.
struct PolyhedronLook {
    std::vector<Polyhedron::Point> normals;
    std::vector<Polyhedron::Face> normal_faces;
    std::vector<std::array<double, 2>> uvs;
    std::vector<Polyhedron::Face> uv_faces;
    bool materials = false;  ///< faces have materials, which are not read
};

/// A step on the way to a solid that is made of others: each puts a solid on a stack. All but the
/// first kind take the two uppermost from there.
enum class SolidOperation {
    take,       ///< the next of those that are given
    join,       ///< inside either
    intersect,  ///< inside both
    subtract,   ///< inside the lower one and not the upper one
};

/// How a surface is divided and smoothed.
enum class SubdivisionRule {
    loop,  ///< Loop: every point moves; the limit is curved evenly
    root3  ///< Kobbelt: a third as many new faces a step
};

/// The entry points. Each returns what went wrong, or an empty string; what it gives is then
/// complete.
struct Polyhedra {
    /// The triangles in the bytes of an OBJ, PLY, STL or OFF file, which the end of its name tells;
    /// larger faces are taken apart. Normals and places in pictures are those of OBJ and PLY files.
    std::string (*read)(std::string_view name, std::string_view bytes, Polyhedron&,
                        PolyhedronLook&);
    /// The smallest convex polyhedron around the points.
    std::string (*hull)(std::span<const Polyhedron::Point>, Polyhedron&);
    /// A solid from closed surfaces that do not cut themselves. Exact: coordinates are rounded
    /// once, at the end. Precondition: the steps leave one solid on the stack.
    std::string (*combine)(std::span<const SolidOperation>, std::span<const Polyhedron>,
                           Polyhedron&);
    std::string (*subdivide)(const Polyhedron&, SubdivisionRule, int steps, Polyhedron&);
    /// The Delaunay triangulation of points of a plane.
    std::string (*triangulate)(std::span<const std::array<double, 2>>,
                               std::vector<Polyhedron::Face>&);
};

/// The name of the library, and of its one function: `const Polyhedra* candelabra_polyhedra()`.
inline constexpr auto polyhedra_library = "libcandelabra_cgal.so";
inline constexpr auto polyhedra_function = "candelabra_polyhedra";

}  // namespace candelabra
