// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds the file that a wrong name was meant for, allowing for differences in case, `\` for `/`,
// other blanks or punctuation, another extension or none, and misspellings. Called by the loader if
// it has not found a file. Folder listings come from an argument, so that tests need no disk.

#include <functional>
#include <string>
#include <vector>

namespace candelabra {

/// Returns the names in a folder ("" is the current directory), with a `/` appended to those of
/// folders; empty if it is not a folder.
using Lister = std::function<std::vector<std::string>(const std::string& folder)>;

Lister disk_lister();

/// Returns the name, as a scene would write it, of the most similar file in one of the folders, or
/// "". The first of equally similar files is taken.
std::string similar_file(const std::string& name, const std::vector<std::string>& folders,
                         const Lister&);

}  // namespace candelabra
