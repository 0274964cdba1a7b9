// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which files a scene has made: it may write to them again, and to no others that are there. A file
// bears a mark of the scene that has made it, so that the next run knows it, too; where the file
// system keeps no marks, the files of this run are known. What ends in .tmp is for the moment, and
// belongs to all scenes: several parse strings by one such file. One for all pictures of a run;
// safe for several threads.

#include "text/opened_file.h"

#include <cstdint>
#include <mutex>
#include <set>
#include <string>
#include <utility>

namespace candelabra {

class MadeFiles {
public:
    /// `scene`: the path of the scene that the run is of, perhaps without its .pov; where there is
    /// no such file, its next run does not know what it has made.
    explicit MadeFiles(const std::string& scene);

    /// Opens a file that the scene writes: one that was not there, or one that is there and may be
    /// written to; it is emptied unless the scene appends. `any`: also one that others have made.
    /// Not open when it must not be, or cannot be, written.
    OpenedFile open(const std::string& path, bool append, bool any);

    /// Whether open() would not refuse what is there. Opens nothing that others have made.
    bool may_write(const std::string& path, bool any) const;

private:
    bool has(const OpenedFile&, const std::string& path) const;
    void add(const OpenedFile&);

    std::string mark_;
    mutable std::mutex mutex_;
    std::set<std::pair<std::uint64_t, std::uint64_t>> files_;  ///< by device and number
};

}  // namespace candelabra
