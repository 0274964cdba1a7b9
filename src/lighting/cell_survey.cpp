// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/cell_survey.h"

#include "base/elementary.h"
#include "base/short_list.h"
#include "lighting/cut_calibration.h"
#include "lighting/cut_choice.h"
#include "lighting/refined_cut.h"
#include "lighting/survey_draw.h"
#include "lighting/tuning.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace candelabra {

namespace {

/// Mean square of the sky's irradiance by one direction from an outlook, as rays to the sky find
/// it.
double mean_square(const LightGuide& outlook, std::span<const SkyRay> rays) {
    LightGuide::Weights weights;
    double square = 0;
    for (const SkyRay& ray : rays) {
        outlook.weigh(ray.from->point, weights);
        const double irradiance = ray.luminance * ray.from->point.cosine(ray.direction);
        if (irradiance > 0)
            square += irradiance * irradiance /
                      (LightGuide::density(weights, ray.direction) * ray.chance);
    }
    return square;
}

}  // namespace

CellSurveyor::CellSurveyor(const ChoosableLights& lights, const LightTree& tree,
                           const Viewer& viewer, double max_by_direction)
    : lights_(lights), tree_(tree), viewer_(viewer), max_by_direction_(max_by_direction) {
    if (const ChoosableSky* sky = lights.sky()) {
        brightest_ = sky->brightest();
        no_surfaces_ = false;
    }
    if (lights.size() == 0) return;
    if (const LightCluster hit = tree.by_square_law(); hit.count > 0)
        ball_ = ball_around(tree.box(hit), lights);
    for (const LightCopy& copy : lights.copies()) {
        brightest_ = std::fmax(brightest_, copy.luminance);
        no_surfaces_ = false;
    }
    for_single_lights(lights, [&](LightIndex light) {
        brightest_ = std::fmax(brightest_, lights.bounds(light).luminance);
        (lights.has_surface(light) ? no_surfaces_ : all_surfaces_) = false;
    });
}

