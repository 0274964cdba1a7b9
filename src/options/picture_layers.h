// SPDX-License-Identifier: GPL-3.0-or-later
// The layers that a picture may have beside its colours, by name. Read by --layers.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

enum class PictureLayer {
    albedo,
    normal,
    depth,
    object,
    lights,
    variance,
    samples,
    shadow_rays,
    luminance,
    illuminance
};

struct LayerInfo {
    PictureLayer layer;
    std::string_view name;
    std::string_view help;
};

/// Returns all layers in the order of PictureLayer.
std::span<const LayerInfo> all_layers();

/// Parses comma-separated names, or `all`; each layer appears once. Returns nothing if a name is
/// unknown.
std::optional<std::vector<PictureLayer>> read_layer_list(std::string_view);
std::string layer_list(std::span<const PictureLayer>);

}  // namespace candelabra
