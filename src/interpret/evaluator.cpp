// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/evaluator.h"

#include "base/deep_stack.h"
#include "base/work_watch.h"
#include "interpret/splines.h"
#include "interpret/state.h"
#include "syntax/foreign.h"
#include "syntax/lint.h"
#include "text/message.h"
#include "text/nearest.h"
#include "text/printable.h"

#include <algorithm>
#include <array>
#include <memory>
#include <new>

namespace candelabra {

Evaluator::Evaluator(SourceStore& sources, const Loader& loader, Names& names,
                     Diagnostics& diagnostics, const RunFacts& facts)
    : state_(std::make_unique<State>(*this, sources, loader, names, diagnostics, facts)) {}

Evaluator::~Evaluator() = default;

void Evaluator::set_handlers(ElementHandlers handlers) {
    state_->handlers = std::move(handlers);
    state_->handlers.value = [this, value = std::move(state_->handlers.value),
                              spline =
                                  state_->names.find("spline")](std::span<const Element> elements) {
        constexpr std::uint64_t making = 200;
        state_->work += making;
        const bool splines = elements.size() == 1 && elements[0].word == spline;
        return splines ? read_spline(*this, elements[0]) : value(elements);
    };
}
void Evaluator::add_functions(std::span<const FunctionInfo> functions, ObjectQueries& objects) {
    state_->add_functions(functions);
    state_->world.objects = &objects;
}
void Evaluator::set_limits(const Limits& limits) { state_->limits = limits; }
const Limits& Evaluator::limits() const { return state_->limits; }
void Evaluator::declare(std::string_view name, Value value) {
    state_->scope.declare(state_->names.intern(name), std::move(value));
}
void Evaluator::undeclare(NameId name) { state_->scope.undefine(name); }
void Evaluator::walk(Body body, Take take) { state_->walk_whole(*body.tree, body.first, take); }
bool Evaluator::compute(Body body, Numbers& result) {
    return !state_->stopped_ && state_->compute(*body.tree, body.first, result);
}
void Evaluator::begin_attempt() { state_->world.random.begin_attempt(true); }
void Evaluator::end_attempt(bool keep) {
    if (!keep) state_->world.random.take_back(0);
    state_->world.random.end_attempt();
}
const Value* Evaluator::find(NameId name) const { return state_->scope.find(name); }
Value Evaluator::value_of(const Element& element) {
    return state_->one_value({&element, 1}, element.span);
}
double Evaluator::version() const { return state_->version; }
void Evaluator::set_working_gamma(double gamma) { state_->working_gamma = gamma; }
double Evaluator::working_gamma() const { return state_->working_gamma; }
const LightUnits& Evaluator::use_light_units() {
    state_->light_units_used = true;
    return state_->light_units;
}
bool Evaluator::set_light_units(const LightUnits& units) {
    if (state_->light_units_used && units != state_->light_units) return false;
    state_->light_units = units;
    return true;
}
bool Evaluator::version_given() const { return state_->version_given; }
const RunFacts& Evaluator::facts() const { return state_->facts; }
bool Evaluator::in_library(Span span) const { return state_->in_library(span); }
bool Evaluator::has_foreign_strings() const {
    const auto is_foreign = [](const std::string& text) {
        return std::ranges::any_of(text,
                                   [](char c) { return static_cast<unsigned char>(c) > 127; });
    };
    return std::ranges::any_of(state_->files.all(), [&](const Tree& tree) {
        return std::ranges::any_of(tree.texts, is_foreign);
    });
}
const std::shared_ptr<SceneNoise>& Evaluator::noise() const { return state_->noise; }
void Evaluator::report(Diagnostic diagnostic) { state_->report(std::move(diagnostic)); }
bool Evaluator::stopped() const { return state_->stopped(); }
void Evaluator::note_reported(const Body& word) { state_->reported = word; }
void Evaluator::stop() { state_->stopped_ = true; }
void Evaluator::count_object(Span span) { state_->count_object(span); }
void Evaluator::count_placed(std::uint64_t parts, Span span) { state_->count_placed(parts, span); }
bool Evaluator::may_have_parts(std::uint64_t parts, Span span) {
    return state_->may_have_parts(parts, span);
}
bool Evaluator::spend(std::uint64_t amount, Span span) { return state_->spend(amount, span); }
std::string_view Evaluator::spelling(NameId name) const { return state_->names.spelling(name); }
SourceStore& Evaluator::sources() { return state_->sources; }
const Loader& Evaluator::loader() const { return state_->loader; }
Names& Evaluator::names() { return state_->names; }
Diagnostics& Evaluator::diagnostics() { return state_->diagnostics; }

std::vector<std::string_view> Evaluator::declared_names() const {
    std::vector<std::string_view> result;
    for (const NameId name : state_->scope.names()) result.push_back(state_->names.spelling(name));
    return result;
}

void Evaluator::run(SourceId main) {
    State& state = *state_;
    state.diagnostics.set_frames(
        [&state] { return state.frames.list(state.names, state.sources); },
        [&state](Diagnostic& diagnostic) { state.point_at_scene(diagnostic); });
    on_deep_stack(state.limits.stack_bytes, [&](std::size_t bytes) {
        const char here = 0;
        // The code between two checks, including the binder's, fits into the margin.
        const std::size_t margin = std::size_t{1} << 20;
        state.stack_end = &here - (bytes - margin);
        state.run_within_memory(main);
        state.check_written_files();
    });
    state.stack_end = nullptr;
    state.diagnostics.set_frames({});
}

Evaluator::State::State(Evaluator& evaluator, SourceStore& sources, const Loader& loader,
                        Names& names, Diagnostics& diagnostics, const RunFacts& facts)
    : evaluator(evaluator),
      sources(sources),
      loader(loader),
      names(names),
      diagnostics(diagnostics),
      facts(facts) {
    handlers.top = [](const Element&) {};
    handlers.value = [](std::span<const Element>) { return Value(Absence::broken); };
    handlers.function = [](const Element&) { return Handle<Formula>(nullptr); };
    handlers.set_default = [](const Element&) {};
    handlers.takes_braces = [](NameId) { return false; };
    handlers.print = [](std::string_view) {};
    world.evaluator = &evaluator;
    world.report = [this](Diagnostic diagnostic) { report(std::move(diagnostic)); };
    world.file_exists = [this](std::string_view name) {
        constexpr std::uint64_t asking = 100'000;
        work += asking;
        return this->loader.finds(std::string(name), {}, FileKind::data);
    };
    functions.resize(reserved_words().size());
    add_functions(candelabra::functions());
    const auto number = [&](std::string_view name, double value) {
        scope.declare(names.intern(name), value);
    };
    number("image_width", facts.image_width);
    number("image_height", facts.image_height);
    number("frame_number", facts.frame_number);
    number("initial_frame", facts.initial_frame);
    number("final_frame", facts.final_frame);
    number("initial_clock", facts.initial_clock);
    number("final_clock", facts.final_clock);
    number("clock_delta", facts.clock_delta);
    version = facts.version.value_or(version);
    noise->version = version;
    version_given = facts.version.has_value();
}

void Evaluator::State::add_functions(std::span<const FunctionInfo> added) {
    for (const FunctionInfo& function : added) {
        // Some functions are not reserved: a scene's own names take precedence.
        const auto number = static_cast<std::size_t>(names.intern(function.name));
        functions.resize(std::max(functions.size(), number + 1));
        functions[number] = &function;
    }
}

void Evaluator::State::run_within_memory(SourceId main) {
    // Released to have room for the message.
    auto reserve = std::make_unique<std::array<char, std::size_t{1} << 20>>();
    // Steps that objects, meshes and patterns count take longer than those of expressions.
    constexpr std::uint64_t each_step = 20;
    const WorkWatch* asking = nullptr;
    std::uint64_t counted = 0;
    const std::function<bool()> too_much = [&] {
        work += each_step * (asking->counted() - std::exchange(counted, asking->counted()));
        return work > limits.work;
    };
    const WorkWatch watch(too_much);
    asking = &watch;
    try {
        run(main);
    } catch (const WorkEnded&) {
        overspent({});
    } catch (const std::bad_alloc&) {
        reserve.reset();
        stopped_ = true;
        const std::vector<Frame> open = frames.list(names, sources);
        const OpenLoop* loop = busiest_loop();
        Diagnostic problem = error(Fault::io,
                                   loop           ? loop->place()
                                   : open.empty() ? Span()
                                                  : open.front().called_at,
                                   "there is not enough memory to evaluate this scene");
        if (loop) problem.with_label(message("this loop has run ", loop->passes, " times"));
        report(problem.with_help(loop ? "a loop that does not end needs a condition that becomes "
                                        "false, or #break; --limit-memory sets how much memory "
                                        "there may be"
                                      : "--limit-memory sets how much there may be"));
    }
}

void Evaluator::State::run(SourceId main) {
    if (handlers.set_version) handlers.set_version(version, {});
    files.deepest = limits.include_depth;
    const Tree& tree = files.main(main, version);
    lint(tree, names, diagnostics);
    // A tree with holes would only give errors that follow from the first ones.
    if (diagnostics.failed()) stopped_ = true;
    learn(tree);
    const auto take = [&](const Element& element) { handlers.top(element); };
    if (!stopped_ && !facts.header.empty()) {
        const std::string directory = directory_of(sources.name(main));
        if (!loader.load(facts.header, directory)) {
            report(loader.problem(facts.header, {}, FileKind::include, directory)
                       .with_note("Include_Header or +HI names it"));
            stopped_ = true;
            return;
        }
        if (const Tree* header = load(facts.header, {main, 0, 0}))
            walk_whole(*header, header->first, take);
    }
    if (!stopped_) walk_whole(tree, tree.first, take);
}

/// Prepares for a walk over a tree.
void Evaluator::State::learn(const Tree& tree) {
    codes.add(tree);
    for (const ScopedName& each : tree.scoped) scope.learn(each.whole, each.name, each.global);
}

void Evaluator::State::walk_whole(const Tree& tree, NodeId first, const Sink& take) {
    // Not inlined, so that nested objects do not each reserve stack for a message.
    const auto report_break = [this]() __attribute__((noinline)) {
        report(error(Fault::misplaced, last_break,
                     "this #break is in no loop, #switch or macro that it could leave"));
    };
    if (walk(tree, first, take) == Flow::broken) report_break();
}

bool Evaluator::State::no_room(const Tree& tree, NodeId node) {
    if (!stopped_)
        report(error(Fault::recursion_limit, tree.span(node), "this is nested too deeply")
                   .with_help("--limit-depth makes room for deeper calls of macros; a very long "
                              "expression can be declared in parts"));
    stopped_ = true;
    return false;
}

Value Evaluator::State::broken(Fault fault, Span span, std::string message) {
    report(error(fault, span, std::move(message)));
    return Absence::broken;
}

Value Evaluator::State::unknown_name(NameId name, Span span) {
    Diagnostic problem = error(Fault::unknown_name, span,
                               message("nothing is declared as `", names.spelling(name), "`"));
    std::vector<std::string_view> known = evaluator.declared_names();
    for (const Word& word : reserved_words())
        if (word.word_class == WordClass::constant) known.push_back(word.spelling);
    const std::string_view rest = sources.text(span.source).substr(span.last);
    if (rest.starts_with('('))
        for (const FunctionInfo* function : functions)
            if (function) known.push_back(function->name);
    const std::string library = loader.library_file_declaring(names.spelling(name));
    const auto [own, id] = own_declaration(name, span);
    const bool above = own && own->span(id).last <= span.first;
    const bool within = own && !above && own->span(id).first < span.first;
    if (const std::string file = meant_as_file(sources.text(span.source), span); !file.empty())
        problem.with_help(message("the name of a file stands in quotes: \"", file, "\""));
    else if (const std::string* file = files.opening(name))
        problem.with_help(
            message("`", names.spelling(name),
                    "` leaves braces to other macros to close "
                    "or open; such macros are found only where #include names the file "
                    "by a plain string: #include \"",
                    printable(*file), "\""));
    else if (within)
        problem.with_help(
            "a name has no value in its own declaration; only macros call themselves");
    else if (own)
        problem.pointing(
            heading(*own, id, name),
            above ? "declared only here, in a part that was not reached" : "declared only here");
    else if (const std::string_view way_out = foreign_name(names.spelling(name)); !way_out.empty())
        problem.with_help(std::string(way_out));
    else if (!library.empty())
        problem.with_help(message("`", names.spelling(name), "` is declared in ", library,
                                  ": #include \"", library, "\""));
    else if (const std::string guess = nearest(names.spelling(name), known); !guess.empty())
        problem.with_help(message("did you mean `", guess, "`?"));
    else
        problem.with_help(message("declare it first: #declare ", names.spelling(name), " = ...;"));
    report(problem);
    return Absence::broken;
}

/// The declaration of a name in the file that uses it: around the use, or the first after it, or
/// the last before it in a part that has not been walked. Null if there is none.
std::pair<const Tree*, NodeId> Evaluator::State::own_declaration(NameId name, Span use) const {
    std::pair<const Tree*, NodeId> result{nullptr, no_node}, above = result;
    std::vector<std::uint32_t> undefs;
    bool again = false;  // text after the use may run before it
    for (const Tree& tree : files.all()) {
        if (tree.source != use.source) continue;
        for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
            const NodeId id{static_cast<std::uint32_t>(i)};
            const auto* macro = tree.get_if<node::Macro>(id);
            const auto* declare = tree.get_if<node::Declare>(id);
            const auto* target = declare ? tree.get_if<node::Name>(declare->target) : nullptr;
            const bool declares = (macro && macro->name == name) ||
                                  (target && target->name == name && !declare->local);
            const auto* undef = tree.get_if<node::Undef>(id);
            const auto* gone = undef ? tree.get_if<node::Name>(undef->target) : nullptr;
            if (gone && gone->name == name) undefs.push_back(tree[id].first);
            again |= (macro || tree.get_if<node::While>(id) || tree.get_if<node::For>(id)) &&
                     tree[id].first < use.first && use.last < tree[id].last;
            if (!declares) continue;
            auto& found = tree[id].last <= use.first ? above : result;
            const bool better =
                !found.first || &found == &above || tree[id].first < tree[found.second].first;
            if (better) found = {&tree, id};
        }
    }
    if (result.first || !above.first) return result;
    const std::uint32_t declared = (*above.first)[above.second].first;
    const auto undoes = [&](std::uint32_t place) {
        return declared < place && (again || place < use.first);
    };
    return std::ranges::any_of(undefs, undoes) ? result : above;
}

