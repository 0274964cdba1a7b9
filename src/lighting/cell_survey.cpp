// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/cell_survey.h"

#include "lighting/cut_calibration.h"
#include "lighting/cut_choice.h"
#include "lighting/refined_cut.h"
#include "lighting/survey_draw.h"
#include "lighting/tuning.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

CellSurveyor::CellSurveyor(const ChoosableLights& lights, const LightTree& tree,
                           const Viewer& viewer, double max_by_direction)
    : lights_(lights), tree_(tree), viewer_(viewer), max_by_direction_(max_by_direction) {
    if (lights.size() == 0) return;
    ball_ = ball_around(tree.box(tree.root()), lights);
    for (LightIndex light = 0; light < lights.size(); ++light) {
        brightest_ = std::fmax(brightest_, lights.bounds(light).luminance);
        (lights.has_surface(light) ? no_surfaces_ : all_surfaces_) = false;
    }
}

CellSurvey CellSurveyor::operator()(const Box& cell, bool in_air, LightCut& cut,
                                    const LightProbe& probe) const {
    const std::vector<SurveyPlace> receivers =
        in_air ? air_places_in(cell, viewer_, probe) : survey_places_in(cell, viewer_, probe);
    cut.scale(counted(arriving_shares(cut, tree_, lights_, receivers, probe), cut, cell));
    CellSurvey result;
    // Directions cannot hit light sources.
    if (lights_.falls_off()) return result;
    const Found by_choice = found_by_choice(cut, receivers, probe);
    const double found = by_choice.noise, choice = tuning::doubt * found + tuning::min_noise;
    if ((!all_surfaces_ || in_air) && by_choice.irradiance > 0) {
        result.irradiance = by_choice.irradiance;
        result.noise = by_choice.irradiance * std::sqrt(found + tuning::min_noise);
    }
    // Luminaires look small from points in the air.
    if (no_surfaces_ || in_air) return result;
    result.outlook.emplace(cell, ball_, receivers, probe);
    const double outlook = result.outlook->noise() + tuning::min_noise;
    const double share =
        std::isinf(outlook) ? 0 : (std::isinf(choice) ? 1 : choice / (choice + outlook));
    if (found > tuning::no_noise)
        result.by_direction =
            std::clamp(share, tuning::min_by_direction * std::fmin(found / tuning::little_noise, 1),
                       max_by_direction_);
    // The outlook knows surfaces only, which are not all luminaires here.
    if (!all_surfaces_) return result;
    const double scattering = result.outlook->noise_of_scattering();
    result.as_scattered = scattering <= std::fmin(outlook, found + tuning::min_noise) &&
                          brightest_ <= tuning::max_glare * result.outlook->mean_luminance();
    const double variance =
        result.as_scattered
            ? scattering + tuning::min_noise
            : (std::isinf(outlook) ? found + tuning::min_noise
                                   : 1 / (1 / (found + tuning::min_noise) + 1 / outlook));
    const double weight = mean_total(cut, receivers);
    const double seen = weight > 0 ? result.outlook->irradiance() / weight : 0;
    if (std::isfinite(variance)) {
        // Either way may have missed most of the light: the outlook small luminaires that are far.
        result.irradiance = std::fmax(seen, by_choice.irradiance);
        result.noise = result.irradiance * std::sqrt(variance);
    }
    return result;
}

/// Factors on the weights of a cell's entries: the survey's shares, raised for near entries.
std::vector<float> CellSurveyor::counted(std::span<const float> shares, const LightCut& cut,
                                         const Box& cell) const {
    const std::size_t count = cut.entries();
    std::vector<double> given(count), raise(count);
    double learned = 0, raised = 0;
    for (std::size_t i = 0; i < count; ++i) {
        given[i] = weight_in(cell, tree_, cut.cluster(i));
        learned += given[i] * shares[i];
    }
    for (std::size_t i = 0; i < count; ++i) {
        const double share = shares[i];
        raise[i] = cautious_share(shares[i], cell, tree_.light_proxy(cut.cluster(i))) - share;
        if (raise[i] * given[i] > tuning::max_raised_alone * learned)
            raise[i] = tuning::max_raised_alone * learned / given[i];
        raised += given[i] * raise[i];
    }
    const double kept =
        raised > tuning::max_raised * learned ? tuning::max_raised * learned / raised : 1;
    std::vector<float> result(count);
    for (std::size_t i = 0; i < count; ++i)
        result[i] = static_cast<float>(shares[i] + kept * raise[i]);
    return result;
}

CellSurveyor::Found CellSurveyor::found_by_choice(const LightCut& cut,
                                                  std::span<const SurveyPlace> receivers,
                                                  const LightProbe& probe) const {
    CutWeights weights;
    std::vector<double> found(tuning::trials, 0), at_place(receivers.size(), 0);
    for (std::uint32_t i = 0; i < tuning::trials; ++i) {
        const auto number = [&](ShadowRayDraw draw) { return survey_number(i, draw); };
        const SurveyPlace& from = receivers[i % receivers.size()];
        cut.weigh(from.point, weights);
        const auto pick =
            pick_from(cut, weights, tree_, from.point, survey_key(i, ShadowRayDraw::choice),
                      number(ShadowRayDraw::choice));
        if (!pick) continue;
        const double light = lights_.arriving(
            pick->light, from, {number(ShadowRayDraw::point_u), number(ShadowRayDraw::point_v)},
            probe);
        if (!(light > 0)) continue;
        found[i] = light / (pick->expected * weights.total);
        at_place[i % receivers.size()] += found[i];
    }
    const std::vector<double> counts = balanced(at_place);
    double sum = 0, squares = 0, light = 0;
    for (std::size_t i = 0; i < tuning::trials; ++i) {
        const double given = counts[i % receivers.size()] * found[i];
        sum += given;
        squares += given * given;
        light += found[i];
    }
    return {sum > 0 ? tuning::trials * squares / (sum * sum) - 1 : INFINITY,
            light / tuning::trials};
}

}  // namespace candelabra
