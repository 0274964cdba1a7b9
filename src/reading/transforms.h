// SPDX-License-Identifier: GPL-3.0-or-later
// Reads translate, rotate, scale, matrix and transform in any block. Each is applied as soon as it
// is complete, in the order of the text. Called by the readers of objects, pigments, textures,
// cameras and lights.
#pragma once

#include "base/transform.h"
#include "reading/item_reader.h"

namespace candelabra {

/// The transformations that take one vector.
struct Moves {
    Vec3 translate = Vec3(0);
    Vec3 rotate = Vec3(0);
    Vec3 scale = Vec3(1);

    static const ItemInfo vocabulary;
};

/// One complete transformation.
struct Movement {
    const Transform& transform;
    Handle<Transform> kept = {};                 ///< the same transformation, if it is cached
    std::optional<std::uint64_t> constant = {};  ///< its number among constant movements

    operator const Transform&() const { return transform; }
};

class TransformReader {
public:
    /// Takes a Movement, or the Transform in it.
    using Apply = FunctionRef<void(const Movement&)>;

    /// The target of `apply` outlives the reader.
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
    static constexpr std::size_t matrix_numbers = 12;
    std::array<double, 2 * matrix_numbers> matrix_;
    std::size_t count_ = 0;  ///< number of matrix elements read so far
};

/// Reads `transform { ... }`; returns nothing after a diagnostic.
std::optional<Transform> read_transform(Binder&, const Element& block);

}  // namespace candelabra
