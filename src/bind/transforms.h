// SPDX-License-Identifier: GPL-3.0-or-later
// translate, rotate, scale, matrix and transform, wherever they may stand: each is applied the
// moment it is complete, in the order of the text. Called by the readers of objects, pigments,
// textures, cameras and lights.
#pragma once

#include "base/transform.h"
#include "bind/bind.h"

namespace candelabra {

/// The movements that take one vector.
struct Moves {
    Vec3 translate = Vec3(0);
    Vec3 rotate = Vec3(0);
    Vec3 scale = Vec3(1);

    static const ItemInfo vocabulary;
};

/// One movement, complete.
struct Movement {
    const Transform& transform;
    Handle<Transform> kept = {};                 ///< the same, when it is known from before
    std::optional<std::uint64_t> constant = {};  ///< its number among the constant movements

    operator const Transform&() const { return transform; }
};

class TransformReader {
public:
    /// Takes a Movement, or the Transform that it is.
    using Apply = FunctionRef<void(const Movement&)>;

    /// What `apply` refers to outlives the reader.
    TransformReader(OpenBlock&, Apply);
    TransformReader(const TransformReader&) = delete;

    bool waiting() const { return awaited_ != Awaited::nothing || moves_.waiting(); }
    bool wants() const { return waiting(); }
    bool take(const Element&);
    void finish() {
        give_up();
        moves_.finish();
    }
    void add_words(WordList&) const;

private:
    enum class Awaited : std::uint8_t { nothing, matrix, transform };

    bool take_awaited(const Element&);
    void apply_matrix(Span);
    void apply_move(const Element& value);
    Transform move();
    void give_up();

    OpenBlock& block_;
    Apply apply_;
    Moves moved_;
    ItemReader moves_;
    Awaited awaited_ = Awaited::nothing;
    Span word_span_;
    std::array<double, 12> matrix_;
    std::size_t count_ = 0;  ///< of the numbers of the matrix that have come
};

/// `transform { ... }`; nothing after a report.
std::optional<Transform> read_transform(Binder&, const Element& block);

}  // namespace candelabra
