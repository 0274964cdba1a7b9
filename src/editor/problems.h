// SPDX-License-Identifier: GPL-3.0-or-later
// Diagnostics as the Language Server Protocol has them.
#pragma once

#include "editor/protocol.h"
#include "editor/report.h"

#include <map>
#include <string>
#include <vector>

namespace candelabra {

/// By path of the file that shows them. A problem in a file that is not open is shown where an open
/// one leads there: at a macro's call or an #include, or else at the top of the scene.
std::map<std::string, std::vector<Json>> problems(const Report&, const Workspace&,
                                                  const std::string& scene);

}  // namespace candelabra
