// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds the file that was meant by a name that leads to none: other case of letters, `\` for `/`,
// blanks or signs that differ, another extension or none, a slip of the pen. The loader asks when
// it has not found a file; what folders hold is an argument, so that tests need no disk.

#include <functional>
#include <string>
#include <vector>

namespace candelabra {

/// The names in a folder ("" is the current directory); nothing for what is no folder. Folders
/// among them end in `/`.
using Lister = std::function<std::vector<std::string>(const std::string& folder)>;

Lister disk_lister();

/// The name, as a scene would write it, of the file that is most like it in one of the folders, or
/// "". Of equally good ones the first.
std::string similar_file(const std::string& name, const std::vector<std::string>& folders,
                         const Lister&);

}  // namespace candelabra
