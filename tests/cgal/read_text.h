// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the texts of mesh files as the library does.
#pragma once

#include "cgal/shapes.h"

namespace candelabra {

struct ReadText {
    Polyhedron shape;
    PolyhedronLook look;
    std::string wrong;
};

inline ReadText read_text(const std::string& extension, const std::string& text) {
    ReadText read;
    read.wrong = the_polyhedra().read("a." + extension, text, read.shape, read.look);
    return read;
}

}  // namespace candelabra
