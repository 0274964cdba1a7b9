// SPDX-License-Identifier: GPL-3.0-or-later
// INI files: lines with a keyword or several switches, in sections, with comments. Does not access
// files.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// A line of an INI file as an argument of the command line: "Width=640".
struct IniLine {
    int number = 0;  ///< counted from 1
    std::string option;
};

/// Returns the text without the quotes around the whole of it, if there are any.
std::string_view unquoted(std::string_view);

/// Returns the lines before the first `[Section]`, then those of the named section; "" means none.
/// Names of sections ignore case. `;` begins a comment. Quotes around a value are removed. Returns
/// nothing if there is no such section.
std::optional<std::vector<IniLine>> ini_lines(std::string_view text, std::string_view section);

/// Returns the line that holds the option, quoted if necessary. An option with both kinds of quotes
/// and a `;`, or quotes at the ends of its value, cannot be quoted and is returned as it is.
std::string ini_line(const std::string& option);

/// "scene.ini[Part]": file and section.
struct IniName {
    std::string file;
    std::string section;
};

/// Returns nothing if the argument does not have the extension of an INI file.
std::optional<IniName> ini_name(std::string_view argument);

}  // namespace candelabra
