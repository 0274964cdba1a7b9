// SPDX-License-Identifier: GPL-3.0-or-later
// What a file of a luminaire's photometry says, whatever its format. ies_file.h and ldt_file.h read
// files into it. They read what is common in practice, and note each thing that they read otherwise
// than it is written.
#pragma once

#include "photometry/lamp_tilt.h"
#include "photometry/photometric_web.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace candelabra {

/// A set of lamps of a luminaire. Several sets are alternatives.
struct LampSet {
    double count = 1;  ///< negative: the flux is that of the whole luminaire
    std::string type = {};
    double flux = 0;  ///< lumens of all lamps of the set
    std::string colour_temperature = {}, colour_rendering = {};
    double watts = 0;  ///< with what drives the lamps
};

/// The luminous opening. Lengths in metres.
struct LuminousOpening {
    std::string shape = "point";               ///< `rectangle`, `disc`, `vertical cylinder` ...
    double width = 0, length = 0, height = 0;  ///< with the signs of the file
};

struct PhotometricFile {
    PhotometricWeb web;        ///< in candela: with all factors of the file, without that of a tilt
    std::string format;        ///< `IES LM-63-2002`, `EULUMDAT`
    int version = 0;           ///< year of LM-63; 0 for EULUMDAT
    int symmetry_number = -1;  ///< Isym of EULUMDAT; below 0: none
    std::string symmetry;      ///< `axial`, `quadrant`, `bilateral 0-180`, `none` ...
    /// Keywords and their texts, in UTF-8. EULUMDAT's lines have the keywords of LM-63.
    std::vector<std::pair<std::string, std::string>> labels;
    std::vector<LampSet> sets;  ///< at least one; the web is that of `set`
    std::size_t set = 0;
    double lumens_per_lamp = 0;  ///< as LM-63 states it; -1: absolute photometry
    bool absolute = false;       ///< the flux of the lamps is not known apart from the luminaire's
    double watts = 0;            ///< input power
    double efficiency = 0;  ///< share of the lamps' flux that leaves, in %, as EULUMDAT states it
    std::optional<LampTilt> tilt;
    LuminousOpening opening;
    std::vector<std::string> notes;  ///< repairs, and what is odd, as sentences

    /// The text of a label, or an empty one.
    std::string_view label(std::string_view keyword) const;
    /// The flux of the lamps by the file; nothing if it does not say.
    std::optional<double> lamp_flux() const;
};

/// Files with more bytes, and tables with more entries, are refused.
inline constexpr std::size_t max_photometric_bytes = std::size_t{16} << 20;
/// Greater intensities are refused, in candela.
inline constexpr double max_candela = 1e9;
inline constexpr double max_photometric_angles = 4096, max_photometric_entries = 1e6;

/// Options of reading.
struct PhotometricChoice {
    std::size_t set = 0;  ///< of EULUMDAT's lamp sets, from 0
};

/// Reads a file of either format, by its contents. Returns an error as a sentence that names the
/// line, or an empty string.
std::string read_photometric(std::string_view bytes, const PhotometricChoice&, PhotometricFile&);

/// Completes a file after its table has been read: notes a flux that contradicts the lamps', and
/// openings that are too large for a luminaire.
void check_photometric(PhotometricFile&);

}  // namespace candelabra
