// SPDX-License-Identifier: GPL-3.0-or-later
// Extruded letters of a font. The reader of the language fills in the outlines, which come from the
// font's file; rays are tested against the BuiltText.
#pragma once

#include "base/handle.h"
#include "shape/prism.h"

#include <string>

namespace candelabra {

/// Outlines of the letters of a text, as closed curves.
struct Letters {
    std::vector<std::vector<CurvePiece>> loops;
};

/// Letters from z = 0 to the thickness, along the x axis.
struct Text {
    std::string font;  ///< name of the font's file
    int internal = 0;  ///< number of one of POV-Ray's own fonts; 0: none
    std::string text;
    double thickness = 1;
    Vec3 offset = Vec3(0);
    Handle<Letters> letters;

    static const ItemInfo vocabulary;
};

struct BuiltText {
    BuiltPrism prism;  ///< with y and z exchanged
};

/// Error that the ranges of single fields do not exclude (no font, no thickness), as a sentence;
/// empty when there is none.
std::string problem(const Text&);
/// See shape.h.
std::string vanishes(const Text&);
BuiltText build(const Text&);

Box bounds(const BuiltText&);
void crossings(const BuiltText&, const Ray&, Crossings&);
bool inside(const BuiltText&, const Vec3&);

}  // namespace candelabra
