// SPDX-License-Identifier: GPL-3.0-or-later
// The polar diagram of a luminaire: intensity by direction, in two planes that cross at right
// angles, as on data sheets.
#pragma once

#include "photometry/photometric_file.h"

#include <array>
#include <string>
#include <string_view>

namespace candelabra {

/// A plane through the luminaire.
struct WebSection {
    std::string name;  ///< of the plane, as the format calls it
    /// Unit vectors: the angle goes from `start` to `side`.
    Vec3 start, side;
    bool solid = true;  ///< how the line is drawn
};

/// Returns the two planes: through the vertical axis for types C and B, through the beam for A.
std::array<WebSection, 2> sections_of(const PhotometricFile&);

/// Returns the intensity in candela in the section at an angle in degrees from its start.
double intensity_in(const PhotometricWeb&, const WebSection&, double degrees);

/// Returns the full angle in degrees within which the intensity stays above a share of the greatest
/// of the section: 0.5 for the beam angle, 0.1 for the field angle. 0 if the section is dark.
double width_of_beam(const PhotometricWeb&, const WebSection&, double share);

/// Returns the diagram in lines of characters for a terminal: `*` for the first section, `o` for
/// the second, `@` where they meet.
std::string polar_text(const PhotometricFile&);

/// Returns the diagram as an SVG picture with a title.
std::string polar_diagram(const PhotometricFile&, std::string_view title);

}  // namespace candelabra
