// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/picture_layers.h"

#include "text/ascii.h"
#include "text/message.h"

#include <algorithm>
#include <array>

namespace candelabra {

namespace {

constexpr auto infos = std::to_array<LayerInfo>({
    {PictureLayer::albedo, "albedo", "colours of the first surface without light"},
    {PictureLayer::normal, "normal", "its direction towards the viewer, as it is shaded"},
    {PictureLayer::depth, "depth",
     "distance of what the middle of the pixel shows; infinite: nothing"},
    {PictureLayer::object, "object",
     "number of its object in the order of the scene, from 1; 0: none"},
    {PictureLayer::lights, "lights",
     "light.NAME for each statement that makes lights, and light.rest: together the picture"},
    {PictureLayer::variance, "variance",
     "of the pixel as a display shows it, 0 to 1; the greatest of the channels"},
    {PictureLayer::samples, "samples", "how many rays of the camera went through the pixel"},
    {PictureLayer::shadow_rays, "shadow_rays", "how many rays they sent towards lights"},
    {PictureLayer::luminance, "luminance", "of the picture in candela per square metre"},
    {PictureLayer::illuminance, "illuminance",
     "of the first surface in lux, on the side that is seen; takes about as long as the picture"},
});

}  // namespace

std::span<const LayerInfo> all_layers() { return infos; }

std::optional<std::vector<PictureLayer>> read_layer_list(std::string_view text) {
    std::array<bool, infos.size()> wanted{};
    while (!text.empty()) {
        const std::string_view name = take_until(text, ",");
        const auto found = std::ranges::find(infos, name, &LayerInfo::name);
        if (name == "all")
            wanted.fill(true);
        else if (found == infos.end())
            return std::nullopt;
        else
            wanted[static_cast<std::size_t>(found - infos.begin())] = true;
    }
    std::vector<PictureLayer> layers;
    for (const LayerInfo& info : infos)
        if (wanted[static_cast<std::size_t>(info.layer)]) layers.push_back(info.layer);
    return layers;
}

std::string layer_list(std::span<const PictureLayer> layers) {
    std::string text;
    for (const PictureLayer layer : layers)
        text += message(text.empty() ? "" : ",", infos[static_cast<std::size_t>(layer)].name);
    return text;
}

}  // namespace candelabra
