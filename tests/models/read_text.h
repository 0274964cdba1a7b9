// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the texts of files of models.
#pragma once

#include "models/model_file.h"

#include <catch2/catch.hpp>

namespace candelabra {

struct ReadText {
    Polyhedron shape;
    PolyhedronLook look;
    std::string wrong;
};

inline ReadText read_text(const std::string& extension, const std::string& text) {
    ReadText read;
    read.wrong = read_model("a." + extension, text, read.shape, read.look);
    return read;
}

}  // namespace candelabra
