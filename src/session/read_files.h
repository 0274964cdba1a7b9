// SPDX-License-Identifier: GPL-3.0-or-later
// The files that a scene was made from.
#pragma once

#include "text/loader.h"

#include <string>
#include <vector>

namespace candelabra {

struct ReadFile {
    std::string path;
    std::string digest;  ///< SHA-256

    friend bool operator==(const ReadFile&, const ReadFile&) = default;
};

/// Returns a reader that records the files it has read. Each file is listed once as long as it
/// stays the same. The list must outlive the reader.
Reader noting(Reader, std::vector<ReadFile>&);

}  // namespace candelabra
