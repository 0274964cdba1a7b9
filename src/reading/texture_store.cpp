// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/texture_store.h"

#include <bit>
#include <cstdint>

namespace candelabra {

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

/// Whether two textures without patterns are equal.
bool equal_plain(const Texture& a, const Texture& b) {
    return a.pigment.colour == b.pigment.colour && a.pigment.quick == b.pigment.quick &&
           a.finish == b.finish && a.pigment.transform == b.pigment.transform;
}

}  // namespace

Handle<Texture> TextureStore::share(Handle<Texture> texture) {
    if (!texture->plain() || !pays()) return texture;
    make_room();
    Slot& place = slot(*texture);
    if (!place.texture) {
        place.texture = std::move(texture);
        ++count_;
    }
    return place.texture;
}

Handle<Texture> TextureStore::share(Texture texture, Pool<Texture>& pool) {
    if (!pays()) return pool.make(std::move(texture));
    make_room();
    Slot& place = slot(texture);
    if (!place.texture) {
        place.texture = pool.make(std::move(texture));
        ++count_;
    }
    return place.texture;
}

/// The slot of an equal texture, or the free slot for the texture.
TextureStore::Slot& TextureStore::slot(const Texture& texture) {
    ++asked_;
    const std::uint64_t hash = hash_of(texture);
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = hash & mask;
    while (slots_[i].texture &&
           (slots_[i].hash != hash || !equal_plain(*slots_[i].texture, texture)))
        i = (i + 1) & mask;
    slots_[i].hash = hash;
    return slots_[i];
}

/// A free slot for a texture that is not in the table.
TextureStore::Slot& TextureStore::free_slot(std::uint64_t hash) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = hash & mask;
    while (slots_[i].texture) i = (i + 1) & mask;
    return slots_[i];
}

void TextureStore::make_room() {
    if (2 * (count_ + 1) <= slots_.size()) return;
    std::vector<Slot> old(slots_.empty() ? 64 : 2 * slots_.size());
    old.swap(slots_);
    for (Slot& each : old)
        if (each.texture) free_slot(each.hash) = std::move(each);
}

}  // namespace candelabra
