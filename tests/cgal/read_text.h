// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files that a test writes, as the library reads them.
#pragma once

#include "cgal/shapes.h"
#include "support/folder.h"

namespace candelabra {

struct ReadText {
    Polyhedron shape;
    PolyhedronLook look;
    std::string wrong;
};

inline ReadText read_text(const std::string& extension, const std::string& text) {
    const Folder folder;
    folder.put("a." + extension, text);
    ReadText read;
    read.wrong = the_polyhedra().read(folder / ("a." + extension), read.shape, read.look);
    return read;
}

}  // namespace candelabra
