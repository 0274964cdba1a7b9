// SPDX-License-Identifier: GPL-3.0-or-later
// texture, texture_map, material, pigment and pigment_map blocks. Each starts from what is there
// before: the default texture, or what the object has already. Called by the readers of objects, of
// #declare and of #default.
#pragma once

#include "bind/bind.h"
#include "bind/finishes.h"
#include "scene/scene.h"
#include "surface/texture_map.h"

namespace candelabra {

/// A texture that is being written: shared with where it comes from until something changes.
class TextureDraft {
public:
    explicit TextureDraft(Handle<Texture> base) : texture_(std::move(base)) {}

    const Texture& now() const { return *texture_; }
    const Handle<Texture>& handle() const { return texture_; }
    Texture& edit() {
        edited_ = true;
        return texture_.edit();
    }
    void replace(Handle<Texture> base) {
        texture_ = std::move(base);
        edited_ = false;
    }
    /// Plain colours look the same wherever they are moved to.
    bool movable() const { return !now().plain(); }
    void move(const Transform& transform) {
        if (movable()) edit() = transformed(now(), transform);
    }
    /// The texture as it is now, equal ones as one.
    const Handle<Texture>& shared(TextureStore& store) {
        if (std::exchange(edited_, false)) texture_ = store.share(std::move(texture_));
        return texture_;
    }

private:
    Handle<Texture> texture_;
    bool edited_ = false;
};

/// All change the last argument to what the block makes of it. False: the block was wrong, and has
/// been reported.
bool read_texture(Binder&, const Element& block, TextureDraft&);
bool read_pigment(Binder&, const Element& block, Pigment&);
/// `density { ... }` of a medium: as a pigment, whose filter and transmit do not count.
bool read_density(Binder&, const Element& block, Pigment&);
/// The words of a pigment in a texture from before version 3.0, whose word is at the span.
bool read_legacy_pigment(Binder&, const ElementList&, Span, Pigment&);
/// The same for `density_map`.
bool read_pigment_map(Binder&, const Element& block, PigmentMap&);

bool read_texture_map(Binder&, const Element& block, TextureMap&);

/// What the block makes of the default texture; null: it was wrong, and has been reported.
Handle<Texture> read_whole_texture(Binder&, const Element& block);

/// Blocks of textures in a row: layers, the last on top. Null after a report.
Handle<Texture> read_layers(Binder&, std::span<const Element> blocks);

/// A texture over another; the one above alone, after a report, where there are too many layers or
/// the one below is chosen by a pattern.
Handle<Texture> layered(OpenBlock&, Span, const Handle<Texture>& below, Handle<Texture> above);

}  // namespace candelabra
