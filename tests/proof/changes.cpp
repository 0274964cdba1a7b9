// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/changes.h"

#include "bind/blocks.h"
#include "proof/items.h"
#include "vocabulary/reserved.h"

#include <algorithm>
#include <regex>

namespace candelabra::proof {

bool is_object(const Element& element) {
    const auto models = items_of("Models");
    if (std::ranges::any_of(models, [&](const ItemInfo* m) { return m->name == element.head; }))
        return true;
    const NameId word = reserved_word(element.head);
    return word != no_name && block_table().makes_object(word);
}

Script with_setting(Script script, std::string head, std::string text) {
    replace_part(element_of(script, "global_settings"), block(std::move(head), std::move(text)));
    return script;
}

Script without_setting(Script script, std::string_view head) {
    std::erase_if(element_of(script, "global_settings").inner,
                  [&](const Element& each) { return each.head == head; });
    return script;
}

Script transformed(Script script, const std::string& transformation) {
    for (Element& each : script.elements)
        if (is_object(each) || each.head == "camera") each.inner.push_back(words(transformation));
    return script;
}

std::vector<Term> picture(const Script& script, const Writing& writing, double factor) {
    return {{written(script, writing), factor, script.options}};
}

Claim same_mean(std::string name, std::vector<Term> left, std::vector<Term> right,
                double tolerance) {
    Claim claim{std::move(name), std::move(left), std::move(right)};
    claim.tolerance = tolerance;
    return claim;
}

Claim same_by_chance(std::string name, std::vector<Term> left, std::vector<Term> right,
                     double tolerance) {
    Claim claim = same_mean(std::move(name), std::move(left), std::move(right), tolerance);
    claim.by_chance = true;
    return claim;
}

Claim same_bytes(std::string name, std::vector<Term> left, std::vector<Term> right,
                 double tolerance) {
    Claim claim{std::move(name), std::move(left), std::move(right)};
    claim.bound = Bound::bytes;
    claim.tolerance = tolerance;
    return claim;
}

Element with_plain_models(Element element) {
    if (element.head == "model") element.values = "file \"gem.obj\"";
    for (Element& each : element.inner) each = with_plain_models(std::move(each));
    return element;
}

Element replaced(Element element, const std::string& expression, const std::string& by) {
    element.values = std::regex_replace(element.values, std::regex(expression), by);
    for (Element& each : element.inner) each = replaced(std::move(each), expression, by);
    return element;
}

Element with_closed_sets(Element element) {
    if (element.head == "julia_fractal")
        element = replaced(std::move(element),
                           R"(hypercomplex (?!max_iteration|precision|slice)\w+( *<[^>]*>)?)",
                           "hypercomplex sqr");
    if (element.head == "julia_fractal")
        element = replaced(std::move(element), R"(max_iteration [0-9]\b)", "max_iteration 20");
    for (Element& each : element.inner) each = with_closed_sets(std::move(each));
    return element;
}

}  // namespace candelabra::proof
