// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra light`: what a photometric file (IES LM-63, EULUMDAT) says of its luminaire.
#pragma once

#include "console/console.h"
#include "photometry/photometric_file.h"

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

namespace candelabra {

/// `arguments`: those after `light`. Returns the exit status.
int run_light(std::span<const std::string_view> arguments, const Console&);

/// The summary for people, without the diagram.
std::string photometric_summary(const std::string& path, const PhotometricFile&);

/// The summary for programs: `flux_lm`, `max_cd`, `symmetry`, `opening_m` and so on.
nlohmann::json photometric_json(const std::string& path, const PhotometricFile&);

}  // namespace candelabra
