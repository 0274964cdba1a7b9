// SPDX-License-Identifier: GPL-3.0-or-later
#include "cgal/fan.h"
#include "cgal/obj_reader.h"
#include "cgal/off_reader.h"
#include "cgal/operations.h"
#include "cgal/ply_reader.h"
#include "cgal/stl_reader.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

namespace candelabra {

namespace {

bool ends_in(const std::string& path, std::string_view extension) {
    const std::size_t dot = path.rfind('.');
    return dot != std::string::npos &&
           std::ranges::equal(path.substr(dot + 1), extension, {},
                              [](unsigned char c) { return std::tolower(c); });
}

/// Whether all that is named is there. Normals and uv without faces of their own are the points'.
std::string wrong_places(const Polyhedron& made, const PolyhedronLook& look) {
    for (const std::string& wrong :
         {polyhedra::not_finite(made.points), polyhedra::not_finite(look.normals),
          polyhedra::not_finite(look.uvs),
          polyhedra::wrong_place(made.faces, made.points.size(), "a point"),
          polyhedra::wrong_place(look.normal_faces, look.normals.size(), "a normal"),
          polyhedra::wrong_place(look.uv_faces, look.uvs.size(), "a `vt`")})
        if (!wrong.empty()) return wrong;
    return {};
}

/// By the kind that the name says.
std::string read_text(const std::string& path, std::string_view text, Polyhedron& made,
                      PolyhedronLook& look) {
    if (ends_in(path, "obj")) return polyhedra::read_obj(text, made, look);
    if (ends_in(path, "ply")) return polyhedra::read_ply(text, made, look);
    if (ends_in(path, "stl")) return polyhedra::read_stl(text, made);
    if (ends_in(path, "off")) return polyhedra::read_off(text, made);
    return "it is no OBJ, PLY, STL or OFF file, or is damaged";
}

}  // namespace

std::string polyhedra::read(const std::string& path, Polyhedron& made, PolyhedronLook& look) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return "the file cannot be opened";
    std::ostringstream text;
    text << file.rdbuf();
    Polyhedron shape;
    PolyhedronLook of_shape;
    std::string wrong = read_text(path, text.view(), shape, of_shape);
    if (wrong.empty()) wrong = wrong_places(shape, of_shape);
    if (wrong.empty() && shape.faces.empty()) wrong = "it has no faces";
    if (!wrong.empty()) return wrong;
    made = std::move(shape);
    look = std::move(of_shape);
    return {};
}

}  // namespace candelabra
