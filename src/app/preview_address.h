// SPDX-License-Identifier: GPL-3.0-or-later
// The address at which a preview is seen.
#pragma once

#include "options/options.h"
#include "text/diagnostic.h"

#include <string>

namespace candelabra {

/// The address of this machine on which a preview is served.
std::string host_of(const Options&);

/// Why a port of a host cannot be had.
Diagnostic problem_with_address(const std::string& host, int port);

/// What the user is told of a server that listens: lines with its address.
std::string words_on_address(const std::string& host, int port, const std::string& token);

}  // namespace candelabra
