// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/evaluator.h"

#include "base/deep_stack.h"
#include "base/gamma.h"
#include "interpret/calls.h"
#include "interpret/context.h"
#include "interpret/expressions.h"
#include "interpret/files.h"
#include "interpret/splines.h"
#include "interpret/statements.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace candelabra {

struct Evaluator::State {
    State(Evaluator& evaluator, SourceStore& sources, const Loader& loader, Names& names,
          Diagnostics& diagnostics, const RunFacts& facts)
        : context(evaluator, sources, loader, names, diagnostics, facts) {
        context.expressions = &expressions;
        context.calls = &calls;
        context.statements = &statements;
        context.files = &files;
    }

    Context context;
    Expressions expressions{context};
    Calls calls{context};
    Statements statements{context};
    DataFiles files{context};
};

Evaluator::Evaluator(SourceStore& sources, const Loader& loader, Names& names,
                     Diagnostics& diagnostics, const RunFacts& facts)
    : state_(std::make_unique<State>(*this, sources, loader, names, diagnostics, facts)) {}

Evaluator::~Evaluator() = default;

void Evaluator::set_handlers(ElementHandlers handlers) {
    state_->context.handlers = std::move(handlers);
    state_->context.handlers.value =
        [this, value = std::move(state_->context.handlers.value),
         spline = state_->context.names.find("spline")](std::span<const Element> elements) {
            constexpr std::uint64_t making = 200;
            state_->context.costs.work += making;
            const bool splines = elements.size() == 1 && elements[0].word == spline;
            return splines ? read_spline(*this, elements[0]) : value(elements);
        };
}
void Evaluator::add_functions(std::span<const FunctionInfo> functions, ObjectQueries& objects) {
    state_->context.add_functions(functions);
    state_->context.world.objects = &objects;
}
void Evaluator::set_limits(const Limits& limits) { state_->context.costs.limits = limits; }
void Evaluator::set_ended(std::function<bool()> ended) {
    state_->context.costs.ended = std::move(ended);
}
const Limits& Evaluator::limits() const { return state_->context.costs.limits; }
void Evaluator::declare(std::string_view name, Value value) {
    state_->context.scope.declare(state_->context.names.intern(name), std::move(value));
}
void Evaluator::undeclare(NameId name) { state_->context.scope.undefine(name); }
void Evaluator::walk(Body body, Take take) {
    state_->statements.walk_whole(*body.tree, body.first, Sink::of_block(take));
}
bool Evaluator::compute(Body body, Numbers& result) {
    return !state_->context.stopped() &&
           state_->expressions.compute(*body.tree, body.first, result);
}
void Evaluator::begin_attempt() { state_->context.world.random.begin_attempt(true); }
void Evaluator::end_attempt(bool keep) {
    if (!keep) state_->context.world.random.take_back(0);
    state_->context.world.random.end_attempt();
}
const Value* Evaluator::find(NameId name) const { return state_->context.scope.find(name); }
Value Evaluator::value_of(const Element& element) {
    return state_->expressions.one_value({&element, 1}, element.span);
}
double Evaluator::version() const { return state_->context.version; }
void Evaluator::set_working_gamma(double gamma) { state_->context.working_gamma = gamma; }
double Evaluator::working_gamma() const { return state_->context.working_gamma; }
const LightUnits& Evaluator::use_light_units() {
    state_->context.light_units_used = true;
    return state_->context.light_units;
}
bool Evaluator::set_light_units(const LightUnits& units) {
    if (state_->context.light_units_used && units != state_->context.light_units) return false;
    state_->context.light_units = units;
    return true;
}
bool Evaluator::version_given() const { return state_->context.version_given; }
const RunFacts& Evaluator::facts() const { return state_->context.facts; }
bool Evaluator::in_library(Span span) const { return state_->context.in_library(span); }
bool Evaluator::has_foreign_strings() const {
    const auto is_foreign = [](const std::string& text) {
        return std::ranges::any_of(text,
                                   [](char c) { return static_cast<unsigned char>(c) > 127; });
    };
    return std::ranges::any_of(state_->context.trees.all(), [&](const Tree& tree) {
        return std::ranges::any_of(tree.texts, is_foreign);
    });
}
const std::shared_ptr<SceneNoise>& Evaluator::noise() const { return state_->context.noise; }
void Evaluator::report(Diagnostic diagnostic) { state_->context.report(std::move(diagnostic)); }
bool Evaluator::stopped() const { return state_->context.stopped(); }
void Evaluator::note_reported(const Body& word) { state_->context.reported = word; }
void Evaluator::stop() { state_->context.stop(); }
void Evaluator::count_object(Span span) { state_->context.costs.count_object(span); }
void Evaluator::count_placed(std::uint64_t parts, Span span) {
    state_->context.costs.count_placed(parts, span);
}
bool Evaluator::may_have_parts(std::uint64_t parts, Span span) {
    return state_->context.costs.may_have_parts(parts, span);
}
bool Evaluator::spend(std::uint64_t amount, Span span) {
    return state_->context.costs.spend(amount, span);
}
std::string_view Evaluator::spelling(NameId name) const {
    return state_->context.names.spelling(name);
}
SourceStore& Evaluator::sources() { return state_->context.sources; }
const Loader& Evaluator::loader() const { return state_->context.loader; }
Names& Evaluator::names() { return state_->context.names; }
Diagnostics& Evaluator::diagnostics() { return state_->context.diagnostics; }

