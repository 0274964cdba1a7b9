// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/loaded_library.h"

namespace candelabra {

LoadedFunction load_function(const char*, const char*) {
    return {nullptr, "the program as WebAssembly comes without it; the program for Linux has it"};
}

}  // namespace candelabra
