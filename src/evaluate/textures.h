// SPDX-License-Identifier: GPL-3.0-or-later
// texture, pigment, finish, color_map and interior blocks. Each starts from what is there before:
// the default texture, or what the object has already. Called by the readers of objects, of
// #declare and of #default.
#pragma once

#include "evaluate/bind.h"
#include "scene/scene.h"

/// A texture that is being written: shared with where it comes from until something changes.
class TextureDraft {
public:
    explicit TextureDraft(Handle<Texture> base) : base_(std::move(base)) {}

    const Texture& now() const { return edited_ ? *edited_ : *base_; }
    Texture& edit() {
        if (!edited_) edited_ = *base_;
        return *edited_;
    }
    void replace(Handle<Texture> base) {
        base_ = std::move(base);
        edited_.reset();
    }
    /// Plain colours look the same wherever they are moved to.
    void move(const Transform& transform) {
        if (now().pigment.pattern) edit() = transformed(now(), transform);
    }
    Handle<Texture> shared(TextureStore& store) const {
        return edited_ ? store.share(*edited_) : base_;
    }

private:
    Handle<Texture> base_;
    std::optional<Texture> edited_;
};

/// All change the last argument to what the block makes of it. False: the block was wrong, and has
/// been reported.
bool read_texture(Binder&, const Element& block, TextureDraft&);
bool read_pigment(Binder&, const Element& block, Pigment&);
bool read_finish(Binder&, const Element& block, Finish&);
bool read_colour_map(Binder&, const Element& block, ColourMap&);
bool read_interior(Binder&, const Element& block, Interior&);

/// Puts a texture over another. Layers are not available, so it has to hide what is below; false
/// after a report.
bool cover(OpenBlock&, Span, TextureDraft& below, Handle<Texture> above);
