// SPDX-License-Identifier: GPL-3.0-or-later
// INI files: options, a keyword or several switches on a line, with sections and comments. Reads no
// file itself.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// An argument of the command line: "Width=640".
struct IniLine {
    int number = 0;  ///< counted from 1
    std::string option;
};

/// The lines above the first `[Section]`, then those of the named one, in any case of letters; ""
/// means none. `;` begins a comment. Quotes around a value are taken away. Nothing when there is no
/// such section.
std::optional<std::vector<IniLine>> ini_lines(std::string_view text, std::string_view section);

/// The line that says an option, in quotes if it needs them. With quotes of both kinds beside a `;`
/// or at the ends of a value there is none: it is the option as it stands then.
std::string ini_line(const std::string& option);

/// "scene.ini[Part]": file and section.
struct IniName {
    std::string file;
    std::string section;
};

/// Nothing when the argument is no name of an INI file, by its ending.
std::optional<IniName> ini_name(std::string_view argument);

}  // namespace candelabra
