// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/texture_store.h"

#include <bit>
#include <cstdint>

namespace {

std::uint64_t hash_of(const Texture& texture) {
    std::uint64_t hash = 0;
    const auto add = [&](double x) {
        hash = (std::rotl(hash, 23) ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15u;
    };
    for (int i = 0; i < 3; ++i) {
        add(texture.pigment.colour.rgb[i]);
        add(texture.finish.emission[i]);
    }
    add(texture.pigment.colour.filter);
    add(texture.pigment.colour.transmit);
    add(texture.finish.diffuse);
    return hash ^ hash >> 32;
}

/// Neither has a pattern.
bool equal_plain(const Texture& a, const Texture& b) {
    return a.pigment.colour == b.pigment.colour && a.finish == b.finish &&
           a.pigment.transform == b.pigment.transform;
}

}  // namespace

Handle<Texture> TextureStore::share(Handle<Texture> texture) {
    if (!texture->plain()) return texture;
    if (2 * (count_ + 1) > slots_.size()) grow();
    Handle<Texture>& place = slot(*texture);
    if (!place) {
        place = std::move(texture);
        ++count_;
    }
    return place;
}

/// Where an equal texture is, or may be put.
Handle<Texture>& TextureStore::slot(const Texture& texture) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = hash_of(texture) & mask;
    while (slots_[i] && !equal_plain(*slots_[i], texture)) i = (i + 1) & mask;
    return slots_[i];
}

void TextureStore::grow() {
    std::vector<Handle<Texture>> old(slots_.empty() ? 64 : 2 * slots_.size());
    old.swap(slots_);
    for (Handle<Texture>& texture : old) {
        if (!texture) continue;
        Handle<Texture>& place = slot(*texture);
        place = std::move(texture);
    }
}
