// SPDX-License-Identifier: GPL-3.0-or-later
// The files that say what lamps do in the frames of `candelabra relight`.
#pragma once

#include "options/options.h"
#include "relight/light_show.h"
#include "text/diagnostic.h"

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// Values of the options of the same names, as they were given; empty: none.
struct ShowFiles {
    std::string table;     ///< of --csv
    std::string fseq;      ///< of --fseq
    std::string raw;       ///< of --raw: bytes of channels
    std::string channels;  ///< of --channels: of a frame in the bytes
    std::string patch;     ///< of --patch
    std::string curve;     ///< of --curve
    std::vector<std::string> settings = {};  ///< of each --set

    /// The files that are read.
    std::vector<std::string> paths() const;
};

/// Takes an option that says what lamps do, such as `--fseq`. Returns false for other options.
bool take_show_option(std::string_view option, std::string value, ShowFiles&);

/// Reads the files and the settings into a show. A file that says how many frames a second it has
/// sets the rate, unless the options do. Returns false after an error has been reported.
bool read_show(const ShowFiles&, LightShow&, Options&, Diagnostics&);

}  // namespace candelabra
