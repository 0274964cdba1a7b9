// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/compiler.h"

#include "interpret/expressions.h"

#include "base/transform.h"
#include "interpret/splines.h"

#include <algorithm>

namespace candelabra {

namespace {

/// Maximum nesting of compiled expressions: compiling takes stack. Deeper ones are walked.
constexpr int max_depth = 500;

}  // namespace

OperatorCode operations_of(Operator sign) {
    using enum Operation;
    constexpr auto codes = std::array<OperatorCode, 12>{{
        {add, add},
        {subtract, subtract},
        {multiply, multiply},
        {divide_unless, divide},
        {less, less},
        {about_less_equal, less_equal},
        {about_equal, equal},
        {about_not_equal, not_equal},
        {about_greater_equal, greater_equal},
        {greater, greater},
        {true_both, both},
        {true_either, either},
    }};
    return codes[static_cast<std::size_t>(sign)];
}

Code* Expressions::compile(const Tree& tree, NodeId id) {
    Code code;
    ExpressionCompiler compiler(context_, codes_, tree, code);
    const Operands result = compiler.compile(id);
    if (result.count == 0 || !compiler.builder.fits()) return nullptr;
    code.program = compiler.builder.finish({result.at.data(), result.count});
    code.cost = cost(code.program);
    code.registers.resize(code.program.registers);
    code.program.prepare(code.registers.data());
    return codes_.keep(tree, id, std::move(code));
}

Operands ExpressionCompiler::compile(NodeId id) {
    if (++depth > max_depth) return {};
    const NodeContent& content = tree[id].content;
    const auto compiled = [&]() -> Operands {
        switch (content.index()) {
            case kind<node::Number>:
                return numbers({&tree.numbers[std::get_if<node::Number>(&content)->number], 1});
            case kind<node::Literal>: {
                const auto& literal = *std::get_if<node::Literal>(&content);
                return numbers({&tree.numbers[literal.first_number], literal.count});
            }
            case kind<node::Name>:
                return name(std::get_if<node::Name>(&content)->name);
            case kind<node::Index>:
                return index(*std::get_if<node::Index>(&content));
            case kind<node::Constant>:
                return constant(std::get_if<node::Constant>(&content)->word);
            case kind<node::Unary>:
                return unary(*std::get_if<node::Unary>(&content));
            case kind<node::Binary>:
                return binary(*std::get_if<node::Binary>(&content));
            case kind<node::Choice>:
                return choice(*std::get_if<node::Choice>(&content));
            case kind<node::Group>: {
                const NodeId only = std::get_if<node::Group>(&content)->content;
                return only == no_node || tree[only].next != no_node ? never() : compile(only);
            }
            case kind<node::Vector>:
                return vector(*std::get_if<node::Vector>(&content));
            case kind<node::Member>:
                return member(*std::get_if<node::Member>(&content));
            case kind<node::Prefixed>:
                return prefixed(*std::get_if<node::Prefixed>(&content));
            case kind<node::Call>:
                return call(*std::get_if<node::Call>(&content));
            default:
                return never();
        }
    }();
    --depth;
    // No node around such a node can be compiled either, so none is tried again.
    if (hopeless) codes.exclude(tree, id);
    return compiled;
}

Operands ExpressionCompiler::never() {
    hopeless = true;
    return {};
}

Operands ExpressionCompiler::numbers(std::span<const double> values) {
    Operands result;
    for (const double value : values) result.at[result.count++] = builder.constant(value);
    return result;
}

Operands ExpressionCompiler::name(NameId name) {
    for (const auto& [known, operands] : loaded)
        if (known == name) return operands;
    if (context.deprecated.contains(name)) return {};
    const Value* found = context.scope.find(name);
    const Numbers* numbers = found ? found->numbers() : nullptr;
    if (!numbers) return {};
    Operands result;
    result.count = static_cast<std::size_t>(numbers->count);
    for (std::size_t i = 0; i < result.count; ++i) result.at[i] = builder.input();
    const auto first = static_cast<std::uint16_t>(result.at[0]);  // inputs are the first registers
    code.inputs.push_back({name, first, static_cast<std::uint16_t>(result.count)});
    loaded.push_back({name, result});
    return result;
}

Operands ExpressionCompiler::constant(NameId word) {
    const std::string_view name = context.names.spelling(word);
    if (name == "version" || name == "now") return never();  // they change
    const Value value = context.expressions->constant(word);
    return numbers({value.numbers()->at.data(), static_cast<std::size_t>(value.numbers()->count)});
}

Operands ExpressionCompiler::promoted(const Operands& operands, std::size_t count) {
    if (operands.count != 1) return with_zeros(operands, count);
    Operands result;
    while (result.count < count) result.at[result.count++] = operands.at[0];
    return result;
}

Operands ExpressionCompiler::with_zeros(const Operands& operands, std::size_t count) {
    Operands result = operands;
    while (result.count < count) result.at[result.count++] = builder.constant(0);
    return result;
}

void ExpressionCompiler::release(const Operands& operands) {
    for (std::size_t i = 0; i < operands.count; ++i) builder.release(operands.at[i]);
}

void ExpressionCompiler::refuse_unless(Operand condition) {
    const Operand opposite = builder.emit(Operation::equal, condition, builder.constant(0));
    builder.refuse(opposite);
    builder.release(opposite);
    builder.release(condition);
}

Operands ExpressionCompiler::unary(const node::Unary& node) {
    const Operands operand = compile(node.operand);
    if (operand.count == 0 || node.sign == Operator::plus) return operand;
    const Operation operation =
        node.sign == Operator::minus ? Operation::negate : Operation::not_true;
    Operands result;
    for (; result.count < operand.count; ++result.count)
        result.at[result.count] = builder.emit(operation, operand.at[result.count]);
    release(operand);
    return result;
}

Operands ExpressionCompiler::binary(const node::Binary& node) {
    const Operands left = compile(node.left);
    if (left.count == 0) return {};
    const Operands right = compile(node.right);
    if (right.count == 0) return {};
    const std::size_t count = std::max(left.count, right.count);
    const Operands a = promoted(left, count), b = promoted(right, count);
    const Operation operation = operations_of(node.sign).tolerant;
    Operands result;
    for (; result.count < count; ++result.count) {
        const Operand x = a.at[result.count], y = b.at[result.count];
        result.at[result.count] = operation == Operation::divide_unless
                                      ? builder.divide_unless(x, y)
                                      : builder.emit(operation, x, y);
    }
    release(left);
    release(right);
    return result;
}

/// Only one of the branches gives the value, but random streams advance as if both were computed,
/// the first before the second.
Operands ExpressionCompiler::choice(const node::Choice& node) {
    const Operands condition = compile(node.condition);
    if (condition.count != 1) return {};
    const std::size_t to_no = builder.jump_unless(condition.at[0]);
    release(condition);
    const Operands yes = compile(node.yes);
    if (yes.count == 0 || !draw(node.no)) return {};
    Operands result;
    for (; result.count < yes.count; ++result.count) {
        result.at[result.count] = builder.variable();
        builder.assign(result.at[result.count], yes.at[result.count]);
    }
    release(yes);
    const std::size_t to_end = builder.jump();
    builder.land(to_no);
    if (!draw(node.yes)) return {};
    const Operands no = compile(node.no);
    if (no.count != result.count) return {};
    for (std::size_t i = 0; i < no.count; ++i) builder.assign(result.at[i], no.at[i]);
    release(no);
    builder.land(to_end);
    return result;
}

bool ExpressionCompiler::draw(NodeId id) {
    for (const NodeId call : context.expressions->random_calls(tree, id)) {
        const Operands drawn = compile(call);
        if (drawn.count == 0) return false;
        release(drawn);
    }
    return true;
}

Operands ExpressionCompiler::vector(const node::Vector& node) {
    Operands result;
    for (NodeId id = node.components; id != no_node; id = tree[id].next) {
        const Operands component = compile(id);
        if (component.count != 1) return {};
        if (result.count == result.at.size()) return never();
        result.at[result.count++] = component.at[0];
    }
    return result.count < 2 ? never() : result;
}

Operands ExpressionCompiler::member(const node::Member& node) {
    const int part = component_of(context.names.spelling(node.member));
    if (part < 0) return never();
    const Operands operand = compile(node.operand);
    if (operand.count == 0) return {};
    if (part == grey_component) {
        const Operand grey = dot(numbers(grey_weights), with_zeros(operand, 3));
        release(operand);
        return Operands::one(grey);
    }
    if (part >= static_cast<int>(operand.count)) return {};
    const Operand result = operand.at[static_cast<std::size_t>(part)];
    for (std::size_t i = 0; i < operand.count; ++i)
        if (operand.at[i] != result) builder.release(operand.at[i]);
    return Operands::one(result);
}

Operands ExpressionCompiler::prefixed(const node::Prefixed& node) {
    const std::string_view prefix = context.names.spelling(node.prefix);
    if (prefix.starts_with("s")) return never();  // sRGB needs more than arithmetic
    const std::string_view form = prefix.substr(3);
    const std::size_t wanted = form.empty() ? 3 : form == "ft" ? 5 : 4;
    const Operands given = compile(node.operand);
    if (given.count != 1 && given.count != wanted) return {};
    Operands result = with_zeros(promoted(given, wanted), 5);
    if (form == "t") std::swap(result.at[3], result.at[4]);
    return result;
}

Operands ExpressionCompiler::call(const node::Call& node) {
    if (!context.names.reserved(node.name)) {
        const Value* found = context.scope.find(node.name);
        if (!found) return {};
        Handle<Formula> formula = found->handle<Formula>();
        if (const auto spline = found->handle<Spline>()) formula = spline_formula(spline);
        if (!formula) return never();  // nearly always a macro
        code.callees.push_back({node.name, found->shared_place()});
        return call_formula(std::move(formula), node.arguments);
    }
    const std::string_view name = context.names.spelling(node.name);
    if (const auto function = function_number(name)) return of_one(name, *function, node.arguments);
    if (name == "rand") return random(node.arguments);
    if (name.starts_with("dimension")) return array_size(name, node.arguments);
    if (name == "trace" || name == "inside") return of_object(name, node.arguments);
    if (name.starts_with("v") && name != "val" && name != "vstr" && name != "vturbulence")
        return of_vectors(name, node.arguments);
    return of_numbers(name, node.arguments);
}

/// Compiles arguments that are single numbers.
bool ExpressionCompiler::scalars(NodeId first, std::vector<Operand>& result) {
    for (NodeId id = first; id != no_node; id = tree[id].next) {
        const Operands operand = compile(id);
        if (operand.count != 1) return false;
        result.push_back(operand.at[0]);
    }
    return true;
}

Operands ExpressionCompiler::call_program(Handle<Formula> formula,
                                          std::span<const Operand> arguments) {
    Operands result;
    result.count = formula->results();
    const Operand first = builder.call(std::move(formula), arguments);
    for (std::size_t i = 0; i < result.count; ++i)
        result.at[i] = ProgramBuilder::following(first, i);
    for (const Operand argument : arguments) builder.release(argument);
    return result;
}

Operands ExpressionCompiler::call_formula(Handle<Formula> formula, NodeId arguments) {
    std::vector<Operand> values;
    if (!scalars(arguments, values) || values.size() != formula->parameters()) return {};
    return call_program(std::move(formula), values);
}

Operands ExpressionCompiler::random(NodeId arguments) {
    std::vector<Operand> stream;
    if (!scalars(arguments, stream) || stream.size() != 1) return {};
    code.random = true;
    const auto next = [&streams = context.world.random](const double* in, double* out) {
        if (!streams.known(in[0])) return false;
        out[0] = streams.attempt(static_cast<std::size_t>(in[0]));
        return true;
    };
    return native(1, next, stream);
}

/// trace() and inside() of a named object.
Operands ExpressionCompiler::of_object(std::string_view name, NodeId arguments) {
    const auto* object = tree.get_if<node::Name>(arguments);
    if (!object || !context.world.objects || !context.deprecated.empty()) return never();
    const bool traces = name == "trace";
    std::vector<Operand> vectors;
    NodeId id = tree[arguments].next;
    for (std::size_t i = 0; i < (traces ? 2u : 1u); ++i, id = tree[id].next) {
        if (id == no_node) return never();
        const Operands given = compile(id);
        if (given.count != 1 && given.count != 3) return {};
        const Operands vector = promoted(given, 3);
        vectors.insert(vectors.end(), vector.at.begin(), vector.at.begin() + 3);
    }
    if (traces) {
        const auto* normal = tree.get_if<node::Name>(id);
        // A call that sets a variable must come last, so that it need not be undone.
        const bool fits = id == no_node || (normal && tree[id].next == no_node && depth == 1);
        return fits ? trace(object->name, normal ? normal->name : no_name, vectors) : never();
    }
    if (id != no_node) return never();
    const auto inside = [&context = context, object = object->name](const double* in, double* out) {
        const Value* value = context.scope.find(object);
        const Handle<Object> content = value ? value->handle<Object>() : nullptr;
        if (!content) return false;
        const Vec3 point(in[0], in[1], in[2]);
        const std::optional<bool> answer =
            context.world.objects->inside(content, point, context.costs.work);
        if (answer) out[0] = *answer;
        return answer.has_value();
    };
    return native(1, inside, vectors);
}

Operands ExpressionCompiler::trace(NameId object, NameId normal, std::span<const Operand> ray) {
    const auto first_hit = [&context = context, object, normal](const double* in, double* out) {
        const Value* value = context.scope.find(object);
        const Handle<Object> content = value ? value->handle<Object>() : nullptr;
        const Vec3 from(in[0], in[1], in[2]), direction(in[3], in[4], in[5]);
        Numbers* const target =
            normal == no_name ? nullptr : context.scope.overwritable(normal, false);
        if (!content || direction == Vec3(0) || (normal != no_name && !target)) return false;
        const auto hit =
            context.world.objects->first_hit(content, from, direction, context.costs.work);
        if (target) *target = Numbers::vector(hit ? hit->normal : Vec3(0));
        for (int i = 0; i < 3; ++i) out[i] = hit ? hit->position[i] : 0;
        return true;
    };
    return native(3, first_hit, ray);
}

/// Compiles the indices of an element. The last may be one of the array's current names.
bool ExpressionCompiler::indices_of(const ArrayData& now, NodeId first,
                                    std::vector<Operand>& result, bool& named) {
    NodeId last = first;
    while (tree[last].next != no_node) last = tree[last].next;
    const auto* const text = tree.get_if<node::Text>(last);
    if (!text) return scalars(first, result);
    for (NodeId id = first; id != last; id = tree[id].next) {
        const Operands operand = compile(id);
        if (operand.count != 1) return false;
        result.push_back(operand.at[0]);
    }
    const auto place = now.names() ? now.names()->find(tree.texts[text->text]) : std::nullopt;
    named = place.has_value();
    if (named) result.push_back(builder.constant(*place));
    return named;
}

/// An element of an array of numbers with as many components as its elements have now.
Operands ExpressionCompiler::index(const node::Index& node) {
    const Value* found = context.scope.find(node.name);
    const ArrayData* now = found ? found->array() : nullptr;
    std::vector<Operand> indices;
    bool named = false;
    if (!now) return {};
    if (!indices_of(*now, node.indices, indices, named)) return {};
    const auto names = named ? now->names() : nullptr;
    if (now->max_numbers() == 0 || now->sizes().size() != indices.size()) return {};
    const int count = now->count(0) > 0 ? now->count(0) : now->max_numbers();
    const auto element = [&scope = context.scope, name = node.name, rank = indices.size(), count,
                          names](const double* in, double* out) {
        const Value* value = scope.find(name);
        const ArrayData* array = value ? value->array() : nullptr;
        if (!array || array->sizes().size() != rank) return false;
        if (names && array->names() != names) return false;
        std::size_t at = 0;
        for (std::size_t i = 0; i < rank; ++i) {
            const int size = array->sizes()[i];
            const double whole = in[i] + tolerance;
            if (!(whole >= 0 && whole < size)) return false;
            at = at * static_cast<std::size_t>(size) + static_cast<std::size_t>(whole);
        }
        if (array->count(at) != count) return false;
        std::copy_n(array->numbers(at), count, out);
        return true;
    };
    return native(static_cast<std::size_t>(count), element, indices);
}

Operands ExpressionCompiler::array_size(std::string_view name, NodeId arguments) {
    const auto* array = tree.get_if<node::Name>(arguments);
    if (!array) return never();
    std::vector<Operand> dimension;
    if (!scalars(tree[arguments].next, dimension)) return {};
    if (dimension.size() != (name == "dimensions" ? 0 : 1)) return {};
    const auto size = [&scope = context.scope, array = array->name, all = dimension.empty()](
                          const double* in, double* out) {
        const Value* value = scope.find(array);
        if (!value || !value->array()) return false;
        const std::vector<int>& sizes = value->array()->sizes();
        const auto count = static_cast<double>(sizes.size());
        const bool inside = !all && in[0] >= 1 && in[0] <= count;
        out[0] = all ? count : inside ? sizes[static_cast<std::size_t>(in[0]) - 1] : 0;
        return true;
    };
    return native(1, size, dimension);
}

/// Refuses arguments outside of the function's domain: they are reported when it is walked.
void ExpressionCompiler::refuse_outside(std::string_view function, Operand x) {
    const Operand zero = builder.constant(0);
    if (function == "sqrt") refuse_unless(builder.emit(Operation::greater_equal, x, zero));
    if (function == "ln" || function == "log")
        refuse_unless(builder.emit(Operation::greater, x, zero));
    if (function == "asin" || function == "acos") {
        refuse_unless(builder.emit(Operation::less_equal, x, builder.constant(1)));
        refuse_unless(builder.emit(Operation::greater_equal, x, builder.constant(-1)));
    }
}

Operands ExpressionCompiler::of_one(std::string_view name, std::uint16_t function,
                                    NodeId arguments) {
    std::vector<Operand> values;
    if (!scalars(arguments, values) || values.size() != 1) return {};
    refuse_outside(name, values[0]);
    const Operand result = builder.apply(function, values[0]);
    builder.release(values[0]);
    return Operands::one(result);
}

Operands ExpressionCompiler::of_numbers(std::string_view name, NodeId arguments) {
    const bool extreme = name == "min" || name == "max";
    const auto two = operation_of_two(name);
    if (!extreme && name != "select" && !two) return never();
    std::vector<Operand> values;
    if (!scalars(arguments, values)) return {};
    if (extreme && !values.empty())
        return Operands::one(
            builder.fold(name == "min" ? Operation::least : Operation::greatest, values));
    if (name == "select" && (values.size() == 3 || values.size() == 4))
        return Operands::one(builder.select(values));
    if (!two || values.size() != 2) return {};
    // atan2(0, 0) and pow(0, 0) are errors.
    if (name == "atan2") refuse_unless(builder.emit(Operation::true_either, values[0], values[1]));
    if (name == "pow") refuse_unless(builder.emit(Operation::either, values[0], values[1]));
    return Operands::one(builder.fold(*two, values));
}

ProgramBuilder::Operand ExpressionCompiler::dot(const Operands& a, const Operands& b) {
    std::array<Operand, 3> products;
    for (std::size_t i = 0; i < products.size(); ++i)
        products[i] = builder.emit(Operation::multiply, a.at[i], b.at[i]);
    return builder.fold(Operation::add, products);
}

Operands ExpressionCompiler::of_two_vectors(std::string_view name, const Operands& a,
                                            const Operands& b) {
    if (name == "vdot") return Operands::one(dot(a, b));
    Operands result;
    if (name == "vcross") {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
            const std::array products = {builder.emit(Operation::multiply, a.at[i], b.at[j]),
                                         builder.emit(Operation::multiply, b.at[i], a.at[j])};
            result.at[result.count++] = builder.fold(Operation::subtract, products);
        }
        return result;
    }
    const auto rotate = [](const double* in, double* out) {
        const Vec3 turned =
            Transform::rotation(Vec3(in[3], in[4], in[5])).direction(Vec3(in[0], in[1], in[2]));
        for (int i = 0; i < 3; ++i) out[i] = turned[i];
        return true;
    };
    const std::array arguments = {a.at[0], a.at[1], a.at[2], b.at[0], b.at[1], b.at[2]};
    return native(3, rotate, arguments);
}

Operands ExpressionCompiler::of_vectors(std::string_view name, NodeId arguments) {
    std::vector<Operands> given, values;
    for (NodeId id = arguments; id != no_node; id = tree[id].next) {
        given.push_back(compile(id));
        if (given.back().count == 0 || given.back().count > 3) return {};
        values.push_back(promoted(given.back(), 3));
    }
    const bool of_two = name == "vdot" || name == "vcross" || name == "vrotate";
    if (!of_two && name != "vlength" && name != "vnormalize") return never();
    if (values.size() != (of_two ? 2 : 1)) return {};
    Operands result;
    if (of_two) {
        result = of_two_vectors(name, values[0], values[1]);
    } else {
        const Operand squared = dot(values[0], values[0]);
        const Operand length = builder.apply(*function_number("sqrt"), squared);
        builder.release(squared);
        // The zero vector has no direction, which is reported.
        if (name == "vnormalize")
            while (result.count < 3) {
                result.at[result.count] = builder.divide_unless(values[0].at[result.count], length);
                ++result.count;
            }
        if (name == "vnormalize")
            builder.release(length);
        else
            result = Operands::one(length);
    }
    for (const Operands& operands : given) release(operands);
    return result;
}

}  // namespace candelabra
