// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/sample_rule.h"

#include <type_traits>

namespace candelabra {

namespace {

template <SampleRuleKind... Kinds>
SampleRule first_chosen(const RuleChoice& choice, std::type_identity<std::variant<Kinds...>>) {
    std::optional<SampleRule> rule;
    (void)((rule = Kinds::chosen(choice)).has_value() || ...);
    return *rule;
}

}  // namespace

SampleRule choose_rule(const RuleChoice& choice) {
    return first_chosen(choice, std::type_identity<SampleRule>());
}

}  // namespace candelabra
