// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/pnm_writer.h"

#include <cstdint>
#include <string>
#include <vector>

namespace candelabra {

std::string write_pnm(const RawPicture& picture, std::string& bytes) {
    const auto* values = std::get_if<std::vector<std::uint8_t>>(&picture.values);
    if (!values || picture.channels % 2 == 0) return "it has bytes without alpha only";
    bytes = (picture.channels == 1 ? "P5\n" : "P6\n") + std::to_string(picture.width) + " " +
            std::to_string(picture.height) + "\n255\n";
    bytes.append(values->begin(), values->end());
    return {};
}

}  // namespace candelabra
