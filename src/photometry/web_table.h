// SPDX-License-Identifier: GPL-3.0-or-later
// Completes the table of a photometric file to all directions: a file leaves out what follows from
// a symmetry.
#pragma once

#include "photometry/photometric_web.h"

#include <string>
#include <vector>

namespace candelabra {

/// A table as it stands in a file.
struct WebTable {
    WebType type = WebType::c;
    std::vector<double> vertical;    ///< degrees
    std::vector<double> horizontal;  ///< degrees
    std::vector<double> candela;     ///< all vertical angles of a plane, plane by plane
};

/// Returns the web of a table in LM-63's symmetries, and names the symmetry. One plane of type C is
/// the same all around; planes over 90 degrees are mirrored at both ends, those over 180 degrees at
/// the plane through their ends; others must go around. Tables of types A and B that begin at 0 are
/// mirrored there. What is repaired is noted. Returns an error as a sentence, or an empty string.
std::string complete_table(WebTable table, PhotometricWeb& web, std::string& symmetry,
                           std::vector<std::string>& notes);

/// Makes the web of a table of type C whose planes go around, perhaps without the last, which is
/// the first again.
PhotometricWeb closed_web(WebTable table, std::vector<std::string>& notes);

}  // namespace candelabra
