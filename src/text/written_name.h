// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which names of files a stranger may choose for what is written: not those that other programs, or
// the next run of this one, believe. Asked by FileAccess for scenes, and for INI files that come with
// a scene.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// The absolute path without links and `..`; nothing if that cannot be told, or a link in it leads
/// to nothing.
std::optional<std::filesystem::path> path_without_links(const std::string& path);

/// The part of such a path below such a folder; nothing if it lies elsewhere.
std::optional<std::filesystem::path> part_below(const std::string& folder,
                                                const std::filesystem::path& path);

/// The rule that forbids to write a file of this path below a folder, in one line; empty if none
/// does. File systems that take letters for others, or drop what a name ends in, are thought of.
std::string forbidden_name(const std::filesystem::path& part);

/// Whether it is the name of an INI file, or of a scene or a part of one, in any case of letters.
bool names_settings(std::string_view name);
bool names_source(std::string_view name);

}  // namespace candelabra
