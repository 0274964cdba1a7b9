// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/texture_store.h"

#include <functional>

namespace {

std::size_t hash_of(const Texture& texture) {
    std::size_t hash = 0;
    const auto add = [&](double x) {
        hash = (hash ^ std::hash<double>{}(x)) * 0x9E3779B97F4A7C15u;
    };
    for (int i = 0; i < 3; ++i) {
        add(texture.pigment.colour.rgb[i]);
        add(texture.finish.emission[i]);
        add(texture.finish.ambient[i]);
    }
    add(texture.finish.diffuse);
    return hash;
}

/// Neither has a pattern.
bool equal_plain(const Texture& a, const Texture& b) {
    return a.pigment.colour == b.pigment.colour && a.finish == b.finish &&
           a.pigment.transform == b.pigment.transform;
}

}  // namespace

Handle<Texture> TextureStore::share(Texture texture) {
    if (texture.pigment.pattern || !texture.pigment.map.empty())
        return make_handle<Texture>(std::move(texture));
    const std::size_t hash = hash_of(texture);
    const auto [first, last] = plain_.equal_range(hash);
    for (auto it = first; it != last; ++it)
        if (equal_plain(*it->second, texture)) return it->second;
    return plain_.emplace(hash, make_handle<Texture>(std::move(texture)))->second;
}
