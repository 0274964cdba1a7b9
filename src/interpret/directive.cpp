// SPDX-License-Identifier: GPL-3.0-or-later
// Directives: control of the walk, messages, versions, includes. Declarations are in declare.cpp.
#include "interpret/calls.h"
#include "interpret/expressions.h"
#include "interpret/files.h"
#include "interpret/statements.h"
#include "text/message.h"

#include <cmath>
#include <utility>

namespace candelabra {

Flow Statements::directive(const Tree& tree, NodeId id, const Sink& take) {
    constexpr std::uint64_t each = 80;
    context_.costs.work += each;
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
                context_.report(each);
            context_.stop();
            break;
        case kind<node::While>:
            return loop_while(tree, *std::get_if<node::While>(&content), take);
        case kind<node::For>:
            return loop_for(tree, *std::get_if<node::For>(&content), id, take);
        case kind<node::Switch>:
            return choose(tree, *std::get_if<node::Switch>(&content), take);
        case kind<node::Break>:
            last_break_ = tree.span(id);
            return Flow::broken;
        case kind<node::Macro>:
            context_.calls->define_macro(tree, *std::get_if<node::Macro>(&content), id);
            break;
        case kind<node::Include>:
            return include(tree, *std::get_if<node::Include>(&content), id, take);
        case kind<node::Default>:
            walk(tree, std::get_if<node::Default>(&content)->body,
                 [&](const Element& element) { context_.handlers.set_default(element); });
            break;
        case kind<node::Message>:
            speak(tree, *std::get_if<node::Message>(&content), id);
            break;
        case kind<node::Version>:
            set_version(tree, *std::get_if<node::Version>(&content), id);
            break;
        case kind<node::Open>:
            context_.files->open_file(tree, *std::get_if<node::Open>(&content), id);
            break;
        case kind<node::Close>:
            context_.files->close_file(tree, *std::get_if<node::Close>(&content), id);
            break;
        case kind<node::Read>:
            context_.files->read_values(tree, *std::get_if<node::Read>(&content), id);
            break;
        case kind<node::Write>:
            context_.files->write_values(tree, *std::get_if<node::Write>(&content), id);
            break;
        default:
            break;
    }
    return context_.stopped() ? Flow::stopped : Flow::end;
}

bool Statements::condition(const Tree& tree, NodeId id) {
    if (const auto* test = tree.get_if<node::Defined>(id))
        return context_.calls->defined(tree, test->target) != test->negated;
    const std::optional<double> value = context_.expressions->number(tree, id, "a condition");
    return value && is_true(*value);
}

const node::Branch* Statements::taken_branch(const Tree& tree, const node::If& node) {
    for (NodeId id = node.branches; id != no_node && !context_.stopped(); id = tree[id].next) {
        const auto& branch = tree.get<node::Branch>(id);
        if (branch.condition == no_node || condition(tree, branch.condition)) return &branch;
    }
    return nullptr;
}

Flow Statements::branch(const Tree& tree, const node::If& node, const Sink& take) {
    if (const node::Branch* taken = taken_branch(tree, node)) return walk(tree, taken->body, take);
    return context_.stopped() ? Flow::stopped : Flow::end;
}

Flow Statements::loop_while(const Tree& tree, const node::While& node, const Sink& take) {
    const std::size_t outer = context_.costs.loops.size();
    context_.costs.loops.push_back({&tree, node.condition});
    while (condition(tree, node.condition) && !context_.stopped()) {
        if (context_.costs.too_many_steps(tree, node.condition)) return Flow::stopped;
        ++context_.costs.loops[outer].passes;
        const Flow flow = walk(tree, node.body, take);
        if (flow == Flow::stopped) return flow;
        if (flow == Flow::broken) break;
    }
    context_.costs.loops.resize(outer);
    return context_.stopped() ? Flow::stopped : Flow::end;
}

/// Start, end and step of a loop; nothing if there is no pass, or after a report.
std::optional<std::array<double, 3>> Statements::for_range(const Tree& tree, const node::For& node,
                                                           NodeId id) {
    std::array<double, 3> range = {0, 0, 1};
    std::size_t count = 0;
    for (NodeId value = node.range; value != no_node; value = tree[value].next, ++count) {
        if (count == range.size()) break;
        const std::optional<double> found =
            context_.expressions->number(tree, value,
                                         count == 0   ? "the start of a #for"
                                         : count == 1 ? "the end of a #for"
                                                      : "the step of a #for");
        if (!found) return std::nullopt;
        range[count] = *found;
    }
    if (count < 2) {
        context_.broken(Fault::wrong_count, tree.span(id),
                        "a #for needs a name, a start and an end: #for(i, 1, 10)");
        return std::nullopt;
    }
    if (std::isnan(range[2])) return std::nullopt;  // As in POV-Ray, no pass.
    if (std::abs(range[2]) < tolerance) {
        context_.broken(Fault::out_of_range, tree.span(id),
                        message("the step of this #for is ", range[2], ", so it would not end"));
        return std::nullopt;
    }
    return range;
}

