// SPDX-License-Identifier: GPL-3.0-or-later
// Compiles `function (a, b) { ... }` to a Formula, and calls it in expressions.
#include "base/transform.h"
#include "formula/internal.h"
#include "interpret/function_compiler.h"
#include "interpret/splines.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

/// The parameters `(a, b)`. Without a list they are x, y, z, the first two also u and v.
std::optional<std::vector<NameId>> Calls::parameters(const Tree& tree, const node::Function& node,
                                                     NodeId id) {
    const auto* one = tree.get_if<node::Group>(node.parameters);
    const auto* several = tree.get_if<node::Tuple>(node.parameters);
    if (!one && !several) {
        context_.broken(
            Fault::wrong_count, tree.span(id),
            "before its body, a function has its parameters in ( ), or the width and height of "
            "a picture");
        return std::nullopt;
    }
    std::vector<NameId> result;
    bool good = true;
    const auto refuse = [&](Fault fault, NodeId place, const std::string& text) {
        context_.broken(fault, tree.span(place), text);
        good = false;
    };
    constexpr std::string_view usable = "xyzuv";
    for (NodeId at = one ? one->content : several->content; at != no_node; at = tree[at].next) {
        const auto* name = tree.get_if<node::Name>(at);
        const auto* word = tree.get_if<node::Constant>(at);
        const NameId parameter = name ? name->name : word ? word->word : no_name;
        const std::string_view spelling =
            parameter == no_name ? std::string_view() : context_.names.spelling(parameter);
        const bool letter =
            word && spelling.size() == 1 && usable.find(spelling[0]) != std::string_view::npos;
        if (!name && !letter)
            refuse(Fault::wrong_type, at, "a parameter is a name");
        else if (name && context_.scope.find(parameter))
            refuse(Fault::redefinition, at,
                   message("`", spelling,
                           "` is declared already; a parameter needs a name of its own"));
        else if (std::find(result.begin(), result.end(), parameter) != result.end())
            refuse(Fault::duplicate, at, message("there are two parameters `", spelling, "`"));
        result.push_back(parameter);
    }
    constexpr std::size_t most = 56;
    if (result.empty() || result.size() > most)
        refuse(Fault::wrong_count, node.parameters,
               message("a function has 1 to ", most, " parameters, but here are ", result.size()));
    return good ? std::optional(result) : std::nullopt;
}

namespace {

/// Whether the function is of the form `function 256, 256 { ... }`.
bool stands_for_picture(const Tree& tree, const node::Function& node) {
    return node.parameters != no_node && !tree.get_if<node::Group>(node.parameters) &&
           !tree.get_if<node::Tuple>(node.parameters) && tree[node.parameters].next != no_node;
}

/// f_noise3d of the scene's generator.
Handle<Formula> noise_formula(std::shared_ptr<const SceneNoise> scene) {
    return make_handle<Formula>(3, 1, [scene](const double* arguments_, double* results) {
        const Vec3 point(arguments_[0], arguments_[1], arguments_[2]);
        results[0] = noise(point, scene->generator());
        return true;
    });
}

}  // namespace

/// Sets the size of the picture that the function stands for. False after a report.
bool Calls::take_size(const Tree& tree, const node::Function& node, Formula& formula) {
    constexpr double most = 16384;
    const NodeId second = tree[node.parameters].next;
    const auto width =
        context_.expressions->number(tree, node.parameters, "the width of a picture");
    const auto height = context_.expressions->number(tree, second, "the height of a picture");
    if (!width || !height) return false;
    if (*width >= 1 && *height >= 1 && *width <= most && *height <= most &&
        tree[second].next == no_node) {
        formula.stand_for(static_cast<int>(*width), static_cast<int>(*height));
        return true;
    }
    context_.broken(
        Fault::out_of_range, tree.span(node.parameters),
        message("a picture made by a function has a width and a height from 1 to ", most));
    return false;
}

/// The function of a body that is a word or block, not an expression. Null after a report.
Handle<Formula> Calls::named_function(const Tree& tree, const node::Function& node, NodeId id) {
    const auto* word = tree.get_if<node::Word>(node.body);
    if (word && context_.names.spelling(word->word) == "internal") {
        const NodeId argument = tree[node.body].next;
        const std::optional<double> number =
            argument == no_node ? std::nullopt
                                : context_.expressions->number(
                                      tree, argument, "the number of an internal function");
        if (!number) return nullptr;
        const auto text = [&] { return message("internal(", *number, ")"); };
        if (*number == noise_function) return with_text(noise_formula(context_.noise), text);
        const InternalFunction* found = internal_function(static_cast<int>(*number));
        if (found && found->number == *number)
            return with_text(make_handle<Formula>(
                                 static_cast<std::size_t>(found->parameters), 1,
                                 [code = found->code](const double* arguments_, double* results) {
                                     results[0] = code(arguments_);
                                     return true;
                                 }),
                             text);
        context_.broken(Fault::out_of_range, tree.span(argument),
                        message("there is no internal function ", *number));
        return nullptr;
    }
    if (node.parameters != no_node && !stands_for_picture(tree, node)) {
        context_.broken(Fault::misplaced, tree.span(node.parameters),
                        "a function of this kind has the parameters that it has; leave these out");
        return nullptr;
    }
    return block_function(tree, node.body, id);
}

