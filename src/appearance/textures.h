// SPDX-License-Identifier: GPL-3.0-or-later
// Reads texture, texture_map, material, pigment and pigment_map blocks. Each starts from the
// default texture or from the object's current one. Called by the readers of objects, of #declare
// and of #default.
#pragma once

#include "appearance/finishes.h"
#include "reading/item_reader.h"
#include "scene/scene.h"
#include "surface/texture_map.h"

namespace candelabra {

/// A texture under construction; shared with its origin until it changes.
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
    /// Whether a transformation changes the texture; plain colours are the same everywhere.
    bool movable() const { return !now().plain(); }
    void move(const Transform& transform) {
        if (movable()) edit() = transformed(now(), transform);
    }
    /// The current texture, merged with an equal one in the store.
    const Handle<Texture>& shared(TextureStore& store) {
        if (std::exchange(edited_, false)) texture_ = store.share(std::move(texture_));
        return texture_;
    }

private:
    Handle<Texture> texture_;
    bool edited_ = false;
};

/// These functions apply the block to the last argument. They return false, after a diagnostic, if
/// the block was wrong.
bool read_texture(Binder&, const Element& block, TextureDraft&);
bool read_pigment(Binder&, const Element& block, Pigment&);
/// Reads `density { ... }` of a medium as a pigment whose filter and transmit have no effect.
bool read_density(Binder&, const Element& block, Pigment&);
/// Reads a pigment's words that stand directly in a texture, as before version 3.0; the span is
/// that of `texture`.
bool read_legacy_pigment(Binder&, const ElementList&, Span, Pigment&);
/// Also reads `density_map`.
bool read_pigment_map(Binder&, const Element& block, PigmentMap&);

bool read_texture_map(Binder&, const Element& block, TextureMap&);

/// Applies the block to the default texture; returns null, after a diagnostic, if it was wrong.
Handle<Texture> read_whole_texture(Binder&, const Element& block);

/// Reads consecutive texture blocks as layers, the last on top. Returns null after a diagnostic.
Handle<Texture> read_layers(Binder&, std::span<const Element> blocks);

/// Layers a texture over another. Returns the upper one alone, after a diagnostic, if there are too
/// many layers or if a pattern chooses the lower one.
Handle<Texture> layered(OpenBlock&, Span, const Handle<Texture>& below, Handle<Texture> above);

}  // namespace candelabra