Span Evaluator::State::heading(const Tree& tree, NodeId declaration, NameId name) const {
    Span result = tree.span(declaration);
    const std::string_view spelling = names.spelling(name);
    const std::size_t at = sources.text(tree.source).substr(result.first).find(spelling);
    if (at != std::string_view::npos)
        result.last = result.first + static_cast<std::uint32_t>(at + spelling.size());
    return result;
}

Element Evaluator::State::block_element(const Tree& tree, NodeId id) {
    constexpr std::uint64_t reading = 60;
    work += reading;
    const auto& block = tree.get<node::Block>(id);
    Element element;
    element.kind = Element::Kind::block;
    element.word = block.word;
    element.body = {&tree, block.body};
    element.origin = {&tree, id};
    element.span = tree.span(id);
    const auto length = static_cast<std::uint32_t>(names.spelling(block.word).size());
    element.word_span = {tree.source, element.span.first, element.span.first + length};
    return element;
}

Value Evaluator::State::one_value(OneValue&& one, Span span) {
    if (one.broken || stopped_) return Absence::broken;
    if (one.count == 1 && !one.first) return std::move(one.value);
    if (one.count != 1) return report_count(one.count, span);
    return one_value(
        one.first ? std::span<const Element>(&*one.first, 1) : std::span<const Element>(), span);
}