/// Whether the directives and macros of a list may give a block: `function { M() }`, where M gives
/// `pigment { ... }`.
bool Calls::may_give_block(const Tree& tree, NodeId first, int depth) const {
    constexpr int deepest = 50;
    if (depth > deepest) return false;
    const auto within = [&](NodeId list) { return may_give_block(tree, list, depth + 1); };
    const auto any = [&](NodeId parts, auto body) {
        for (NodeId id = parts; id != no_node; id = tree[id].next)
            if (within(body(id))) return true;
        return false;
    };
    for (NodeId id = first; id != no_node; id = tree[id].next) {
        if (tree.get_if<node::Block>(id)) return true;
        const auto* call = macro_call(tree, id);
        const Value* macro = call ? context_.scope.find(call->name) : nullptr;
        if (macro && macro->macro()) {
            const Body& body = macro->macro()->body;
            if (may_give_block(*body.tree, body.first, depth + 1)) return true;
        }
        if (const auto* condition = tree.get_if<node::If>(id))
            if (any(condition->branches, [&](NodeId part) {
                    const auto* branch = tree.get_if<node::Branch>(part);
                    return branch ? branch->body : no_node;
                }))
                return true;
        if (const auto* choice = tree.get_if<node::Switch>(id))
            if (any(choice->cases, [&](NodeId part) {
                    const auto* one = tree.get_if<node::Case>(part);
                    return one ? one->body : no_node;
                }))
                return true;
        const auto* loop = tree.get_if<node::For>(id);
        const auto* turns = tree.get_if<node::While>(id);
        if ((loop && within(loop->body)) || (turns && within(turns->body))) return true;
    }
    return false;
}

/// `function { transform { ... } }`, or one of a spline, pattern or pigment.
Handle<Formula> Calls::block_function(const Tree& tree, NodeId body, NodeId id) {
    Handle<Formula> result;
    bool one = false;
    context_.statements->walk(tree, body, [&](const Element& element) {
        if (one)
            context_.broken(Fault::wrong_count, element.span,
                            "a function is one block, and this is another");
        else
            result = element_formula(element);
        one = true;
    });
    if (!one && !context_.stopped())
        context_.broken(Fault::missing, tree.span(id), "a function is one block, but here is none");
    return result;
}

Handle<Formula> Calls::element_formula(const Element& element) {
    const bool block = element.kind == Element::Kind::block;
    const std::string_view word =
        block ? context_.names.spelling(element.word) : std::string_view();
    if (word != "transform" && word != "spline" && word != "pigment" && word != "pattern") {
        if (element.kind != Element::Kind::value || !element.value.broken())
            context_.broken(
                Fault::wrong_type, element.span,
                "a function is an expression, or one of transform, spline, pattern, pigment, "
                "internal");
        return nullptr;
    }
    if (word == "pattern" || word == "pigment") return context_.handlers.function(element);
    const Value value = context_.handlers.value({&element, 1});
    if (const auto spline = value.handle<Spline>())
        return with_text(spline_formula(spline), [&] { return spline_text(*spline); });
    const auto transform = value.handle<Transform>();
    if (!transform) return nullptr;
    const auto moved = [transform](const double* in, double* out) {
        const Vec3 place = transform->point(Vec3(in[0], in[1], in[2]));
        for (int i = 0; i < 3; ++i) out[i] = place[i];
        return true;
    };
    return with_text(make_handle<Formula>(3, 3, moved), [&] {
        std::string text = "transform { matrix <";
        const auto& map = transform->forward();
        for (const Vec3& row : {map.rows[0], map.rows[1], map.rows[2], map.translation})
            for (int i = 0; i < 3; ++i) text += message(text.ends_with('<') ? "" : ", ", row[i]);
        return text + "> }";
    });
}