CellSurvey CellSurveyor::operator()(const Box& cell, bool in_air, LightCut& cut,
                                    const LightProbe& probe) const {
    const std::vector<SurveyPlace> receivers =
        in_air ? air_places_in(cell, viewer_, probe) : survey_places_in(cell, viewer_, probe);
    cut.scale(counted(arriving_shares(cut, tree_, lights_, receivers, probe), cut, cell));
    CellSurvey result;
    // Directions cannot hit light sources.
    if (tree_.by_square_law().count == 0 && !lights_.sky()) return result;
    const Found by_choice = found_by_choice(cut, receivers, probe);
    if (const ChoosableSky* sky = lights_.sky()) {
        const std::vector<SkyRay> rays = rays_to_sky(*sky, receivers, probe);
        result.sky.emplace(*sky, rays);
        if (!in_air) {
            LightGuide::SkySeen seen{*sky};
            result.outlook.emplace(cell, ball_, receivers, probe, &seen);
            result.sky = brighter(*result.sky, SkySurvey(*sky, seen.rays));
        }
        return with_sky(std::move(result), by_choice, mean_total(cut, receivers), rays);
    }
    const double found = by_choice.noise;
    if ((!all_surfaces_ || in_air) && by_choice.irradiance > 0) {
        result.irradiance = by_choice.irradiance;
        result.noise = by_choice.irradiance * std::sqrt(found + tuning::min_noise);
    }
    // Luminaires look small from points in the air.
    if (no_surfaces_ || in_air) return result;
    result.noise_of_choice = tuning::doubt * found + tuning::min_noise;
    result.outlook.emplace(cell, ball_, receivers, probe, nullptr);
    const double outlook = result.outlook->noise() + tuning::min_noise;
    if (tree_.has_both_laws()) {
        with_sources(result, by_choice, outlook);
        return result;
    }
    result.by_direction = share_of_outlook(found, result.noise_of_choice, outlook);
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

/// Completes the survey of a cell where light sources, which no direction hits, are chosen beside
/// luminaires: these share their part of the shadow rays between choices and directions.
void CellSurveyor::with_sources(CellSurvey& result, const Found& by_choice, double outlook) const {
    const auto noise_of = [](const DrawnLight& light) {
        return light.mean > 0 ? std::fmax(math::pow(light.root / light.mean, 2) - 1, 0) : INFINITY;
    };
    const double found = noise_of(by_choice.luminaires);
    result.by_direction =
        share_of_outlook(found, tuning::doubt * found + tuning::min_noise, outlook);
    const double variance = 1 / (1 / (found + tuning::min_noise) + 1 / outlook);
    const auto root_of = [](const DrawnLight& light, double noise) {
        return std::isfinite(noise) ? light.mean * std::sqrt(1 + noise) : 0;
    };
    const double roots =
        root_of(by_choice.luminaires, variance) +
        root_of(by_choice.sources, noise_of(by_choice.sources) + tuning::min_noise);
    result.irradiance = by_choice.irradiance;
    result.noise = std::sqrt(std::fmax(roots * roots - math::pow(by_choice.irradiance, 2), 0));
}

/// Fraction of the shadow rays to be sampled from the outlook, given the variance over squared mean
/// of choices as found and as expected, and that of its directions.
double CellSurveyor::share_of_outlook(double found, double choice, double outlook) const {
    if (!(found > tuning::no_noise)) return 0;
    const double share =
        std::isinf(outlook) ? 0 : (std::isinf(choice) ? 1 : choice / (choice + outlook));
    return std::clamp(share, tuning::min_by_direction * std::fmin(found / tuning::little_noise, 1),
                      max_by_direction_);
}

/// Completes the survey of a cell that the sky may light. `weight`: mean total weight of the cut at
/// the places of the survey. `rays`: those that were drawn to the sky.
CellSurvey CellSurveyor::with_sky(CellSurvey result, const Found& by_choice, double weight,
                                  std::span<const SkyRay> rays) const {
    if (by_choice.irradiance > 0)
        result.lamps = {by_choice.irradiance,
                        by_choice.irradiance * std::sqrt(by_choice.noise + 1)};
    if (!result.outlook) return result;
    const DrawnLight lamps{result.lamps.mean * weight, result.lamps.root * weight};
    const SharedDraw choice =
        shared_draw(result.sky->there(), weight > 0 ? std::optional(lamps) : std::nullopt);
    const double found = choice.noise;
    // The outlook may have missed what is small and bright, such as a sun.
    const double missed = mean_square(*result.outlook, rays) / (choice.mean * choice.mean) - 1;
    const double outlook = std::fmax(result.outlook->noise(), missed) + tuning::min_noise;
    result.by_direction = share_of_outlook(found, found + tuning::min_noise, outlook);
    if (!all_surfaces_) return result;
    const double scattering = result.outlook->noise_of_scattering();
    result.as_scattered = scattering <= std::fmin(outlook, found + tuning::min_noise) &&
                          brightest_ <= tuning::max_glare * result.outlook->mean_luminance();
    result.noise_of_directions = result.as_scattered ? scattering : outlook;
    return result;
}

SharedDraw CellSurvey::among_all(const Receiver& point, double total) const {
    const DrawnLight others{lamps.mean * total, lamps.root * total};
    return shared_draw(sky->at(point), total > 0 ? std::optional(others) : std::nullopt);
}

double CellSurvey::by_surface(const CutWeights& reflected, const BsdfLobes& lobes,
                              std::span<const EntryLook> looks) const {
    double luminance = 0, solid_angle = 0;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const double share = static_cast<double>(reflected.weight[i]) / reflected.total;
        luminance += share * looks[i].luminance;
        solid_angle += share * looks[i].solid_angle;
    }
    // What is reflected, over what would be if all directions were as bright. The variance of a
    // direction from the BSDF over the squared mean is its reciprocal, less 1.
    const double filled =
        irradiance * reflected.total / (std::numbers::pi * lobes.albedo() * luminance);
    if (!(filled < 1)) return 1;
    const double by_noise = 1 / (1 + (1 / filled - 1) / noise_of_choice);
    double narrowest = INFINITY;
    for (const Highlight& h : std::span(lobes.highlights).first(lobes.count))
        narrowest = std::fmin(narrowest, std::numbers::pi * h.albedo() / h.peak);
    return std::fmax(by_noise, solid_angle / (solid_angle + narrowest));
}

