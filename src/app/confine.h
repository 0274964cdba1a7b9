// SPDX-License-Identifier: GPL-3.0-or-later
// What each system does of the sandbox (app/sandbox.h): it takes rights from the process.
#pragma once

#include <string>
#include <vector>

namespace candelabra {

/// The remaining rights of a confined process. Paths that do not exist are skipped.
struct SandboxRules {
    std::vector<std::string> readable;  ///< files, and folders with everything below them
    std::vector<std::string> writable;  ///< folders with everything below them; readable as well
    bool sockets = false;               ///< may open sockets
    bool programs = false;              ///< may start other programs
    std::vector<std::string> written = {};  ///< folders with everything below, not readable
    /// A writable folder of the scene's that is made before, since folders that do not exist get no
    /// rights; empty: none.
    std::string made = {};
};

/// Confines the calling thread and all threads and processes that it starts later; system calls are
/// forbidden to all threads. Returns false if the system lacks Landlock or seccomp; the one that it
/// has is then in force.
bool confine(const SandboxRules&);

}  // namespace candelabra
