// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/read_files.h"

#include "text/sha256.h"

#include <algorithm>

namespace candelabra {

Reader noting(Reader reader, std::vector<ReadFile>& files) {
    const auto read = [reader, &files](const std::string& path) {
        std::optional<std::string> text = reader(path);
        if (!text) return text;
        ReadFile file{path, sha256(*text)};
        if (std::ranges::find(files, file) == files.end()) files.push_back(std::move(file));
        return text;
    };
    return {read, [reader](const std::string& path) { return reader.holds(path); }};
}

}  // namespace candelabra
