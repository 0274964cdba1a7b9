// SPDX-License-Identifier: GPL-3.0-or-later
// Diagnoses the scenes that are being edited: they are evaluated as for rendering, by the same code
// and with the same messages.
#pragma once

#include "editor/workspace.h"
#include "text/source.h"

#include <string>

namespace candelabra {

struct Report {
    SourceStore sources;
    Diagnostics diagnostics;
};

/// Diagnoses an open file. Include files (`.inc`) are only parsed. Files that the scene writes go
/// below the given folder. Evaluation stops after a few seconds' work.
void report(const Workspace&, const std::string& path, const std::string& folder_for_writing,
            Report&);

}  // namespace candelabra
