// SPDX-License-Identifier: GPL-3.0-or-later
// The second line of defence. FileAccess decides which files a scene may name. The sandbox also
// takes from the process the ability to open others, so that a defect in a reader or in FileAccess
// does no harm. It uses Linux's Landlock for files and seccomp for system calls. The program
// confines itself once its inputs are known; confinement is irrevocable.
#pragma once

#include "app/confine.h"
#include "options/options.h"

#include <span>
#include <string>
#include <vector>

namespace candelabra {

struct Console;

/// Returns the rights that a run with these options needs: the system's libraries, fonts and status
/// files, the scene's folder, the current one, the library, the folders that the options name, and
/// those of all output files. `library`: the folder of the standard library, or "".
SandboxRules sandbox_rules(const Options&, const std::string& library);

/// Returns the rights of a command that makes a picture of these files: those of the system as
/// above, the files, and the folder of the output, or of each file if the options name none. With a
/// preview it may read their folders, and writes nothing.
SandboxRules sandbox_rules(const Options&, const std::string& library,
                           std::span<const std::string> files);

/// Confines the program if the options and the console ask for it. Returns false, after an error
/// has been reported, if a sandbox was requested and the system has none; warns if it has none and
/// none was requested. Runs with shell commands are not confined, since those may need anything.
bool confined(const Options&, const SandboxRules&, const Console&, Diagnostics&);

}  // namespace candelabra
