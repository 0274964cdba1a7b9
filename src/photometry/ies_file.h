// SPDX-License-Identifier: GPL-3.0-or-later
// Files of ANSI/IES LM-63 of 1986, 1991, 1995, 2002 and 2019.
#pragma once

#include "photometry/photometric_file.h"

#include <string>
#include <string_view>

namespace candelabra {

/// Whether the file is of LM-63: whether it has a line `TILT=...`, or begins with the name of the
/// standard.
bool is_ies(std::string_view bytes);

/// Reads a file of LM-63. Everything behind the line of TILT is one stream of numbers. Returns an
/// error as a sentence, or an empty string.
std::string read_ies(std::string_view bytes, PhotometricFile&);

/// Names the shape of the luminous opening, which files tell by signs and zeros; the year is that
/// of the standard. Lengths in metres.
LuminousOpening ies_opening(int year, double width, double length, double height);

}  // namespace candelabra
