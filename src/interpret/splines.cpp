// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/splines.h"

#include "text/message.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candelabra {

std::optional<Spline::Kind> spline_kind(std::string_view word) {
    using Kind = Spline::Kind;
    if (word == "linear_spline") return Kind::linear;
    if (word == "quadratic_spline") return Kind::quadratic;
    if (word == "cubic_spline") return Kind::cubic;
    if (word == "natural_spline") return Kind::natural;
    return std::nullopt;
}

std::string spline_text(const Spline& spline) {
    constexpr auto words =
        std::array{"linear_spline", "quadratic_spline", "cubic_spline", "natural_spline"};
    std::string text = message("spline { ", words[static_cast<std::size_t>(spline.kind())]);
    for (const Spline::Knot& knot : spline.knots()) {
        text += message(" ", knot.t, ", ");
        const bool one = spline.components() == 1;
        for (std::size_t i = 0; i < spline.components(); ++i)
            text += message(one ? "" : i == 0 ? "<" : ", ", knot.at[i]);
        text += one ? "," : ">,";
    }
    text.pop_back();
    return text + " }";
}

Handle<Formula> spline_formula(Handle<Spline> spline) {
    const std::size_t results = spline->components();
    return make_handle<Formula>(1, results,
                                [spline, results](const double* arguments, double* found) {
                                    const Spline::Components at = spline->at(arguments[0]);
                                    std::copy_n(at.begin(), results, found);
                                    return true;
                                });
}

namespace {

/// Reads the content of a block: an optional spline to begin with, the kind, pairs of t and a
/// point.
class SplineReader {
public:
    explicit SplineReader(Evaluator& evaluator) : evaluator_(evaluator) {}

    void take(const Element& element) {
        const std::string_view word = element.kind == Element::Kind::word
                                          ? evaluator_.spelling(element.word)
                                          : std::string_view();
        if (const auto kind = spline_kind(word)) {
            kind_ = *kind;
            return;
        }
        const Value value = evaluator_.value_of(element);
        const Handle<Spline> spline = value.handle<Spline>();
        if (value.broken())
            good_ = false;
        else if (spline && points_.empty() && !t_)
            begin_with(*spline);
        else if (const Numbers* numbers = value.numbers())
            take_numbers(*numbers, element.span);
        else
            refuse(
                Fault::wrong_type, element.span,
                message("a spline consists of numbers and points, and this is ", kind_name(value)));
    }

    Value made(Span span) {
        if (good_ && t_)
            refuse(Fault::missing, t_place_, "this t has no point: spline { 0, <1, 2, 3> 1, ... }");
        if (good_ && points_.empty()) refuse(Fault::missing, span, "a spline needs points");
        if (!good_ || evaluator_.stopped()) return Absence::broken;
        constexpr std::uint64_t making = 500, each = 50;
        if (!evaluator_.spend(making + each * points_.size(), span)) return Absence::broken;
        int most = 2;
        for (const Point& point : points_) most = std::max(most, point.at.count);
        std::vector<Spline::Knot> knots;
        for (const Point& point : points_)
            Spline::insert(knots, {point.t, point.at.promoted(most).at});
        return make_handle<Spline>(std::move(knots), static_cast<std::size_t>(most), kind_);
    }

private:
    struct Point {
        double t;
        Numbers at;
    };

    void begin_with(const Spline& spline) {
        kind_ = spline.kind();
        for (const Spline::Knot& knot : spline.knots())
            points_.push_back({knot.t, {knot.at, static_cast<int>(spline.components())}});
    }

    void take_numbers(const Numbers& numbers, Span span) {
        if (t_) {
            points_.push_back({*t_, numbers});
            t_.reset();
        } else if (numbers.is_scalar() && std::isfinite(numbers.at[0])) {
            t_ = numbers.at[0];
            t_place_ = span;
        } else {
            refuse(Fault::wrong_type, span, "the number t comes before its point: 0, <1, 2, 3>");
        }
    }

    void refuse(Fault fault, Span span, std::string text) {
        evaluator_.report(error(fault, span, std::move(text)));
        good_ = false;
    }

    Evaluator& evaluator_;
    std::vector<Point> points_;
    std::optional<double> t_;  ///< waits for its point
    Span t_place_;
    Spline::Kind kind_ = Spline::Kind::linear;
    bool good_ = true;
};

}  // namespace

Value read_spline(Evaluator& evaluator, const Element& block) {
    SplineReader reader(evaluator);
    evaluator.walk(block.body, [&](const Element& element) { reader.take(element); });
    return reader.made(block.word_span);
}

}  // namespace candelabra
