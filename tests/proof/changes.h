// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of scripts that laws are made of.
#pragma once

#include "proof/law.h"

namespace candelabra::proof {

/// Whether the element stands for an object or a light of the scene.
bool is_object(const Element&);

/// The script with another setting in its global_settings: "integrator", "path_traced bounces 3".
Script with_setting(Script, std::string head, std::string text);
Script without_setting(Script, std::string_view head);

/// The script with this at the end of all of its objects, lights and cameras.
Script transformed(Script, const std::string& transformation);

/// The picture of the script as one sum.
std::vector<Term> picture(const Script&, const Writing& = {}, double factor = 1);

/// A claim that both pictures have the same mean.
Claim same_mean(std::string name, std::vector<Term> left, std::vector<Term> right,
                double tolerance = 2e-3);
/// The same where the right picture finds light by chance.
Claim same_by_chance(std::string name, std::vector<Term> left, std::vector<Term> right,
                     double tolerance = 2e-3);
/// A claim that both pictures have the same bytes, but for the tolerance as a share of each pixel.
Claim same_bytes(std::string name, std::vector<Term> left, std::vector<Term> right,
                 double tolerance = 0);

/// The element with models that have no looks in their files.
Element with_plain_models(Element);

/// The whole of the text with every match of a regular expression replaced.
Element replaced(Element, const std::string& expression, const std::string& by);

/// The element without sets of a formula, and of few iterations: as in POV-Ray, these fill space, and
/// a place in one may be outside of it for a ray.
Element with_closed_sets(Element);

}  // namespace candelabra::proof
