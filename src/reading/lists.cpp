// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/lists.h"

#include "reading/item_reader.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace candelabra {

namespace {

class ListReader : public SimpleReader {
public:
    ListReader(OpenBlock& block, FieldType type) : block_(block), type_(type) {}

    bool wants() const { return true; }

    bool take(const Element& element) {
        if (element.kind != Element::Kind::value) return false;
        if (element.value.broken())
            block_.broken = true;
        else if (element.value.is(Absence::nothing))
            return true;
        else if (!count_)
            take_count(element);
        else if (type_ == FieldType::faces)
            take_face(element);
        else
            take_vector(element);
        return true;
    }

    /// Takes the leading literal numbers and vectors, which make up a long list, directly from the
    /// syntax tree; returns the rest of the body.
    Body take_plain(Body body) {
        const Tree& tree = *body.tree;
        if (const auto* count = tree.get_if<node::Number>(body.first)) {
            const double wanted = tree.numbers[count->number];
            if (!(wanted >= 0 && wanted < 1e9 && std::floor(wanted) == wanted)) return body;
            count_ = wanted;
            count_span_ = tree.span(body.first);
            body.first = tree[body.first].next;
            ++block_.taken;
            reserve(std::min(static_cast<std::size_t>(wanted), tree.nodes.size()));
            while (body.first != no_node && take_literal(tree, body.first))
                body.first = tree[body.first].next;
        }
        return body;
    }

    void finish() {
        if (block_.broken) return;
        const std::size_t found = type_ == FieldType::faces    ? faces.size()
                                  : type_ == FieldType::points ? points.size()
                                                               : vectors.size();
        if (!count_)
            block_.report(
                error(Fault::missing, block_.span, message(block_.quoted(), " needs a count"))
                    .with_help(block_.help()));
        else if (*count_ != static_cast<double>(found))
            block_.report(
                error(Fault::wrong_count, block_.span,
                      message(block_.quoted(), " has ", found, found == 1 ? " entry" : " entries",
                              ", but its count is ", *count_))
                    .pointing(count_span_, message("the count is ", *count_)));
    }

    std::vector<Vec3> vectors;
    std::vector<Vec2> points;
    std::vector<Face> faces;
    std::vector<Face> looks;  ///< textures of the first faces

private:
    void reserve(std::size_t count) {
        if (type_ == FieldType::faces)
            faces.reserve(count);
        else
            vectors.reserve(count);
    }

    /// Takes a literal vector of three valid numbers; returns false for any other node.
    bool take_literal(const Tree& tree, NodeId id) {
        const auto* literal = tree.get_if<node::Literal>(id);
        if (!literal || literal->count != 3) return false;
        const double* at = &tree.numbers[literal->first_number];
        const Vec3 v(at[0], at[1], at[2]);
        const double most =
            type_ == FieldType::faces ? 2147483647.0 : std::numeric_limits<double>::max();
        if (!(max_abs_component(v) <= most)) return false;
        if (type_ != FieldType::faces)
            vectors.push_back(v);
        else if (glm::floor(v) == v)
            faces.push_back({static_cast<int>(v.x), static_cast<int>(v.y), static_cast<int>(v.z)});
        else
            return false;
        ++block_.taken;
        return true;
    }

    std::optional<FieldValue> converted_as(const Element& element, FieldType type,
                                           std::string_view what) {
        return converted(
            block_, element, type,
            {[&] { return message(what, block_.quoted()); }, [&] { return block_.help(); }});
    }

    void take_count(const Element& element) {
        count_ = 0;
        const auto value = converted_as(element, FieldType::integer, "the count of ");
        if (value) count_ = std::get<double>(*value);
        count_span_ = element.span;
    }

    void take_vector(const Element& element) {
        if (type_ == FieldType::points) {
            const auto value = converted_as(element, FieldType::vector2, "an entry of ");
            if (value) points.push_back(std::get<Vec2>(*value));
            return;
        }
        const auto value = converted_as(element, FieldType::vector3, "an entry of ");
        if (value) vectors.push_back(std::get<Vec3>(*value));
    }

    void take_face(const Element& element) {
        if (element.value.numbers() && element.value.numbers()->is_scalar()) {
            take_look(element);
            return;
        }
        const auto value = converted_as(element, FieldType::vector3, "an entry of ");
        if (!value) return;
        const Vec3& v = std::get<Vec3>(*value);
        if (max_abs_component(v) > 2147483647.0) {
            block_.report(error(Fault::bad_index, element.span,
                                message("an entry of ", block_.quoted(), " is beyond all indices"))
                              .with_help(block_.help()));
            return;
        }
        if (glm::floor(v) != v) warn_of_fraction(element.span);
        faces.push_back({static_cast<int>(v.x), static_cast<int>(v.y), static_cast<int>(v.z)});
    }

    /// Warns once: other entries of the list are likely to be the same.
    void warn_of_fraction(Span span) {
        if (warned_) return;
        warned_ = true;
        block_.report(warning(
            Fault::no_effect, span,
            message("an entry of ", block_.quoted(),
                    " is three whole numbers; what is behind their points does not count")));
    }

    /// Takes a texture number of the last face: one for the whole face, or one per corner.
    void take_look(const Element& element) {
        const auto value = converted_as(element, FieldType::integer, "the texture of a face in ");
        if (!value) return;
        if (faces.empty() || (looks.size() == faces.size() && looks_given_ == 3)) {
            block_.report(error(Fault::wrong_count, element.span,
                                message("a face in ", block_.quoted(),
                                        " has one texture, or three for its corners"))
                              .with_help(block_.help()));
            return;
        }
        const int look = static_cast<int>(std::get<double>(*value));
        if (look < 0)
            return block_.report(error(Fault::out_of_range, element.span,
                                       message("the textures of a `texture_list` are counted from "
                                               "0, but this is ",
                                               look)));
        if (looks.size() < faces.size()) {
            looks.resize(faces.size(), {-1, -1, -1});
            looks.back() = {look, look, look};
            looks_given_ = 1;
            return;
        }
        for (std::size_t i = looks_given_++; i < 3; ++i) looks.back()[i] = look;
    }

    OpenBlock& block_;
    FieldType type_;
    std::size_t looks_given_ = 0;
    std::optional<double> count_;
    Span count_span_;
    bool warned_ = false;
};

}  // namespace

std::optional<CountedList> read_counted_list(OpenBlock& block, Body body, FieldType type) {
    ListReader reader(block, type);
    block.read(reader.take_plain(body), reader);
    if (block.broken) return std::nullopt;
    if (type == FieldType::points) return CountedList{std::move(reader.points), {}};
    if (type != FieldType::faces) return CountedList{std::move(reader.vectors), {}};
    if (!reader.looks.empty()) reader.looks.resize(reader.faces.size(), {-1, -1, -1});
    return CountedList{std::move(reader.faces), std::move(reader.looks)};
}

}  // namespace candelabra
