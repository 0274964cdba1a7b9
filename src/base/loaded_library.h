// SPDX-License-Identifier: GPL-3.0-or-later
// A library that the program opens on demand, so that features which few scenes use need not be
// present at each start. Used for picture formats and for polyhedra.
#pragma once

#include <string>

namespace candelabra {

struct LoadedFunction {
    void* address = nullptr;  ///< null: not available
    std::string problem;      ///< the reason, as the system reports it
};

/// Opens the library permanently and looks up its function. A name without a folder is searched
/// beside the program and where it was installed, according to the program's run path.
LoadedFunction load_function(const char* library, const char* function);

}  // namespace candelabra
