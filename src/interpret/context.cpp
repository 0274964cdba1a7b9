// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/context.h"

#include "syntax/foreign.h"
#include "text/message.h"
#include "text/nearest.h"
#include "text/printable.h"

#include <algorithm>

namespace candelabra {

Context::Context(Evaluator& evaluator, SourceStore& sources, const Loader& loader, Names& names,
                 Diagnostics& diagnostics, const RunFacts& facts)
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
    handlers.knows_word = [](NameId) { return false; };
    handlers.print = [](std::string_view) {};
    world.evaluator = &evaluator;
    world.report = [this](Diagnostic diagnostic) { report(std::move(diagnostic)); };
    world.file_exists = [this](std::string_view name) {
        constexpr std::uint64_t asking = 100'000;
        costs.work += asking;
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

void Context::add_functions(std::span<const FunctionInfo> added) {
    for (const FunctionInfo& function : added) {
        // Some functions are not reserved: a scene's own names take precedence.
        const auto number = static_cast<std::size_t>(names.intern(function.name));
        functions.resize(std::max(functions.size(), number + 1));
        functions[number] = &function;
    }
}

bool Context::no_room(const Tree& tree, NodeId node) {
    if (!stopped())
        report(error(Fault::recursion_limit, tree.span(node), "this is nested too deeply")
                   .with_help("--limit-depth makes room for deeper calls of macros; a very long "
                              "expression can be declared in parts"));
    stop();
    return false;
}

Value Context::broken(Fault fault, Span span, std::string message) {
    report(error(fault, span, std::move(message)));
    return Absence::broken;
}

Value Context::unknown_name(NameId name, Span span) {
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
    else if (const std::string* file = trees.opening(name))
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
std::pair<const Tree*, NodeId> Context::own_declaration(NameId name, Span use) const {
    std::pair<const Tree*, NodeId> result{nullptr, no_node}, above = result;
    std::vector<std::uint32_t> undefs;
    bool again = false;  // text after the use may run before it
    for (const Tree& tree : trees.all()) {
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

Span Context::heading(const Tree& tree, NodeId declaration, NameId name) const {
    Span result = tree.span(declaration);
    const std::string_view spelling = names.spelling(name);
    const std::size_t at = sources.text(tree.source).substr(result.first).find(spelling);
    if (at != std::string_view::npos)
        result.last = result.first + static_cast<std::uint32_t>(at + spelling.size());
    return result;
}

void Context::warn_deprecated(NameId name, Span span) {
    const auto found = deprecated.find(name);
    if (found == deprecated.end()) return;
    Deprecation& known = found->second;
    if ((known.once && !known.places.empty()) ||
        !known.places.insert({span.source, span.first}).second)
        return;
    report(warning(Fault::deprecated, span, known.text));
}

bool Context::in_library(Span span) const {
    return span.known() && loader.in_standard_library(sources.name(span.source));
}

/// Maps a place in the library to that of the scene's call that led there.
Span Context::outside_library(Span span) const {
    if (!in_library(span)) return span;
    const std::vector<Frame> open = frames.list(names, sources);
    const auto call = std::ranges::find_if(open, [&](const Frame& frame) {
        return frame.called_at.known() && !in_library(frame.called_at);
    });
    return call == open.end() ? span : call->called_at;
}

void Context::point_at_scene(Diagnostic& diagnostic) const {
    const Span inner = diagnostic.span, outer = outside_library(inner);
    if (outer == inner) return;
    const std::string& path = sources.name(inner.source);
    diagnostic.with_note(
        message("this comes from the library: ", printable(path.substr(path.rfind('/') + 1)), ":",
                sources.place(inner.source, inner.first).line));
    diagnostic.span = outer;
    diagnostic.label.clear();
    // Calls within the library say nothing to who calls it.
    diagnostic.frames = frames.list(names, sources);
    std::erase_if(diagnostic.frames,
                  [&](const Frame& frame) { return in_library(frame.called_at); });
}

std::string Context::data_folder(Span span) const {
    return directory_of(sources.name(outside_library(span).source));
}

}  // namespace candelabra
