// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The folders from which the scene of a run reads. FileAccess and the sandbox both obey them. A
// folder that holds a home, or the whole disk, is none of them, whatever lies in it: programs are
// often run in such a folder.

#include <filesystem>
#include <string>
#include <vector>

namespace candelabra {

/// Files of one folder, but not of the folders in it.
struct FolderFiles {
    std::string folder;
    /// Only names that begin so, with no letter behind: `a.png` and `a07.png` of `a`. Empty: all.
    std::string stem = {};

    bool has(const std::string& name) const;
};

struct SceneFolders {
    std::vector<std::string> whole;  ///< with everything below them
    std::vector<FolderFiles> files;
    /// The current directory, if it would be one of them but is too wide; empty otherwise.
    std::string left_out = {};
};

/// `scene`: the folder of the scene; "" or "." is the current directory. `picture`: the path of the
/// picture; empty if there is none.
///
/// The folder of the scene is read, and the current directory and the folder of the picture if the
/// scene lies in or below them. Of another folder of the picture, only files with the picture's
/// name are read. Of folders that are too wide, only files that lie directly in them are read,
/// beside the scene and the picture; nothing is read below /proc, /sys and /dev, except /dev/shm.
SceneFolders scene_folders(const std::string& scene, const std::string& picture);

/// Whether the folder, an absolute path without links, is or holds a home, or is or lies in a
/// folder of the system's own.
bool is_wide(const std::filesystem::path& folder);

}  // namespace candelabra
