// SPDX-License-Identifier: GPL-3.0-or-later
// Directives: control of the walk, messages, versions, includes. Declarations are in declare.cpp.
#include "interpret/state.h"
#include "text/message.h"

#include <cmath>
#include <utility>

namespace candelabra {

Flow Evaluator::State::directive(const Tree& tree, NodeId id, const Sink& take) {
    constexpr std::uint64_t each = 80;
    work += each;
    const NodeContent& content = tree[id].content;
    switch (content.index()) {
        case kind<node::Declare>:
            declare(tree, *std::get_if<node::Declare>(&content), id);
            break;
        case kind<node::Deprecated>:
            declare_deprecated(tree, *std::get_if<node::Deprecated>(&content), id);
            break;
        case kind<node::Undef>:
            undefine(tree, std::get_if<node::Undef>(&content)->target);
            break;
        case kind<node::If>:
            return branch(tree, *std::get_if<node::If>(&content), take);
        case kind<node::Postponed>:
            for (const Diagnostic& each :
                 tree.postponed[std::get_if<node::Postponed>(&content)->index])
                report(each);
            stopped_ = true;
            break;
        case kind<node::While>:
            return loop_while(tree, *std::get_if<node::While>(&content), take);
        case kind<node::For>:
            return loop_for(tree, *std::get_if<node::For>(&content), id, take);
        case kind<node::Switch>:
            return choose(tree, *std::get_if<node::Switch>(&content), take);
        case kind<node::Break>:
            last_break = tree.span(id);
            return Flow::broken;
        case kind<node::Macro>:
            define_macro(tree, *std::get_if<node::Macro>(&content), id);
            break;
        case kind<node::Include>:
            return include(tree, *std::get_if<node::Include>(&content), id, take);
        case kind<node::Default>:
            walk(tree, std::get_if<node::Default>(&content)->body,
                 [&](const Element& element) { handlers.set_default(element); });
            break;
        case kind<node::Message>:
            speak(tree, *std::get_if<node::Message>(&content), id);
            break;
        case kind<node::Version>:
            set_version(tree, *std::get_if<node::Version>(&content), id);
            break;
        case kind<node::Open>:
            open_file(tree, *std::get_if<node::Open>(&content), id);
            break;
        case kind<node::Close>:
            close_file(tree, *std::get_if<node::Close>(&content), id);
            break;
        case kind<node::Read>:
            read_values(tree, *std::get_if<node::Read>(&content), id);
            break;
        case kind<node::Write>:
            write_values(tree, *std::get_if<node::Write>(&content), id);
            break;
        default:
            break;
    }
    return stopped_ ? Flow::stopped : Flow::end;
}

bool Evaluator::State::condition(const Tree& tree, NodeId id) {
    if (const auto* test = tree.get_if<node::Defined>(id))
        return defined(tree, test->target) != test->negated;
    const std::optional<double> value = number(tree, id, "a condition");
    return value && is_true(*value);
}

const node::Branch* Evaluator::State::taken_branch(const Tree& tree, const node::If& node) {
    for (NodeId id = node.branches; id != no_node && !stopped_; id = tree[id].next) {
        const auto& branch = tree.get<node::Branch>(id);
        if (branch.condition == no_node || condition(tree, branch.condition)) return &branch;
    }
    return nullptr;
}

Flow Evaluator::State::branch(const Tree& tree, const node::If& node, const Sink& take) {
    if (const node::Branch* taken = taken_branch(tree, node)) return walk(tree, taken->body, take);
    return stopped_ ? Flow::stopped : Flow::end;
}

bool Evaluator::State::too_many_steps(const Tree& tree, NodeId place) {
    constexpr std::uint64_t each = 20;
    if (++steps <= limits.steps) return !spend(each, tree.span(place));
    if (!stopped_)
        report(error(Fault::loop_limit, tree.span(place),
                     message("this scene takes more than ", limits.steps,
                             " passes of loops and calls of macros, which is the limit"))
                   .with_help("something in a loop must make its condition false, or #break; "
                              "--limit-steps raises the limit"));
    stopped_ = true;
    return true;
}

void Evaluator::State::count_object(Span span) {
    if (++objects <= limits.objects || stopped_) return;
    Diagnostic problem = error(
        Fault::loop_limit, span,
        message("this scene makes more than ", limits.objects, " objects, which is the limit"));
    report(point_at_loop(problem).with_help(
        "something in a loop must make its condition false, or #break; --limit-objects raises the "
        "limit"));
    stopped_ = true;
}

void Evaluator::State::count_placed(std::uint64_t parts, Span span) {
    placed += parts;
    if (placed <= limits.objects || stopped_) return;
    report(error(Fault::loop_limit, span,
                 message("with the parts of this object there are more than ", limits.objects,
                         " objects in the scene, which is the limit"))
               .with_help("unions of unions grow fast; --limit-objects raises the limit"));
    stopped_ = true;
}

Span OpenLoop::place() const {
    Span all = tree->span(first);
    for (NodeId id = (*tree)[first].next; id != no_node; id = (*tree)[id].next)
        all = join(all, tree->span(id));
    return all;
}

const OpenLoop* Evaluator::State::busiest_loop() const {
    const OpenLoop* busiest = nullptr;
    for (const OpenLoop& each : loops)
        if (!busiest || each.passes >= busiest->passes) busiest = &each;
    return busiest;
}

Diagnostic& Evaluator::State::point_at_loop(Diagnostic& problem) const {
    if (const OpenLoop* loop = busiest_loop())
        problem.pointing(loop->place(), message("in this loop, which has run ", loop->passes,
                                                loop->passes == 1 ? " time" : " times"));
    return problem;
}

Flow Evaluator::State::loop_while(const Tree& tree, const node::While& node, const Sink& take) {
    const std::size_t outer = loops.size();
    loops.push_back({&tree, node.condition});
    while (condition(tree, node.condition) && !stopped_) {
        if (too_many_steps(tree, node.condition)) return Flow::stopped;
        ++loops[outer].passes;
        const Flow flow = walk(tree, node.body, take);
        if (flow == Flow::stopped) return flow;
        if (flow == Flow::broken) break;
    }
    loops.resize(outer);
    return stopped_ ? Flow::stopped : Flow::end;
}

/// Start, end and step of a loop; nothing if there is no pass, or after a report.
std::optional<std::array<double, 3>> Evaluator::State::for_range(const Tree& tree,
                                                                 const node::For& node, NodeId id) {
    std::array<double, 3> range = {0, 0, 1};
    std::size_t count = 0;
    for (NodeId value = node.range; value != no_node; value = tree[value].next, ++count) {
        if (count == range.size()) break;
        const std::optional<double> found = number(tree, value,
                                                   count == 0   ? "the start of a #for"
                                                   : count == 1 ? "the end of a #for"
                                                                : "the step of a #for");
        if (!found) return std::nullopt;
        range[count] = *found;
    }
    if (count < 2) {
        broken(Fault::wrong_count, tree.span(id),
               "a #for needs a name, a start and an end: #for(i, 1, 10)");
        return std::nullopt;
    }
    if (std::isnan(range[2])) return std::nullopt;  // As in POV-Ray, no pass.
    if (std::abs(range[2]) < tolerance) {
        broken(Fault::out_of_range, tree.span(id),
               message("the step of this #for is ", range[2], ", so it would not end"));
        return std::nullopt;
    }
    return range;
}

/// The counter of a loop after a pass: the body may have changed it.
std::optional<double> Evaluator::State::counter(NameId name, Span span) {
    const Value* now = scope.find(name);
    const Numbers* number = now ? now->numbers() : nullptr;
    if (number && number->is_scalar()) return number->at[0];
    broken(Fault::wrong_type, span,
           message("the counter `", names.spelling(name), "` is no number any more"));
    return std::nullopt;
}

Flow Evaluator::State::loop_for(const Tree& tree, const node::For& node, NodeId id,
                                const Sink& take) {
    const auto* target = tree.get_if<node::Name>(node.target);
    if (!target) {
        broken(Fault::wrong_type, tree.span(node.target), "a #for counts with a plain name");
        return Flow::end;
    }
    const auto range = for_range(tree, node, id);
    if (!range) return Flow::end;
    const auto [start, end, step] = *range;
    const NameId name = target->name;
    scope.declare_local(name, start);
    if (!(step > 0 ? start < end + tolerance : start > end - tolerance)) return Flow::end;
    double i = start;
    const std::size_t outer = loops.size();
    loops.push_back({&tree, node.range});
    while (step > 0 ? i <= end + tolerance : i >= end - tolerance) {
        if (too_many_steps(tree, id)) return Flow::stopped;
        ++loops[outer].passes;
        const Flow flow = walk(tree, node.body, take);
        if (flow == Flow::stopped) return flow;
        if (flow == Flow::broken) break;
        if (Numbers* number = scope.overwritable(name, true); number && number->is_scalar()) {
            i = number->at[0] += step;
            continue;
        }
        const std::optional<double> now = counter(name, tree.span(node.target));
        if (!now) break;
        i = *now + step;
        scope.declare_local(name, i);
    }
    loops.resize(outer);
    return stopped_ ? Flow::stopped : Flow::end;
}

Flow Evaluator::State::choose(const Tree& tree, const node::Switch& node, const Sink& take) {
    const std::optional<double> subject = number(tree, node.subject, "what #switch looks at");
    if (!subject) return stopped_ ? Flow::stopped : Flow::end;
    Flow flow = walk(tree, node.opening, [&](const Element& element) {
        report(error(Fault::misplaced, element.span,
                     "only directives can stand between a #switch and its first #case"));
    });
    bool matched = false;  // from then on all bodies are walked, until #break
    for (NodeId id = node.cases; id != no_node && flow == Flow::end; id = tree[id].next) {
        const auto* part = tree.get_if<node::Case>(id);
        if (!part) continue;
        if (!matched) {
            const NodeId first = part->values;
            const NodeId second = first == no_node ? no_node : tree[first].next;
            const std::optional<double> low =
                first == no_node ? std::nullopt : number(tree, first, "a case");
            const std::optional<double> high =
                second == no_node ? std::nullopt : number(tree, second, "the end of a range");
            if (first == no_node)
                matched = true;
            else if (second == no_node)
                matched = low && std::abs(*low - *subject) < tolerance;
            else
                matched = low && high && *low <= *subject && *subject <= *high;
        }
        if (matched) flow = walk(tree, part->body, take);
    }
    return flow == Flow::stopped || stopped_ ? Flow::stopped : Flow::end;
}

Flow Evaluator::State::include(const Tree& tree, const node::Include& node, NodeId id,
                               const Sink& take) {
    const Span span = tree.span(node.file);
    const auto* member = tree.get_if<node::Member>(node.file);
    const auto* bare = tree.get_if<node::Name>(member ? member->operand : node.file);
    const bool angles = tree.get_if<node::Vector>(node.file) != nullptr;
    if (angles || (bare && !scope.find(bare->name))) {
        // All declarations of the file are missing from here on.
        const std::uint32_t sign = angles ? 1 : 0;
        broken(Fault::wrong_type, span,
               message("the name of a file stands in quotes: #include \"",
                       sources.text(span.source)
                           .substr(span.first + sign, span.last - span.first - 2 * sign),
                       "\""));
        stopped_ = true;
        return Flow::stopped;
    }
    const Value file = evaluate(tree, node.file);
    if (!file.text()) {
        if (!file.broken())
            broken(Fault::wrong_type, span,
                   message("#include takes the name of a file, but this is ", kind_name(file)));
        return stopped_ ? Flow::stopped : Flow::end;
    }
    if (include_depth >= limits.include_depth) {
        report(error(Fault::recursion_limit, tree.span(id),
                     message("files include each other ", limits.include_depth,
                             " deep, which is the limit"))
                   .with_help("a file that includes itself needs an #ifndef that ends it; "
                              "--limit-includes raises the limit"));
        stopped_ = true;
        return Flow::stopped;
    }
    if (!room(tree, id)) return Flow::stopped;
    const Tree* included = load(*file.text(), span);
    if (!included) return stopped_ ? Flow::stopped : Flow::end;
    ++include_depth;
    scope.enter();
    frames.push({Frame::include, no_name, included->source, span});
    const Flow flow = walk(*included, included->first, take);
    frames.pop();
    scope.leave();
    --include_depth;
    return flow;
}

const Tree* Evaluator::State::load(const std::string& name, Span span) {
    const std::string directory = directory_of(sources.name(span.source));
    if (!count_file(span)) return nullptr;
    const std::optional<Found> found = loader.load(name, directory);
    if (!found) {
        report(loader.problem(name, span, FileKind::include, directory));
        // The declarations of the file are missing from here on, so that more errors would follow
        // from this one.
        stopped_ = true;
        return nullptr;
    }
    for (const std::string& path : found->passed_over)
        report(warning(Fault::file_access, span, Loader::passed_over(path))
                   .with_help("remove the file, or include it by a path of its own"));
    if (!spend(found->text.size() / 4, span)) return nullptr;
    const FileTrees::Included file = files.included(*found, span, version);
    if (file.first) {
        frames.push({Frame::include, no_name, file.tree->source, span});
        diagnostics.add_all(file.found);
        frames.pop();
        learn(*file.tree);
        if (file.found.failed()) stopped_ = true;
    }
    return stopped_ ? nullptr : file.tree;
}

void Evaluator::State::speak(const Tree& tree, const node::Message& node, NodeId id) {
    const Value value = evaluate(tree, node.text);
    if (!value.text()) {
        if (!value.broken())
            report(
                error(Fault::wrong_type, tree.span(node.text),
                      message("a message is a string, but this is ", kind_name(value)))
                    .with_help("str(x, 0, 3) and vstr(3, v, \",\", 0, 3) make strings of numbers"));
        return;
    }
    std::string text = *value.text();
    if (!count_said(text.size(), tree.span(id))) return;
    if (node.kind != MessageKind::error && node.kind != MessageKind::warning)
        return handlers.print(text);
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    if (node.kind == MessageKind::warning)
        return report(warning(Fault::user_warning, tree.span(id), text));
    report(error(Fault::user_error, tree.span(id), text));
    stopped_ = true;
}

void Evaluator::State::set_version(const Tree& tree, const node::Version& node, NodeId id) {
    // As in POV-Ray 3.8, the first one may ask for the newest: `#version version;`.
    const double before = std::exchange(version, version_given ? version : newest_version);
    const std::optional<double> value = number(tree, node.value, "a version");
    version = before;
    if (!value) return;
    const double rounded = std::floor(100 * *value + 0.5) / 100;
    if (!(rounded >= 1 && rounded <= newest_version)) {
        report(error(
            Fault::out_of_range, tree.span(id),
            message("the language has versions 1 to ", newest_version, ", but this is ", *value)));
        return;
    }
    check_version(tree, id, rounded);
    version = rounded;
    noise->version = rounded;
    version_given = true;
    if (handlers.set_version) handlers.set_version(version, tree.span(id));
}

/// Reports a version whose rules are those of another, or that comes too late in the main file.
void Evaluator::State::check_version(const Tree& tree, NodeId id, double asked) {
    const bool late = !version_given && include_depth == 0 && id != tree.first;
    if (late && asked >= newest_version)
        report(error(Fault::misplaced, tree.span(id),
                     message("`#version ", asked,
                             "` must be the first statement of the scene: what stands before it "
                             "would be read by the rules of an older version"))
                   .with_help("put it above everything but comments"));
    constexpr double before_newest = 3.7;
    if (asked > before_newest && asked < newest_version)
        report(
            warning(Fault::deprecated, tree.span(id),
                    message("`#version ", asked, "` was a name of versions on the way to ",
                            newest_version, "; the scene is read by the rules of ", before_newest))
                .with_help(message("write #version ", newest_version, "; or #version ",
                                   before_newest, ";")));
}

}  // namespace candelabra
