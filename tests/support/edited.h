// SPDX-License-Identifier: GPL-3.0-or-later
// A folder with files, and an editor that has one of them open with its cursor somewhere.
#pragma once

#include "editor/workspace.h"
#include "support/folder.h"

#include <string>
#include <string_view>

namespace candelabra {

struct Edited {
    Folder folder;
    Workspace workspace{CANDELABRA_SOURCE_DIR "/stdlib"};
    std::string path = folder / "a.pov";
    std::uint32_t offset = 0;

    Edited() = default;
    explicit Edited(std::string_view text) { open(text); }

    /// The sign | is where the cursor is.
    void open(std::string_view text) {
        const std::string_view before = text.substr(0, text.find('|'));
        const bool marked = before.size() < text.size();
        offset = marked ? static_cast<std::uint32_t>(before.size()) : 0;
        workspace.open(
            path, std::string(before) + std::string(text.substr(before.size() + (marked ? 1 : 0))));
    }
};

}  // namespace candelabra
