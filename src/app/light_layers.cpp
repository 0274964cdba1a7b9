// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/light_layers.h"

#include "picture/file.h"
#include "picture/layers.h"

#include <bit>

bool write_light_layers(const Film& film, const std::string& path, Diagnostics& diagnostics) {
    LayeredPicture picture{film.width(), film.height(), {}, {}};
    const auto add = [&](const std::string& name, const auto& value) {
        Plane plane{name, false, {}};
        for (const PixelSum& pixel : film.pixels())
            plane.bits.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(value(pixel))));
        picture.planes.push_back(std::move(plane));
    };
    for (int channel = 0; channel < 3; ++channel)
        add(std::string(1, "RGB"[channel]),
            [&](const PixelSum& pixel) { return pixel.mean()[channel]; });
    add("shadow_rays", [](const PixelSum& pixel) { return pixel.shadow_rays; });
    add("variance",
        [](const PixelSum& pixel) { return pixel.samples > 1 ? pixel.variance_of_mean() : 0.0; });
    const auto bytes = encode(picture, diagnostics);
    return bytes && write_file(path, *bytes, diagnostics);
}
