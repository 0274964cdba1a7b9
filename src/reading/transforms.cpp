// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/transforms.h"

#include "vocabulary/schema.h"

#include "text/message.h"

#include <algorithm>
#include <span>

namespace candelabra {

const ItemInfo Moves::vocabulary = described<Moves>([] {
    using F = Field<Moves>;
    return schema<Moves>(
        "transform", "Moves, turns and stretches, in the order of the text.",
        F{"translate", &Moves::translate, item, "moves along a vector"},
        F{"rotate", &Moves::rotate, item, "turns about x, then y, then z, by degrees"},
        F{"scale", &Moves::scale, item, "stretches along the axes; 0 counts as 1"});
});

namespace {

/// Reads `inverse` in a transform, which inverts the whole block once, wherever it stands.
class InverseReader : public SimpleReader {
public:
    explicit InverseReader(OpenBlock& block) : block_(block) {}

    bool take(const Element& element) {
        if (element.kind != Element::Kind::word || element.word != "inverse"_word) return false;
        inverse = true;
        return true;
    }
    void add_words(WordList& words) const { words.push_back("inverse"); }

    bool inverse = false;

private:
    OpenBlock& block_;
};

/// Reads `Name` anywhere in a transform.
class DeclaredTransforms : public SimpleReader {
public:
    explicit DeclaredTransforms(TransformReader::Apply apply) : apply_(apply) {}

