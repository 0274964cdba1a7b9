// SPDX-License-Identifier: GPL-3.0-or-later
#include "polyhedra/fan.h"
#include "polyhedra/obj_reader.h"
#include "polyhedra/operations.h"
#include "polyhedra/ply_reader.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <fstream>
#include <sstream>

namespace {

bool ends_in(const std::string& path, std::string_view extension) {
    const std::size_t dot = path.rfind('.');
    return dot != std::string::npos &&
           std::ranges::equal(path.substr(dot + 1), extension, {},
                              [](unsigned char c) { return std::tolower(c); });
}

/// STL and OFF, by CGAL, which sees neither normals nor places in pictures. Its readers of the
/// other kinds see none, either, and trust the types that a PLY file names.
std::string read_soup(const std::string& path, Polyhedron& made) {
    std::vector<polyhedra::Kernel::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    if (!CGAL::IO::read_polygon_soup(path, points, faces, CGAL::parameters::verbose(false)))
        return "it is no OBJ, PLY, STL or OFF file, or is damaged";
    for (const auto& p : points) made.points.push_back({p.x(), p.y(), p.z()});
    for (const auto& face : faces) {
        std::vector<int> places;
        for (const std::size_t corner : face) places.push_back(polyhedra::place(corner));
        polyhedra::add_fan(places, made.faces);
    }
    return {};
}

/// Whether all that is named is there. Normals and uv without faces of their own are the points'.
std::string wrong_places(const Polyhedron& made, const PolyhedronLook& look) {
    for (const std::string& wrong :
         {polyhedra::wrong_place(made.faces, made.points.size(), "a point"),
          polyhedra::wrong_place(look.normal_faces, look.normals.size(), "a normal"),
          polyhedra::wrong_place(look.uv_faces, look.uvs.size(), "a `vt`")})
        if (!wrong.empty()) return wrong;
    return {};
}

}  // namespace

std::string polyhedra::read(const std::string& path, Polyhedron& made, PolyhedronLook& look) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return "the file cannot be opened";
    const bool obj = ends_in(path, "obj");
    std::string wrong;
    if (obj || ends_in(path, "ply")) {
        std::ostringstream text;
        text << file.rdbuf();
        wrong = obj ? read_obj(text.view(), made, look) : read_ply(text.view(), made, look);
    } else {
        wrong = read_soup(path, made);
    }
    if (wrong.empty()) wrong = wrong_places(made, look);
    return wrong.empty() && made.faces.empty() ? "it has no faces" : wrong;
}