/// The counter of a loop after a pass: the body may have changed it.
std::optional<double> Statements::counter(NameId name, Span span) {
    const Value* now = context_.scope.find(name);
    const Numbers* number = now ? now->numbers() : nullptr;
    if (number && number->is_scalar()) return number->at[0];
    context_.broken(
        Fault::wrong_type, span,
        message("the counter `", context_.names.spelling(name), "` is no number any more"));
    return std::nullopt;
}

Flow Statements::loop_for(const Tree& tree, const node::For& node, NodeId id, const Sink& take) {
    const auto* target = tree.get_if<node::Name>(node.target);
    if (!target) {
        context_.broken(Fault::wrong_type, tree.span(node.target),
                        "a #for counts with a plain name");
        return Flow::end;
    }
    const auto range = for_range(tree, node, id);
    if (!range) return Flow::end;
    const auto [start, end, step] = *range;
    const NameId name = target->name;
    context_.scope.declare_local(name, start);
    if (!(step > 0 ? start < end + tolerance : start > end - tolerance)) return Flow::end;
    double i = start;
    const std::size_t outer = context_.costs.loops.size();
    context_.costs.loops.push_back({&tree, node.range});
    while (step > 0 ? i <= end + tolerance : i >= end - tolerance) {
        if (context_.costs.too_many_steps(tree, id)) return Flow::stopped;
        ++context_.costs.loops[outer].passes;
        const Flow flow = walk(tree, node.body, take);
        if (flow == Flow::stopped) return flow;
        if (flow == Flow::broken) break;
        if (Numbers* number = context_.scope.overwritable(name, true);
            number && number->is_scalar()) {
            i = number->at[0] += step;
            continue;
        }
        const std::optional<double> now = counter(name, tree.span(node.target));
        if (!now) break;
        i = *now + step;
        context_.scope.declare_local(name, i);
    }
    context_.costs.loops.resize(outer);
    return context_.stopped() ? Flow::stopped : Flow::end;
}

