// SPDX-License-Identifier: GPL-3.0-or-later
// Converts many places in several files to ranges, counting the lines of each file only once.
#pragma once

#include "editor/protocol.h"
#include "editor/workspace.h"

#include <map>
#include <string>
#include <utility>

namespace candelabra {

class Ranges {
public:
    explicit Ranges(Workspace& workspace) : workspace_(workspace) {}

    /// Returns the beginning for a file that no longer exists.
    Json of(const std::string& path, Part place) {
        auto known = tables_.find(path);
        if (known == tables_.end()) {
            FileHandle file = workspace_.file(path);
            const LineTable table(file ? std::string_view(file->text) : std::string_view());
            known = tables_.emplace(path, std::pair(std::move(file), table)).first;
        }
        return known->second.second.range_of(place);
    }

private:
    Workspace& workspace_;
    /// The handles keep the texts alive.
    std::map<std::string, std::pair<FileHandle, LineTable>> tables_;
};

}  // namespace candelabra
