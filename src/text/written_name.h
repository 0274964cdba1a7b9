// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Restricts the names that an untrusted scene may choose for files that are written: names that
// other programs, or the next run of this one, would trust are forbidden. Called by FileAccess for
// scenes, and for INI files that come with a scene.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// Returns the absolute path without links and `..`; nothing if it cannot be determined, or if it
/// contains a dangling link.
std::optional<std::filesystem::path> path_without_links(const std::string& path);

/// Returns the part of `path` below `folder`, both as path_without_links() returns them; nothing if
/// the path is elsewhere.
std::optional<std::filesystem::path> part_below(const std::string& folder,
                                                const std::filesystem::path& path);

/// Returns the rule that forbids writing this path, relative to its writable folder, in one line;
/// empty if none does. Allows for file systems that equate characters or drop the end of a name.
std::string forbidden_name(const std::filesystem::path& part);

/// The same for a folder that the user has not named: only names of data are written there, made of
/// letters, digits, `_`, `-` and points, with an ending that no program runs or obeys.
std::string forbidden_data_name(const std::filesystem::path& part);

/// Returns the rule that forbids reading this path, relative to its readable folder; empty if none
/// does: hidden names belong to other programs, and no line of a text can tell names with control
/// characters.
std::string unread_name(const std::filesystem::path& part);

/// Whether the name is that of an INI file, or of a scene or a part of one, ignoring case.
bool names_settings(std::string_view name);
bool names_source(std::string_view name);

}  // namespace candelabra