Flow Statements::choose(const Tree& tree, const node::Switch& node, const Sink& take) {
    const std::optional<double> subject =
        context_.expressions->number(tree, node.subject, "what #switch looks at");
    if (!subject) return context_.stopped() ? Flow::stopped : Flow::end;
    Flow flow = walk(tree, node.opening, [&](const Element& element) {
        context_.report(error(Fault::misplaced, element.span,
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
                first == no_node ? std::nullopt
                                 : context_.expressions->number(tree, first, "a case");
            const std::optional<double> high =
                second == no_node
                    ? std::nullopt
                    : context_.expressions->number(tree, second, "the end of a range");
            if (first == no_node)
                matched = true;
            else if (second == no_node)
                matched = low && std::abs(*low - *subject) < tolerance;
            else
                matched = low && high && *low <= *subject && *subject <= *high;
        }
        if (matched) flow = walk(tree, part->body, take);
    }
    return flow == Flow::stopped || context_.stopped() ? Flow::stopped : Flow::end;
}

Flow Statements::include(const Tree& tree, const node::Include& node, NodeId id, const Sink& take) {
    const Span span = tree.span(node.file);
    const auto* member = tree.get_if<node::Member>(node.file);
    const auto* bare = tree.get_if<node::Name>(member ? member->operand : node.file);
    const bool angles = tree.get_if<node::Vector>(node.file) != nullptr;
    if (angles || (bare && !context_.scope.find(bare->name))) {
        // All declarations of the file are missing from here on.
        const std::uint32_t sign = angles ? 1 : 0;
        context_.broken(Fault::wrong_type, span,
                        message("the name of a file stands in quotes: #include \"",
                                context_.sources.text(span.source)
                                    .substr(span.first + sign, span.last - span.first - 2 * sign),
                                "\""));
        context_.stop();
        return Flow::stopped;
    }
    const Value file = context_.expressions->evaluate(tree, node.file);
    if (!file.text()) {
        if (!file.broken())
            context_.broken(
                Fault::wrong_type, span,
                message("#include takes the name of a file, but this is ", kind_name(file)));
        return context_.stopped() ? Flow::stopped : Flow::end;
    }
    if (include_depth_ >= context_.costs.limits.include_depth) {
        context_.report(
            error(Fault::recursion_limit, tree.span(id),
                  message("files include each other ", context_.costs.limits.include_depth,
                          " deep, which is the limit"))
                .with_help("a file that includes itself needs an #ifndef that ends it; "
                           "--limit-includes raises the limit"));
        context_.stop();
        return Flow::stopped;
    }
    if (!context_.room(tree, id)) return Flow::stopped;
    const Tree* included = load(*file.text(), span);
    if (!included) return context_.stopped() ? Flow::stopped : Flow::end;
    ++include_depth_;
    context_.scope.enter();
    context_.frames.push({Frame::include, no_name, included->source, span});
    const Flow flow = walk(*included, included->first, take);
    context_.frames.pop();
    context_.scope.leave();
    --include_depth_;
    return flow;
}

const Tree* Statements::load(const std::string& name, Span span) {
    const std::string directory = directory_of(context_.sources.name(span.source));
    if (!context_.costs.count_file(span)) return nullptr;
    const std::optional<Found> found = context_.loader.load(name, directory);
    if (!found) {
        context_.report(context_.loader.problem(name, span, FileKind::include, directory));
        // The declarations of the file are missing from here on, so that more errors would follow
        // from this one.
        context_.stop();
        return nullptr;
    }
    for (const std::string& path : found->passed_over)
        context_.report(warning(Fault::file_access, span, Loader::passed_over(path))
                            .with_help("remove the file, or include it by a path of its own"));
    if (!context_.costs.spend(found->text.size() / 4, span)) return nullptr;
    const FileTrees::Included file = context_.trees.included(*found, span, context_.version);
    if (file.first) {
        context_.frames.push({Frame::include, no_name, file.tree->source, span});
        context_.diagnostics.add_all(file.found);
        context_.frames.pop();
        learn(*file.tree);
        if (file.found.failed()) context_.stop();
    }
    return context_.stopped() ? nullptr : file.tree;
}

void Statements::speak(const Tree& tree, const node::Message& node, NodeId id) {
    const Value value = context_.expressions->evaluate(tree, node.text);
    if (!value.text()) {
        if (!value.broken())
            context_.report(
                error(Fault::wrong_type, tree.span(node.text),
                      message("a message is a string, but this is ", kind_name(value)))
                    .with_help("str(x, 0, 3) and vstr(3, v, \",\", 0, 3) make strings of numbers"));
        return;
    }
    std::string text = *value.text();
    if (!context_.costs.count_said(text.size(), tree.span(id))) return;
    if (node.kind != MessageKind::error && node.kind != MessageKind::warning)
        return context_.handlers.print(text);
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    if (node.kind == MessageKind::warning)
        return context_.report(warning(Fault::user_warning, tree.span(id), text));
    context_.report(error(Fault::user_error, tree.span(id), text));
    context_.stop();
}

void Statements::set_version(const Tree& tree, const node::Version& node, NodeId id) {
    // As in POV-Ray 3.8, the first one may ask for the newest: `#version version;`.
    const double before =
        std::exchange(context_.version, context_.version_given ? context_.version : newest_version);
    const std::optional<double> value = context_.expressions->number(tree, node.value, "a version");
    context_.version = before;
    if (!value) return;
    const double rounded = std::floor(100 * *value + 0.5) / 100;
    if (!(rounded >= 1 && rounded <= newest_version)) {
        context_.report(error(
            Fault::out_of_range, tree.span(id),
            message("the language has versions 1 to ", newest_version, ", but this is ", *value)));
        return;
    }
    check_version(tree, id, rounded);
    context_.version = rounded;
    context_.noise->version = rounded;
    context_.version_given = true;
    if (context_.handlers.set_version)
        context_.handlers.set_version(context_.version, tree.span(id));
}

/// Reports a version whose rules are those of another, or that comes too late in the main file.
void Statements::check_version(const Tree& tree, NodeId id, double asked) {
    const bool late = !context_.version_given && include_depth_ == 0 && id != tree.first;
    if (late && asked >= newest_version)
        context_.report(
            error(Fault::misplaced, tree.span(id),
                  message("`#version ", asked,
                          "` must be the first statement of the scene: what stands before it "
                          "would be read by the rules of an older version"))
                .with_help("put it above everything but comments"));
    constexpr double before_newest = 3.7;
    if (asked > before_newest && asked < newest_version)
        context_.report(
            warning(Fault::deprecated, tree.span(id),
                    message("`#version ", asked, "` was a name of versions on the way to ",
                            newest_version, "; the scene is read by the rules of ", before_newest))
                .with_help(message("write #version ", newest_version, "; or #version ",
                                   before_newest, ";")));
}

}  // namespace candelabra
