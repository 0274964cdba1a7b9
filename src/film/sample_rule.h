// SPDX-License-Identifier: GPL-3.0-or-later
// The sample rules, as alternatives of a variant. The first that is chosen for a picture counts.
#pragma once

#include "film/blur_rule.h"
#include "film/contrast_rule.h"
#include "film/corner_rule.h"
#include "film/noise_rule.h"

#include <variant>

namespace candelabra {

using SampleRule = std::variant<BlurRule, ContrastRule, CornerRule, NoiseRule>;

/// Returns the rule for a picture.
SampleRule choose_rule(const RuleChoice&);

/// What decides how many samples pixels get beyond those of the first round.
inline DecidedBy decided_by(const RenderSettings& settings, const SampleRule& rule) {
    return std::visit([&](const auto& each) { return each.decided_by(settings); }, rule);
}

/// Whether the settings and the rule give all pixels exactly the requested number of samples.
inline bool is_even(const RenderSettings& settings, const SampleRule& rule = NoiseRule()) {
    return decided_by(settings, rule) == DecidedBy::settings;
}

}  // namespace candelabra
