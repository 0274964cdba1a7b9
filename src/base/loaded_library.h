// SPDX-License-Identifier: GPL-3.0-or-later
// A library that the program opens when it needs it: what few scenes use need not be there at each
// start. Called for picture formats and for polyhedra.
#pragma once

#include <string>

namespace candelabra {

struct LoadedFunction {
    void* address = nullptr;  ///< null: there is none
    std::string problem;      ///< why, in the system's words
};

/// Opens the library for good and looks for its function. A name without a folder is found beside
/// the program or where it was installed: the program's run path says.
LoadedFunction load_function(const char* library, const char* function);

}  // namespace candelabra
