// SPDX-License-Identifier: GPL-3.0-or-later
// Names of the standard library that look only like those of POV-Ray's include files. Where these
// are installed, a scene that uses such a name can have them.
#pragma once

#include "text/diagnostic.h"
#include "text/source.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// What begins a line of an include file with such names.
inline constexpr std::string_view alike_mark = "// Only alike to POV-Ray's: ";

/// Returns the names that lines `// Only alike to POV-Ray's: Water, T_Wood1 to T_Wood35` of an
/// include file list; a range counts its last digits.
std::vector<std::string> only_alike(std::string_view text);

/// Warns of the first such name that a file outside of the standard library mentions.
/// `in_library`: whether a path lies in the standard library; `povray`: the folder of POV-Ray's
/// include files, which counts only for the files that it has.
void review_lookalikes(const SourceStore&,
                       const std::function<bool(std::string_view path)>& in_library,
                       const std::string& povray, Diagnostics&);

}  // namespace candelabra
