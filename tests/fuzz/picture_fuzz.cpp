// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a picture file of any format, and as a field of heights: no crash, and all pixels
// that are said are there.
#include "fuzz/target.h"
#include "picture/heights.h"
#include "picture/read.h"

#include <cstdlib>

using namespace candelabra;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    // Targa files are told by their names.
    const Found file{(data[0] & 1) != 0 ? "a.tga" : "a.bin",
                     {reinterpret_cast<const char*>(data) + 1, size - 1}};
    TexelCoding coding;
    coding.premultiplied = (data[0] & 2) != 0;
    Diagnostics diagnostics;
    const auto texels = read_texels(file, coding, diagnostics, {});
    const auto heights = read_heights(file, 0, diagnostics, {});
    if (texels.has_value() != heights.has_value()) std::abort();
    if (!texels) return 0;
    const auto pixels =
        static_cast<std::size_t>(texels->width) * static_cast<std::size_t>(texels->height);
    if (heights->values.size() != pixels) std::abort();
    for (const std::uint16_t number : texels->numbers)
        if (number >= texels->table.size()) std::abort();
    return 0;
}
