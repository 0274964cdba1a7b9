// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The files that a scene has made: of existing files, it may write only to these. Each bears a mark
// of its scene, so that the next run recognises it, too; on file systems without such attributes,
// only the files of this run are known. Files whose names end in .tmp are temporary and shared by
// all scenes: several scenes parse strings through one such file. One object serves all pictures of
// a run; it is thread-safe.

#include "text/opened_file.h"

#include <cstdint>
#include <mutex>
#include <set>
#include <string>
#include <utility>

namespace candelabra {

class MadeFiles {
public:
    /// `scene`: the path of the run's scene, with or without .pov. If there is no such file, its
    /// next run does not recognise the files that it made.
    explicit MadeFiles(const std::string& scene);

    /// Opens a file that the scene writes: a new one, or an existing one that may be written to,
    /// which is emptied unless the scene appends. `any` also permits files that others have made.
    /// The result is not open if the file must not be, or cannot be, written.
    OpenedFile open(const std::string& path, bool append, bool any);

    /// Whether open() would accept the existing file, if any. Never opens files made by others.
    bool may_write(const std::string& path, bool any) const;

    /// Whether the file at the absolute path without links bears the mark of another scene. Never
    /// opens it.
    bool made_by_another(const std::string& path) const;

private:
    bool has(const OpenedFile&, const std::string& path) const;
    void add(const OpenedFile&);

    std::string mark_;
    mutable std::mutex mutex_;
    std::set<std::pair<std::uint64_t, std::uint64_t>> files_;  ///< by device and inode number
};

}  // namespace candelabra
