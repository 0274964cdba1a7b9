// SPDX-License-Identifier: GPL-3.0-or-later
// A file as a scene finds it.
#pragma once

#include "text/loader.h"

namespace candelabra {

/// Without content if it cannot be read.
inline Found found(const std::string& path) { return {path, disk_reader()(path).value_or("")}; }

}  // namespace candelabra
