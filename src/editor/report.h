// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with the scenes that are being edited: they are evaluated as they will be rendered,
// by the same code and with the same messages.
#pragma once

#include "editor/workspace.h"
#include "text/source.h"

#include <string>

namespace candelabra {

struct Report {
    SourceStore sources;
    Diagnostics diagnostics;
};

/// Of an open file. What is included rather than rendered (`.inc`) is parsed only. Files that the
/// scene writes go below the folder, which is given; evaluation ends after some seconds' work.
void report(const Workspace&, const std::string& path, const std::string& folder_for_writing,
            Report&);

}  // namespace candelabra
