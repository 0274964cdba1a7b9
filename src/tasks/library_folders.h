// SPDX-License-Identifier: GPL-3.0-or-later
// The folders in which a scene's files are looked for.
#pragma once

#include "text/diagnostic.h"

#include <string>
#include <vector>

namespace candelabra {

/// Returns the folders that are searched for files, in order: those that come before the standard
/// library, the standard library (empty: none), the folders of the options, and the library's
/// pictures and models. Warns of a folder that does not exist.
std::vector<std::string> library_folders(const std::vector<std::string>& first,
                                         const std::string& standard,
                                         const std::vector<std::string>& given, Diagnostics&);

}  // namespace candelabra
