// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/model_file.h"

#include "models/fan.h"
#include "models/obj_reader.h"
#include "models/off_reader.h"
#include "models/ply_reader.h"
#include "models/stl_reader.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <exception>
#include <utility>

namespace candelabra {

namespace {

bool ends_in(std::string_view name, std::string_view extension) {
    const std::size_t dot = name.rfind('.');
    return dot != name.npos && std::ranges::equal(name.substr(dot + 1), extension, {},
                                                  [](unsigned char c) { return std::tolower(c); });
}

/// Describes an invalid number or index; empty when there is none. Normals and texture coordinates
/// without faces of their own are those of the points.
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

/// Calls the reader for the kind of file that the name's extension gives.
std::string read_bytes(std::string_view name, std::string_view bytes, Polyhedron& made,
                       PolyhedronLook& look) {
    if (ends_in(name, "obj")) return polyhedra::read_obj(bytes, made, look);
    if (ends_in(name, "ply")) return polyhedra::read_ply(bytes, made, look);
    if (ends_in(name, "stl")) return polyhedra::read_stl(bytes, made);
    if (ends_in(name, "off")) return polyhedra::read_off(bytes, made);
    return "it is no OBJ, PLY, STL or OFF file, or is damaged";
}

}  // namespace

std::string read_model(std::string_view name, std::string_view bytes, Polyhedron& made,
                       PolyhedronLook& look) {
    try {
        Polyhedron shape;
        PolyhedronLook of_shape;
        std::string wrong = read_bytes(name, bytes, shape, of_shape);
        if (wrong.empty()) wrong = wrong_places(shape, of_shape);
        if (wrong.empty() && shape.faces.empty()) wrong = "it has no faces";
        if (!wrong.empty()) return wrong;
        made = std::move(shape);
        look = std::move(of_shape);
        return {};
    } catch (const std::exception& problem) {  // a file may be larger than memory
        return problem.what();
    }
}

}  // namespace candelabra
