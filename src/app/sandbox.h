// SPDX-License-Identifier: GPL-3.0-or-later
// The second line of defence. FileAccess decides which files a scene may name. The sandbox also
// takes from the process the ability to open others, so that a defect in a reader or in FileAccess
// does no harm. It uses Linux's Landlock for files and seccomp for system calls. The program
// confines itself once its inputs are known; confinement is irrevocable.
#pragma once

#include "options/options.h"

#include <span>
#include <string>
#include <vector>

namespace candelabra {

struct Console;

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

/// Returns the rights that a run with these options needs: the system's libraries, fonts and status
/// files, the scene's folder, the current one, the library, the folders that the options name, and
/// those of all output files. `library`: the folder of the standard library, or "".
SandboxRules sandbox_rules(const Options&, const std::string& library);

/// Returns the rights of a command that makes a picture of these files: those of the system as
/// above, the files, and the folder of the output, or of each file if the options name none.
SandboxRules sandbox_rules(const Options&, const std::string& library,
                           std::span<const std::string> files);

/// Confines the calling thread and all threads and processes that it starts later; system calls are
/// forbidden to all threads. Returns false if the system lacks Landlock or seccomp; the one that it
/// has is then in force.
bool confine(const SandboxRules&);

/// Confines the program if the options and the console ask for it. Returns false, after an error
/// has been reported, if a sandbox was requested and the system has none; warns if it has none and
/// none was requested. Runs with shell commands are not confined, since those may need anything.
bool confined(const Options&, const SandboxRules&, const Console&, Diagnostics&);

}  // namespace candelabra
