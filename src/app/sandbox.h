// SPDX-License-Identifier: GPL-3.0-or-later
// The second wall. FileAccess decides which files a scene may name; the sandbox takes
// from the process itself the power to open others, so that a mistake in a reader or in FileAccess
// reaches nothing. It stands on Linux's Landlock for files and seccomp for system calls. The
// program confines itself once its inputs are known; nothing can undo that.
#pragma once

#include "app/options.h"

#include <span>
#include <string>
#include <vector>

namespace candelabra {

struct Console;

/// All that a confined process may still do. Paths that do not exist are passed over.
struct SandboxRules {
    std::vector<std::string> readable;  ///< files, and folders with everything below them
    std::vector<std::string> writable;  ///< folders with everything below them; readable as well
    bool sockets = false;               ///< may open sockets
    bool programs = false;              ///< may start other programs
};

/// What a run with these options needs: the system's libraries, fonts and figures, the scene's
/// folder, the current one, the library, the folders that the options name, and those of all files
/// that it makes. `library`: the folder of the standard library, or "".
SandboxRules sandbox_rules(const Options&, const std::string& library);

/// What a command needs that makes a picture of such files: the system's as above, the files, and
/// the folder of the output, or of each file if the options name none.
SandboxRules sandbox_rules(const Options&, const std::string& library,
                           std::span<const std::string> files);

/// Confines the calling thread and all that it starts from now on; system calls are forbidden to
/// all threads. False when the system has no Landlock or no seccomp; what it has is in force then.
bool confine(const SandboxRules&);

/// Confines the program, if the options and the console want that. False after a report: a sandbox
/// was asked for, and the system has none. Commands of the shell may need anything.
bool confined(const Options&, const SandboxRules&, const Console&, Diagnostics&);

}  // namespace candelabra