    bool wants() const { return true; }
    bool take(const Element& element) {
        if (element.kind != Element::Kind::value) return false;
        const Handle<Transform> declared = element.value.handle<Transform>();
        if (declared) apply_({*declared});
        return declared != nullptr;
    }

private:
    TransformReader::Apply apply_;
};

void warn_of_flat(OpenBlock& block, const Element& value) {
    Diagnostic flat = warning(Fault::degenerate, value.span,
                              "this `scale` is 0 along an axis, which is taken as 1");
    const Numbers* numbers = value.value.numbers();
    if (numbers && numbers->count == 2) flat.with_help("a vector of 2 has 0 for its third number");
    block.report(std::move(flat));
}

}  // namespace

TransformReader::TransformReader(OpenBlock& block, Apply apply)
    : block_(block), apply_(apply), moves_(block, Moves::vocabulary, &moved_) {
    moves_.repeatable();
}

void TransformReader::add_words(WordList& words) const {
    moves_.add_words(words);
    words.push_back("matrix");
    words.push_back("transform");
}

bool TransformReader::take(const Element& element) {
    if (awaited_ != Awaited::nothing && take_awaited(element)) return true;
    if (moves_.take(element)) {
        if (moves_.stored() >= 0) apply_move(element);
        return true;
    }
    if (element.kind == Element::Kind::word) {
        if (element.word != "matrix"_word && element.word != "transform"_word) return false;
        awaited_ = element.word == "matrix"_word ? Awaited::matrix : Awaited::transform;
        word_span_ = element.span;
        count_ = 0;
        return true;
    }
    if (element.kind != Element::Kind::block || element.word != "transform"_word) return false;
    const std::optional<Transform> inner = read_transform(block_.binder, element);
    if (inner)
        apply_({*inner});
    else
        block_.broken = true;
    return true;
}

bool TransformReader::take_awaited(const Element& element) {
    if (element.kind == Element::Kind::value) {
        const Awaited awaited = awaited_;
        if (element.value.broken()) {
            block_.broken = true;
            awaited_ = Awaited::nothing;
        } else if (awaited == Awaited::matrix) {
            count_ = element.value.numbers()
                         ? static_cast<std::size_t>(element.value.numbers()->count)
                         : 0;
            give_up();
        } else if (const Handle<Transform> declared = element.value.handle<Transform>()) {
            awaited_ = Awaited::nothing;
            apply_({*declared});
        } else {
            awaited_ = Awaited::nothing;
            block_.report(
                error(Fault::wrong_type, element.span,
                      message("`transform` needs a declared transform, but this is ",
                              kind_name(element.value)))
                    .with_help(
                        "write `transform { translate ... }`, or `translate` and the like alone"));
        }
        return true;
    }
    if (element.kind == Element::Kind::list && awaited_ == Awaited::matrix) {
        count_ = element.list.size();
        if (count_ != matrix_numbers && count_ != matrix_.size()) {
            give_up();
        } else {
            std::ranges::copy(element.list, matrix_.begin());
            awaited_ = Awaited::nothing;
            apply_matrix(element.span);
        }
        return true;
    }
    const bool name = element.kind == Element::Kind::word &&
                      !block_.binder.evaluator.names().reserved(element.word);
    if (!name) give_up();
    return false;
}

void TransformReader::give_up() {
    if (awaited_ == Awaited::matrix)
        block_.report(error(Fault::wrong_count, word_span_,
                            message("`matrix` needs 12 numbers, but it has ", count_))
                          .with_help("matrix <xx, xy, xz, yx, yy, yz, zx, zy, zz, tx, ty, tz>: "
                                     "where the axes go, and the translation; those of the "
                                     "inverse may follow"));
    else if (awaited_ == Awaited::transform)
        block_.report(
            error(Fault::missing, word_span_, "`transform` needs a declared transform or a block")
                .with_help("transform { translate ... }"));
    awaited_ = Awaited::nothing;
}

namespace {

Affine map_of(std::span<const double> twelve) {
    Affine map;
    const auto row = [&](std::size_t first) {
        return Vec3(twelve[first], twelve[first + 1], twelve[first + 2]);
    };
    map.rows = {row(0), row(3), row(6)};
    map.translation = row(9);
    return map;
}

/// Whether the map is the inverse up to the rounding of a long chain of maps.
bool undoes(const Affine& back, const Transform& map) {
    constexpr double relative = 1e-6;
    const Affine exact = map.inverse().forward();
    const auto near = [](const Vec3& a, const Vec3& b, double greatest) {
        return max_abs_component(a - b) <= relative * greatest;
    };
    double greatest = 0;
    for (const Vec3& row : exact.rows) greatest = std::max(greatest, max_abs_component(row));
    for (std::size_t row = 0; row < exact.rows.size(); ++row)
        if (!near(back.rows[row], exact.rows[row], greatest)) return false;
    const double reach = std::max(max_abs_component(exact.translation),
                                  greatest * max_abs_component(map.forward().translation));
    return near(back.translation, exact.translation, reach);
}

}  // namespace

void TransformReader::apply_matrix(Span span) {
    const std::span<const double> numbers(matrix_.data(), count_);
    for (const double x : numbers)
        if (!std::isfinite(x)) {
            block_.report(error(Fault::out_of_range, span,
                                message("the numbers of `matrix` must be finite, but one is ", x)));
            return;
        }
    Affine map = map_of(numbers.first<matrix_numbers>());
    for (int axis = 0; axis < 3; ++axis) {
        if (map.rows[0][axis] != 0 || map.rows[1][axis] != 0 || map.rows[2][axis] != 0) continue;
        map.rows[static_cast<std::size_t>(axis)][axis] = 1;
        block_.report(warning(Fault::degenerate, word_span_,
                              "a column of `matrix` is all 0, so its diagonal is taken as 1"));
    }
    const double volume = determinant(map);
    if (volume == 0 || !std::isfinite(volume) || !std::isfinite(1 / volume)) {
        block_.report(
            error(Fault::degenerate, word_span_, "this `matrix` makes everything flat")
                .with_help(
                    "its first three rows are where the axes go: they must not lie in one plane"));
        return;
    }
    if (count_ == matrix_numbers) {
        apply_({Transform(map)});
        return;
    }
    const Affine back = map_of(numbers.last<matrix_numbers>());
    const Transform exact(map);
    if (undoes(back, exact)) {
        apply_({Transform(map, back)});
        return;
    }
    block_.report(warning(Fault::degenerate, word_span_,
                          "the last 12 numbers of this `matrix` are not those of its inverse, and "
                          "do not count")
                      .with_help("leave them out: the inverse follows from the first 12"));
    apply_({exact});
}

void TransformReader::apply_move(const Element& value) {
    const Vec3& factors = moved_.scale;
    const bool flat = factors.x == 0 || factors.y == 0 || factors.z == 0;
    std::optional<std::uint64_t> constant;
    if (!flat) constant = block_.binder.constants.number(value);
    if (flat) warn_of_flat(block_, value);
    if (!constant) return apply_({move()});
    // The same value may follow another word the next time, after an #if.
    constant = *constant << 2 | static_cast<unsigned>(moves_.stored());
    const Handle<Transform> known =
        block_.binder.moves.made(constant, nullptr, [&] { return make_handle<Transform>(move()); });
    apply_({*known, known, constant});
}

/// The transformation given by the last word and value.
Transform TransformReader::move() {
    if (moves_.stored() == 0) return Transform::translation(moved_.translate);
    if (moves_.stored() == 1) return Transform::rotation(moved_.rotate);
    Vec3 factors = moved_.scale;
    for (int axis = 0; axis < 3; ++axis)
        if (factors[axis] == 0) factors[axis] = 1;
    return Transform::scaling(factors);
}

std::optional<Transform> read_transform(Binder& binder, const Element& element) {
    OpenBlock block(binder, "transform", element.word_span);
    block.form = "{ translate v rotate v scale v matrix <12 numbers> [inverse] }";
    Transform result;
    const auto apply = [&](const Transform& next) { result = result.then(next); };
    TransformReader moves(block, apply);
    InverseReader inverse(block);
    DeclaredTransforms declared(apply);
    block.read(element.body, moves, inverse, declared);
    if (block.broken) return std::nullopt;
    return inverse.inverse ? result.inverse() : result;
}

}  // namespace candelabra
