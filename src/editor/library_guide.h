// SPDX-License-Identifier: GPL-3.0-or-later
// What the files of the standard library say about themselves: the comment at their begin, the
// macros that they define, and what is said of each. For --help, the manual and editors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

struct LibraryMacro {
    std::string name;
    std::string form;  ///< Light_Ring(Lamp, Count, Radius)
    std::string help;  ///< may be empty
    /// For scenes, and not an aid of other macros: named in the comment at the file's begin, or, if
    /// that names none, not beginning with the file's name.
    bool listed = false;
};

struct LibraryFile {
    std::string name;   ///< light_arrays.inc
    std::string about;  ///< the first paragraph of its comment
    std::vector<LibraryMacro> macros;
};

using LibraryGuide = std::vector<LibraryFile>;

/// The include files of a folder, by name in order; none when there is no such folder.
LibraryGuide library_guide(const std::string& folder);

/// One of them by its text. Macros whose names end in `_` are its own affair and left out.
LibraryFile library_file(std::string name, std::string_view text);

/// The macro with that name, or null.
const LibraryMacro* find_macro(const LibraryFile&, std::string_view name);

/// Whether a name that the file declares is for scenes. Aids of the library are not: names that end
/// in `_`, and macros that are not listed.
bool is_for_scenes(const LibraryFile&, std::string_view name, bool is_macro);

}  // namespace candelabra