Handle<Formula> Calls::written_function(const Tree& tree, const node::Function& node, NodeId id) {
    constexpr std::uint64_t compiling = 1'000;
    if (!context_.costs.spend(compiling, tree.span(id))) return nullptr;
    FunctionCompiler compiler(context_);
    const bool listed = node.parameters != no_node && !stands_for_picture(tree, node);
    if (listed) {
        const auto given = parameters(tree, node, id);
        if (!given) return nullptr;
        for (const NameId name : *given) compiler.add_parameter(name);
    } else {
        for (const std::string_view name : {"x", "y", "z"})
            compiler.add_parameter(context_.names.find(name));
        compiler.locals.push_back({context_.names.find("u"), compiler.locals[0].second});
        compiler.locals.push_back({context_.names.find("v"), compiler.locals[1].second});
    }
    constexpr std::size_t usual = 3;
    compiler.name_parameters(listed ? compiler.locals.size() : usual, listed);
    const auto result = compiler.body(tree, node.body, tree.span(id));
    if (!result) return nullptr;
    if (!compiler.builder.fits()) {
        context_.broken(Fault::out_of_range, tree.span(id), "this function is too long");
        return nullptr;
    }
    FormulaText text = compiler.whole_text(*result);
    Handle<Formula> made = make_handle<Formula>(compiler.builder.finish({&*result, 1}));
    if (FunctionTexts::kept()) FunctionTexts::kept()->keep(made, std::move(text));
    if (!context_.costs.may_be_costly(*made, tree.span(id))) return nullptr;
    if (made->depth() <= Formula::max_depth) return made;
    context_.report(error(Fault::recursion_limit, tree.span(id),
                          message("functions call each other more than ", Formula::max_depth,
                                  " deep, which is the limit"))
                        .with_help("it cannot be raised: write some of them out, or compute a part "
                                   "beforehand"));
    return nullptr;
}

Value Calls::function(const Tree& tree, const node::Function& node, NodeId id) {
    const bool has_parameters = node.parameters != no_node && !stands_for_picture(tree, node);
    const bool named = tree.get_if<node::Word>(node.body) || tree.get_if<node::Block>(node.body) ||
                       (!has_parameters && may_give_block(tree, node.body));
    Handle<Formula> made =
        named ? named_function(tree, node, id) : written_function(tree, node, id);
    if (made && stands_for_picture(tree, node)) {
        const Handle<Formula> sizeless = made;
        if (!take_size(tree, node, made.edit())) return Absence::broken;
        FunctionTexts* const texts = FunctionTexts::kept();
        if (const FormulaText* text = texts ? texts->find(sizeless.get()) : nullptr)
            texts->keep(made, FormulaText(*text));
    }
    return made ? Value(std::move(made)) : Value(Absence::broken);
}

bool Calls::check_count(NameId function, std::size_t count, const Formula& formula, Span span) {
    if (count == formula.parameters()) return true;
    context_.broken(
        Fault::wrong_count, span,
        message("function `", context_.names.spelling(function), "` takes ", formula.parameters(),
                formula.parameters() == 1 ? " argument" : " arguments", ", but here ",
                count == 1 ? "is " : "are ", count));
    return false;
}

Value Calls::call_formula(const Tree& tree, Handle<Formula> formula, NameId name, NodeId first,
                          Span span) {
    std::vector<double> values;
    bool good = true;
    walk_arguments(tree, first, [&](const Value& value, Span place) {
        const Numbers* numbers = value.numbers();
        const bool scalar = numbers && numbers->is_scalar();
        if (!scalar && !value.broken())
            context_.broken(Fault::wrong_type, place,
                            message("`", context_.names.spelling(name),
                                    "` takes numbers, but this is ", kind_name(value)));
        good = good && scalar;
        values.push_back(scalar ? numbers->at[0] : 0);
    });
    if (!good || context_.stopped() || !check_count(name, values.size(), *formula, span))
        return Absence::broken;
    Numbers result;
    result.count = static_cast<int>(formula->results());
    const bool good_call = formula->run(values.data(), result.at.data());
    if (!context_.costs.spend(formula->cost(), span)) return Absence::broken;
    if (good_call) return result;
    return context_.broken(Fault::loop_limit, span,
                           message("`", context_.names.spelling(name),
                                   "` gives no value here: a sum in it does not end"));
}

/// Calls S(t) or S(t, natural_spline).
Value Calls::call_spline(const Tree& tree, Handle<Spline> spline, NameId name, NodeId first,
                         Span span) {
    Spline::Kind kind = spline->kind();
    const NodeId second = first == no_node ? no_node : tree[first].next;
    const auto* word = tree.get_if<node::Word>(second);
    const auto other = word ? spline_kind(context_.names.spelling(word->word)) : std::nullopt;
    if (first == no_node || (second != no_node && (!other || tree[second].next != no_node))) {
        context_.report(
            error(Fault::wrong_count, span,
                  message("spline `", context_.names.spelling(name), "` takes one number"))
                .with_help("a word may follow: linear_spline, quadratic_spline, cubic_spline, "
                           "natural_spline"));
        return Absence::broken;
    }
    if (other) kind = *other;
    const std::optional<double> t =
        context_.expressions->number(tree, first, "the argument of", name);
    if (!t) return Absence::broken;
    return Numbers{spline->at(*t, kind), static_cast<int>(spline->components())};
}

}  // namespace candelabra