std::vector<std::string_view> Evaluator::declared_names() const {
    std::vector<std::string_view> result;
    for (const NameId name : state_->context.scope.names())
        result.push_back(state_->context.names.spelling(name));
    return result;
}

void Evaluator::run(SourceId main) {
    State& state = *state_;
    state.context.diagnostics.set_frames(
        [&state] { return state.context.frames.list(state.context.names, state.context.sources); },
        [&state](Diagnostic& diagnostic) { state.context.point_at_scene(diagnostic); });
    on_deep_stack(state.context.costs.limits.stack_bytes, [&](std::size_t bytes) {
        const char here = 0;
        // The code between two checks, including the binder's, fits into the margin.
        const std::size_t margin = std::min(std::size_t{1} << 20, bytes / 4);
        state.context.stack_end = &here - (bytes - margin);
        state.statements.run(main);
        state.files.check_written_files();
    });
    state.context.stack_end = nullptr;
    state.context.diagnostics.set_frames({});
}

Value Evaluator::element_at(const Value& array, std::string_view path, Span span) {
    Indices indices;
    indices.path = span;
    if (path.find('.') == path.npos)
        indices.add_part(path);
    else
        indices.add(std::string(path));
    return state_->expressions.element(array, indices, span);
}

Numbers Evaluator::display_colour(const std::array<double, 4>& colour) const {
    Numbers result = Numbers::colour({});
    for (std::size_t i = 0; i < 3; ++i)
        result.at[i] = from_linear(srgb_decode(colour[i]), state_->context.working_gamma);
    result.at[4] = 1 - colour[3];
    return result;
}

std::optional<Found> Evaluator::load_found(const std::string& name, Span span) {
    if (!state_->context.costs.count_file(span)) return std::nullopt;
    const std::string directory = state_->context.data_folder(span);
    std::optional<Found> found = state_->context.loader.load(name, directory, FileKind::data);
    if (!found) report(state_->context.loader.problem(name, span, FileKind::data, directory));
    return found;
}

std::optional<std::string> Evaluator::load_data(const std::string& name, Span span) {
    std::optional<Found> found = load_found(name, span);
    return found ? std::optional(std::move(found->text)) : std::nullopt;
}

std::optional<Found> Evaluator::find_data(const std::string& name, Span span,
                                          std::span<const std::string_view> endings) {
    const std::string directory = state_->context.data_folder(span);
    const Loader& loader = state_->context.loader;
    const auto is_there = [&](const std::string& file) {
        return loader.finds(file, directory, FileKind::data);
    };
    std::string file = name;
    if (name.find('.', name.rfind('/') + 1) == name.npos && !is_there(name))
        for (const std::string_view ending : endings)
            if (file == name && is_there(message(name, ending))) file = message(name, ending);
    return load_found(file, span);
}

bool Evaluator::sample(const Formula& function, Rows rows, Span place,
                       FunctionRef<void(const FunctionResults&, bool good)> visit) {
    constexpr std::uint64_t each_pixel = 10;
    const int width = function.columns(), height = function.rows();
    const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    if (!spend(pixels * (function.cost() + each_pixel), place)) return false;
    for (int row = 0; row < height; ++row) {
        const double share = row / std::fmax(1, height - 1);
        const double y = rows == Rows::from_bottom ? share : 1 - share;
        for (int column = 0; column < width; ++column) {
            const std::array<double, 3> at = {column / std::fmax(1, width - 1), y, 0};
            FunctionResults results{};
            const bool good = function.run(at.data(), results.data());
            visit(results, good);
        }
    }
    return true;
}

}  // namespace candelabra
