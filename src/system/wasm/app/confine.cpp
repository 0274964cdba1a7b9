// SPDX-License-Identifier: GPL-3.0-or-later
// WebAssembly reaches nothing but what the page or node gives to it. In node this is the disk, of
// which the worker keeps only these folders open (src/packaging/npm/lib/disk.mjs).
#include "app/confine.h"

extern "C" {
/// Allows one more path, from then on nothing but what has been allowed: 0 to read, 1 to read and
/// write, 2 to write.
void candelabra_allow(const char* path, int rights);
}

namespace candelabra {

bool confine(const SandboxRules& rules) {
    for (const std::string& path : rules.readable) candelabra_allow(path.c_str(), 0);
    for (const std::string& path : rules.writable) candelabra_allow(path.c_str(), 1);
    for (const std::string& path : rules.written) candelabra_allow(path.c_str(), 2);
    return true;
}

}  // namespace candelabra
