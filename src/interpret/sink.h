// SPDX-License-Identifier: GPL-3.0-or-later
// The destination of a list's elements during a walk: a callback; or one value, where one is
// expected; or a callback for unevaluated nodes, all but directives. Internal to the evaluator.
#pragma once

#include "interpret/evaluator.h"

#include <optional>
#include <utility>

namespace candelabra {

/// Collects the value of a list, where one value is expected.
struct OneValue {
    /// They make the value of a block.
    const ElementHandlers& handlers;
    Value value = Absence::nothing;     ///< the first element, if it is a value
    std::optional<Element> first = {};  ///< the first element, if it is not a value
    std::size_t count = 0;
    bool broken = false;    ///< an element has been reported
    bool of_block = false;  ///< all elements are blocks, which have made the value so far

    void add(Value&& next) {
        broken = broken || next.broken();
        if (count++ == 0) value = std::move(next);
        of_block = false;
    }
    /// Makes the value at once, while the names of its macro are bound.
    void add_block(const Element& element) {
        Value made = handlers.value({&element, 1});
        const bool first_one = count == 0;
        if (of_block && handlers.layered && !broken && !made.broken()) {
            Value both = handlers.layered(value, made, element.word_span);
            if (!both.is(Absence::nothing)) {
                broken = both.broken();
                value = std::move(both);
                return;
            }
        }
        add(std::move(made));
        of_block = first_one;
    }
    void operator()(const Element& element) {
        if (element.kind == Element::Kind::value) return add(Value(element.value));
        if (element.kind == Element::Kind::block) return add_block(element);
        of_block = false;
        if (count++ == 0) first = element;
    }
};

class Sink {
public:
    Sink(Evaluator::Take take) : take_(take) {}
    template <class F>
    requires(!std::is_same_v<std::remove_cvref_t<F>, Sink> &&
             !std::is_same_v<std::remove_cvref_t<F>, OneValue> &&
             std::is_invocable_v<F&, const Element&>) Sink(F&& take)
        : take_(take) {}
    explicit Sink(OneValue& one) : take_(one), one_(&one) {}
    /// Takes unevaluated nodes. They must be used at once, while their names are bound.
    using Written = FunctionRef<void(const Tree&, NodeId)>;
    explicit Sink(const Written& written) : take_(nowhere), written_(&written) {}
    /// Takes the content of a block, where words may stand before values.
    static Sink of_block(Evaluator::Take take) {
        Sink sink(take);
        sink.of_block_ = true;
        return sink;
    }

    bool is_of_block() const { return of_block_; }

    /// The callback for unevaluated nodes, or null.
    const Written* written() const { return written_; }

    void operator()(const Element& element) const { take_(element); }
    /// Passes on the value of a node.
    void value(Value&& value, const Tree& tree, NodeId id) const {
        if (one_) return one_->add(std::move(value));
        take_(value_element(std::move(value), tree, id));
    }

    static Element value_element(Value&& value, const Tree& tree, NodeId id) {
        Element element;
        element.kind = Element::Kind::value;
        element.value = std::move(value);
        element.origin = {&tree, id};
        element.span = element.word_span = tree.span(id);
        return element;
    }

private:
    static constexpr auto nowhere = [](const Element&) {};

    Evaluator::Take take_;
    bool of_block_ = false;
    OneValue* one_ = nullptr;
    const Written* written_ = nullptr;
};

}  // namespace candelabra
