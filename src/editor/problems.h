// SPDX-License-Identifier: GPL-3.0-or-later
// Converts diagnostics to the form of the Language Server Protocol.
#pragma once

#include "editor/protocol.h"
#include "editor/report.h"

#include <map>
#include <string>
#include <vector>

namespace candelabra {

/// Returns problems by the path of the file that shows them. A problem in a file that is not open
/// is shown where an open file leads to it: at a macro call or an #include, or else at the top of
/// the scene.
std::map<std::string, std::vector<Json>> problems(const Report&, const Workspace&,
                                                  const std::string& scene);

}  // namespace candelabra