std::optional<LightEstimate::ShadowRay> CellSurvey::ray_of(const SharedDraw& choice) const {
    if (!(choice.mean > 0)) return {};
    const double chosen = choice.noise + tuning::min_noise;
    const double variance = as_scattered ? noise_of_directions + tuning::min_noise
                            : std::isinf(noise_of_directions)
                                ? chosen
                                : 1 / (1 / chosen + 1 / noise_of_directions);
    return LightEstimate::ShadowRay{choice.mean, choice.mean * std::sqrt(variance)};
}

std::vector<EntryLook> CellSurveyor::looks_of(const LightCut& cut, const Box& cell) const {
    constexpr int draws = 4;
    const double reach = 0.5 * length(cell.size());
    std::vector<EntryLook> result;
    for (std::size_t i = 0; i < cut.entries(); ++i) {
        const LightCluster& c = cut.cluster(i);
        const int count = c.count > 1 ? draws : 1;
        EntryLook mean{};
        for (int k = 0; k < count; ++k) {
            const LightBounds b = lights_.bounds(tree_.light(tree_.draw(c, (k + 0.5) / count)));
            if (!(b.luminance > 0)) continue;
            const Vec3 offset = b.centre - cell.centre();
            const double distance2 = dot(offset, offset) + reach * reach;
            mean.luminance += b.luminance / count;
            mean.solid_angle += b.intensity / (b.luminance * distance2 * count);
        }
        result.push_back(mean);
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
    const bool both = tree_.has_both_laws();
    const std::uint32_t trials = both ? 2 * tuning::trials : tuning::trials;
    std::vector<double> found(trials, 0), at_place(receivers.size(), 0);
    std::array<DrawnLight, 2> kinds;
    std::array<double, 2> squares_of{};
    double of_sources = 0;
    struct Trial {
        std::uint32_t number;
        double weight;  ///< of all entries
        OpenPick open;
        LightPick pick = {};
    };
    ShortList<Trial, draws_together> drawn;
    const auto trace = [&] {
        ShortList<MemberDraw*, draws_together> members;
        for (Trial& trial : drawn) members.push_back(&trial.open.member);
        descend_together({members.data(), members.size()});
        for (Trial& trial : drawn) {
            trial.pick = trial.open.pick(tree_);
            lights_.fetch(trial.pick.light);
        }
        for (const auto& [i, weight, open, pick] : drawn) {
            const double light = lights_.arriving(pick.light, receivers[i % receivers.size()],
                                                  {survey_number(i, ShadowRayDraw::point_u),
                                                   survey_number(i, ShadowRayDraw::point_v)},
                                                  probe);
            if (!(light > 0)) continue;
            found[i] = light / (pick.expected * weight);
            at_place[i % receivers.size()] += found[i];
            const std::size_t kind = both && !lights_.falloff(pick.light);
            kinds[kind].mean += found[i] / trials;
            squares_of[kind] += found[i] * found[i] / trials;
        }
        drawn.clear();
    };
    for (std::uint32_t i = 0; i < trials; ++i) {
        const Receiver& point = receivers[i % receivers.size()].point;
        cut.weigh(point, weights);
        const auto open =
            open_pick(cut, weights, tree_, point, survey_key(i, ShadowRayDraw::choice),
                      survey_number(i, ShadowRayDraw::choice));
        if (!open) continue;
        if (both) of_sources += cut.share_of_sources(weights) / trials;
        drawn.push_back({i, weights.total, *open});
        if (drawn.size() == draws_together) trace();
    }
    trace();
    kinds[0].root = std::sqrt(squares_of[0] * of_sources);
    kinds[1].root = std::sqrt(squares_of[1] * (1 - of_sources));
    const std::vector<double> counts = balanced(at_place);
    double sum = 0, squares = 0, light = 0;
    for (std::size_t i = 0; i < trials; ++i) {
        const double given = counts[i % receivers.size()] * found[i];
        sum += given;
        squares += given * given;
        light += found[i];
    }
    return {sum > 0 ? trials * squares / (sum * sum) - 1 : INFINITY, light / trials, kinds[0],
            kinds[1]};
}

}  // namespace candelabra
