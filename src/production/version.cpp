// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/version.h"

namespace candelabra {

std::string_view version() { return CANDELABRA_VERSION; }

std::string_view program_name() { return "Candelabra " CANDELABRA_VERSION; }

}  // namespace candelabra
