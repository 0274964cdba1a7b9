// SPDX-License-Identifier: GPL-3.0-or-later
// Documentation that the files of the standard library contain: the comment at the beginning, and
// the macros that they define, each with a description and an example behind `e.g.`. For --help,
// the manual and editors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

struct LibraryMacro {
    std::string name;
    std::string form;  ///< Light_Ring(Lamp, Count, Radius)
    std::string help;  ///< may be empty
    /// Statements that show the macro (vocabulary/examples.h), which include the file. `Bulb` is a
    /// small lamp in them, and `Stream` a stream of random numbers. May be empty.
    std::string example = {};
    std::string value = {};  ///< of the expression at the example's end, if it has one
    /// Whether the macro is for scenes, and not an aid of other macros: named in the comment at the
    /// file's beginning or, if that names none, not starting with the file's name.
    bool listed = false;
};

struct LibraryFile {
    std::string name;   ///< light_arrays.inc
    std::string about;  ///< the first paragraph of its comment
    std::vector<LibraryMacro> macros;
};

using LibraryGuide = std::vector<LibraryFile>;

/// Returns the include files of a folder, sorted by name; empty if there is no such folder.
LibraryGuide library_guide(const std::string& folder);

/// Parses the text of one file. Macros whose names end in `_` are private and left out.
LibraryFile library_file(std::string name, std::string_view text);

/// Returns the macro with that name, or null.
const LibraryMacro* find_macro(const LibraryFile&, std::string_view name);

/// Whether a name that the file declares is for scenes. Names that end in `_` or `_Temp`, and
/// macros that are not listed, are aids of the library.
bool is_for_scenes(const LibraryFile&, std::string_view name, bool is_macro);

}  // namespace candelabra