Value Evaluator::State::report_count(std::size_t count, Span span) {
    if (count > 0)
        return broken(Fault::wrong_count, span,
                      message("one value is wanted here, and this gives ", count));
    if (stopped_) return Absence::broken;
    report(error(Fault::missing, span, "a value is wanted here, and this macro gives none")
               .with_help("a macro gives what stands in it without a directive: "
                          "#macro Twice(A) (2*A) #end"));
    return Absence::broken;
}

Value Evaluator::State::one_value(std::span<const Element> elements, Span span) {
    if (stopped_) return Absence::broken;
    if (elements.empty())
        return broken(Fault::missing, span, "a value is wanted here, and this gives none");
    const bool blocks = std::all_of(elements.begin(), elements.end(), [](const Element& e) {
        return e.kind == Element::Kind::block;
    });
    if (blocks) return handlers.value(elements);
    for (const Element& element : elements)
        if (element.kind == Element::Kind::value && element.value.broken()) return Absence::broken;
    if (elements.size() > 1)
        return broken(Fault::wrong_count, span,
                      message("one value is wanted here, and this gives ", elements.size()));
    const Element& element = elements.front();
    switch (element.kind) {
        case Element::Kind::value:
            return element.value;
        case Element::Kind::word:
            if (!names.reserved(element.word)) return unknown_name(element.word, element.span);
            return broken(Fault::wrong_type, element.span,
                          message("a value is wanted here, and `", names.spelling(element.word),
                                  "` is none"));
        default:
            return broken(Fault::wrong_type, element.span, "a value is wanted here");
    }
}

}  // namespace candelabra
