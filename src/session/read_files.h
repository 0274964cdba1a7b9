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

/// A reader that notes what it has read, each file once as long as it stays the same. The list
/// outlives it.
Reader noting(Reader, std::vector<ReadFile>&);

}  // namespace candelabra
