// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/loaded_library.h"

#include <dlfcn.h>

namespace candelabra {

LoadedFunction load_function(const char* library, const char* function) {
    void* const opened = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
    void* const address = opened ? dlsym(opened, function) : nullptr;
    return {address, address ? std::string() : std::string(dlerror())};
}

}  // namespace candelabra
