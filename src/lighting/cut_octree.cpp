// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/cut_octree.h"

#include "lighting/cluster_descent.h"
#include "lighting/cut_calibration.h"
#include "lighting/draw.h"
#include "lighting/light_cells.h"
#include "lighting/refined_cut.h"

#include <algorithm>

namespace candelabra {

namespace {

/// Factor by which the noise of a cell without a survey exceeds the bound before the cell is
/// divided: weighing the entries at each point compensates for less.
constexpr double divided_above = 20;
/// Size in pixels, as seen by the eye, above which cells are divided: they contain many hits, whose
/// views differ. Smaller cells stay whole if they are surveyed, so that the survey's rays are a
/// small part of all rays.
constexpr double coarse_pixels = 32;
/// Factor on this size for cells between surfaces, where light varies less.
constexpr double coarser_in_air = 2;
/// Bounds on this size as an angle (size over distance), for large and for small pictures.
constexpr double min_coarse = 0.03, greatest_coarse = 0.5;
/// Maximum size of cells where all rays of the camera are parallel, in widths of the view.
constexpr double most_views = 4;
/// Number of levels beyond the deepest one by which cells that are too large may still be divided:
/// enough for every ratio of lengths in single precision.
constexpr int more_levels = 160;
/// Number of levels below cells that are too large by which noise may divide cells without a survey
/// in any case: one lamp that is far makes the whole cube large, and its first levels say nothing.
constexpr int finer_levels = 5;
/// Near luminaires look different from different points of a cell, and so count more than the
/// survey says. Together they are raised by at most this multiple of the survey's total of all
/// entries, and each alone by at most this multiple. So occluded luminaires cause little noise,
/// however bright, and those that are visible against the survey are not too rare.
constexpr double max_raised = 1, max_raised_alone = 0.1;
/// Number of shadow rays that measure the noise of choosing luminaires in a cell.
constexpr std::uint32_t trials = 48;
/// Minimum variance over squared mean of both ways of sampling, because surfaces differ.
constexpr double min_noise = 0.02;
/// Factor on the noise of the choice against that of the outlook: the rays that measured the choice
/// had also trained it.
constexpr double doubt = 3;
/// Minimum fraction of the shadow rays that are sampled from the outlook, which finds luminaires
/// that nearly touch the point. The fraction decreases with the noise of the choice below
/// little_noise, and is 0 if there is none at all.
constexpr double min_by_direction = 0.1, little_noise = 0.1, no_noise = 1e-6;
/// Maximum ratio of the brightest luminaire to the mean visible luminance at which surfaces may
/// sample directions from their BSDF alone: no ray can then bring much more than others.
constexpr double max_glare = 16;
/// Fraction of the shadow rays that surfaces without a diffuse part sample from their BSDF.
constexpr double max_by_surface = 0.5;

/// Adds entries for luminaires that face away from a cell: twice as many if all shine one way.
int entries_for(int cut, std::span<const Luminaire> luminaires) {
    double one_way = 0;  // number of luminaires that shine one way only
    for (const Luminaire& luminaire : luminaires) one_way += 2 * length(luminaire.bent_normal);
    const double share = luminaires.empty() ? 0 : one_way / static_cast<double>(luminaires.size());
    return static_cast<int>(std::lround(cut * (1 + share)));
}

}  // namespace

/// Results of the rays that survey a cell.
struct BuiltCutOctree::CellSurvey {
    std::optional<LightGuide> outlook;  ///< none: no directions are sampled from it
    double by_direction = 0;            ///< see Weights
    bool as_scattered = false;
    /// See Weights; per unit of the total weight.
    double noise = -1, irradiance = 0;
};

struct BuiltCutOctree::Cell {
    Box box;
    int depth = -1;                    ///< 0 for the root
    int too_large = 0;                 ///< number of the cells around it that are too large
    bool in_air = false;               ///< for points between surfaces
    std::optional<LightCut> cut;       ///< none: the cell is divided
    std::optional<CellSurvey> survey;  ///< none: there was no scene to survey
    std::array<std::atomic<Cell*>, 8> children{};

    Cell() = default;
    Cell(const Cell&) = delete;
    Cell& operator=(const Cell&) = delete;
    ~Cell() {
        for (const auto& child : children) delete child.load();
    }
};

struct BuiltCutOctree::State {
    LightOctree settings;
    CutRule rule;
    std::span<const Luminaire> luminaires;
    LightTree tree;
    LightBall ball;
    std::optional<Vec3> eye;
    Viewer viewer;
    /// Maximum size of small cells, at distance 1 from the eye if there is one.
    double coarse = 0;
    double view = 0;                                ///< see LightScene
    double brightest = 0;                           ///< luminance
    bool any_volume = false, only_volumes = false;  ///< no direction hits a volume
    Box cube;
    std::atomic<Cell*> root;
    std::atomic<Cell*> air;  ///< for points between surfaces
    Cell above, above_air;   ///< parents of the two roots
    std::atomic<std::size_t> cells = 0, bytes = 0;

    ~State() {
        delete root.load();
        delete air.load();
    }
};

BuiltCutOctree::BuiltCutOctree(BuiltCutOctree&&) noexcept = default;
BuiltCutOctree& BuiltCutOctree::operator=(BuiltCutOctree&&) noexcept = default;
BuiltCutOctree::~BuiltCutOctree() = default;

BuiltCutOctree::BuiltCutOctree(const LightOctree& settings, const LightScene& scene)
    : state_(std::make_unique<State>()) {
    state_->above_air.in_air = true;
    state_->rule = {settings.eta, entries_for(settings.cut, scene.luminaires)};
    state_->settings = settings;
    state_->luminaires = scene.luminaires;
    state_->eye = scene.eye;
    state_->viewer = {scene.eye, scene.axis};
    state_->view = scene.view;
    state_->coarse = std::clamp(coarse_pixels * scene.pixel, min_coarse, greatest_coarse);
    state_->tree = LightTree(scene.luminaires);
    if (scene.luminaires.empty()) return;
    LightBounds lights;
    lights.box = state_->tree.box(state_->tree.root());
    Box cube = cube_to_light(scene, {&lights, 1});
    if (cube.empty()) cube = lights.box;
    state_->ball = ball_around(lights.box, scene.luminaires);
    for (const Luminaire& luminaire : scene.luminaires)
        state_->brightest = std::fmax(state_->brightest, luminance(luminaire.radiance));
    state_->any_volume = std::ranges::any_of(scene.luminaires, &Luminaire::is_volume);
    state_->only_volumes = std::ranges::all_of(scene.luminaires, &Luminaire::is_volume);
    state_->cube = cube;
}

const LightTree& BuiltCutOctree::tree() const { return state_->tree; }

std::unique_ptr<BuiltCutOctree::Cell> BuiltCutOctree::make(const Box& box, const Cell& parent,
                                                           const LightProbe* probe) const {
    auto cell = std::make_unique<Cell>();
    cell->box = box;
    cell->depth = parent.depth + 1;
    cell->in_air = parent.in_air;
    cell->cut.emplace(state_->tree, state_->luminaires, box, state_->rule);
    const double coarse = state_->coarse * (cell->in_air ? coarser_in_air : 1);
    const double away = state_->eye ? length(box.centre() - *state_->eye) : 0;
    const double size = length(box.size());
    // However large the scene is, a cell is no larger than what is seen in it.
    const double widest = state_->eye        ? std::fmax(coarse, greatest_coarse) * away
                          : state_->view > 0 ? most_views * state_->view
                                             : INFINITY;
    const bool too_large = size > widest;
    const bool small = size <= coarse * away, large = too_large || (state_->eye && !small),
               learns = probe && !state_->settings.alone;
    const double noise = cell->cut->noise(), bound = state_->rule.noise;
    const bool several = cell->cut->entries() > 1;
    const bool uneven = large ? noise > bound || ((learns || too_large) && several)
                              : !(learns && small) && noise > divided_above * bound;
    cell->too_large = parent.too_large + (too_large ? 1 : 0);
    const int deepest = state_->settings.max_depth,
              finer = learns ? 0 : std::min(finer_levels, deepest);
    const int depth_limit =
        too_large ? deepest + more_levels : std::max(deepest, cell->too_large + finer);
    if (uneven && cell->depth < depth_limit)
        cell->cut.reset();
    else if (learns)
        cell->survey = survey(*cell, *cell->cut, *probe);
    return cell;
}

/// Surveys a cell, and scales its cut's entries by the arriving fraction of their light.
BuiltCutOctree::CellSurvey BuiltCutOctree::survey(const Cell& cell, LightCut& cut,
                                                  const LightProbe& probe) const {
    const Box& box = cell.box;
    const std::vector<SurveyPlace> receivers = cell.in_air
                                                   ? air_places_in(box, state_->viewer, probe)
                                                   : survey_places_in(box, state_->viewer, probe);
    cut.scale(counted(arriving_shares(cut, state_->tree, state_->luminaires, receivers, probe), cut,
                      box));
    CellSurvey result;
    // Directions cannot hit light sources.
    if (state_->tree.falloff(state_->tree.root())) return result;
    const Found by_choice = found_by_choice(cut, receivers, probe);
    const double found = by_choice.noise, choice = doubt * found + min_noise;
    if ((state_->any_volume || cell.in_air) && by_choice.irradiance > 0) {
        result.irradiance = by_choice.irradiance;
        result.noise = by_choice.irradiance * std::sqrt(found + min_noise);
    }
    // Luminaires look small from points in the air.
    if (state_->only_volumes || cell.in_air) return result;
    result.outlook.emplace(box, state_->ball, receivers, probe);
    const double outlook = result.outlook->noise() + min_noise;
    const double share =
        std::isinf(outlook) ? 0 : (std::isinf(choice) ? 1 : choice / (choice + outlook));
    if (found > no_noise)
        result.by_direction = std::clamp(
            share, min_by_direction * std::fmin(found / little_noise, 1), state_->settings.outlook);
    // The outlook knows surfaces only, which are not all luminaires here.
    if (state_->any_volume) return result;
    const double scattering = result.outlook->noise_of_scattering();
    result.as_scattered = scattering <= std::fmin(outlook, found + min_noise) &&
                          state_->brightest <= max_glare * result.outlook->mean_luminance();
    const double variance =
        result.as_scattered ? scattering + min_noise
                            : (std::isinf(outlook) ? found + min_noise
                                                   : 1 / (1 / (found + min_noise) + 1 / outlook));
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
std::vector<float> BuiltCutOctree::counted(std::span<const float> shares, const LightCut& cut,
                                           const Box& box) const {
    const std::size_t count = cut.entries();
    std::vector<double> given(count), raise(count);
    double learned = 0, raised = 0;
    for (std::size_t i = 0; i < count; ++i) {
        given[i] = weight_in(box, state_->tree, cut.cluster(i));
        learned += given[i] * shares[i];
    }
    for (std::size_t i = 0; i < count; ++i) {
        const double share = shares[i];
        raise[i] = cautious_share(shares[i], box, state_->tree.light_proxy(cut.cluster(i))) - share;
        if (raise[i] * given[i] > max_raised_alone * learned)
            raise[i] = max_raised_alone * learned / given[i];
        raised += given[i] * raise[i];
    }
    const double kept = raised > max_raised * learned ? max_raised * learned / raised : 1;
    std::vector<float> result(count);
    for (std::size_t i = 0; i < count; ++i)
        result[i] = static_cast<float>(shares[i] + kept * raise[i]);
    return result;
}

BuiltCutOctree::Found BuiltCutOctree::found_by_choice(const LightCut& cut,
                                                      std::span<const SurveyPlace> receivers,
                                                      const LightProbe& probe) const {
    Weights weights;
    weights.cut = &cut;
    LightPicks picks;
    std::vector<double> found(trials, 0), at_place(receivers.size(), 0);
    for (std::uint32_t i = 0; i < trials; ++i) {
        const auto number = [&](std::uint32_t n) {
            return uniform(Key::of(Survey::cell, n, i, 0), Purpose::light_representative);
        };
        const SurveyPlace& from = receivers[i % receivers.size()];
        cut.weigh(from.point, weights);
        picks.clear();
        choose(from.point, weights, Key::of(Survey::cell, 3, i, 0), number(3), picks);
        if (picks.empty()) continue;
        const LightPick& pick = picks.front();
        const double light =
            arriving(state_->luminaires, pick.light, from, {number(4), number(5)}, probe);
        if (!(light > 0)) continue;
        found[i] = light / (pick.expected * weights.total);
        at_place[i % receivers.size()] += found[i];
    }
    const std::vector<double> counts = balanced(at_place);
    double sum = 0, squares = 0, light = 0;
    for (std::size_t i = 0; i < trials; ++i) {
        const double given = counts[i % receivers.size()] * found[i];
        sum += given;
        squares += given * given;
        light += found[i];
    }
    return {sum > 0 ? trials * squares / (sum * sum) - 1 : INFINITY, light / trials};
}

/// Returns the cell at a place of the tree, which is made if there is none.
BuiltCutOctree::Cell* BuiltCutOctree::cell_in(std::atomic<Cell*>& place, const Box& box,
                                              const Cell& parent, const LightProbe* probe) const {
    Cell* cell = place.load(std::memory_order_acquire);
    if (cell) return cell;
    std::unique_ptr<Cell> made = make(box, parent, probe);
    if (!place.compare_exchange_strong(cell, made.get(), std::memory_order_acq_rel)) return cell;
    cell = made.release();
    state_->cells += 1;
    state_->bytes += sizeof(Cell) + (cell->cut ? cell->cut->memory_bytes() : 0);
    if (cell->survey && cell->survey->outlook)
        state_->bytes += cell->survey->outlook->memory_bytes();
    return cell;
}

const BuiltCutOctree::Cell& BuiltCutOctree::cell_at(const Receiver& receiver,
                                                    const LightProbe* probe) const {
    const bool in_air = receiver.horizon == Horizon::none;
    const Vec3& point = receiver.position;
    Cell* cell = in_air ? cell_in(state_->air, state_->cube, state_->above_air, probe)
                        : cell_in(state_->root, state_->cube, state_->above, probe);
    while (!cell->cut) {
        const Vec3 middle = cell->box.centre();
        Box part = cell->box;
        std::size_t which = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const bool upper = point[axis] >= middle[axis];
            which |= std::size_t{upper} << axis;
            (upper ? part.low : part.high)[axis] = middle[axis];
        }
        cell = cell_in(cell->children[which], part, *cell, probe);
    }
    return *cell;
}

void BuiltCutOctree::weigh(const LightQuery& query, Weights& weights) const {
    const Receiver& point = query.receiver;
    const BsdfLobes& lobes = query.lobes;
    if (state_->luminaires.empty()) return;
    const Cell& cell = cell_at(point, query.scene);
    weights.cut = &*cell.cut;
    weights.cut->weigh(point, weights);
    weights.by_direction = weights.total > 0 && cell.survey ? cell.survey->by_direction : 0;
    weights.as_scattered = cell.survey && cell.survey->as_scattered;
    weights.noise = cell.survey ? cell.survey->noise * weights.total : -1;
    weights.irradiance = cell.survey ? cell.survey->irradiance * weights.total : 0;
    if (lobes.count > 0) weights.cut->weigh_answers(point, lobes, weights);
    if (!query.bsdf) weights.by_direction = 0;  // directions are not wanted
    if (weights.as_scattered || !(weights.by_direction > 0)) return;
    cell.survey->outlook->weigh(point, weights.outlook);
    if (!(weights.outlook.total > 0)) weights.by_direction = 0;
}

void BuiltCutOctree::weigh_choice(const Receiver& point, const BsdfLobes& lobes,
                                  Weights& weights) const {
    if (state_->luminaires.empty()) return;
    weights.cut = &*cell_at(point, nullptr).cut;
    weights.cut->weigh(point, weights);
    if (lobes.count > 0) weights.cut->weigh_answers(point, lobes, weights);
}

void BuiltCutOctree::choose(const Receiver& point, const Weights& weights, const Key& key, double u,
                            LightPicks& picks) const {
    if (!weights.cut || !(weights.total > 0)) return;
    double target = u * weights.total;
    const std::size_t entry = weights.cut->find(weights, target);
    const double weight = weights.weight[entry];
    const DrawnMember drawn =
        member_of(state_->tree, weights.cut->cluster(entry), point, key, target / weight);
    const double probability = weight / weights.total * drawn.probability;
    picks.push_back({state_->tree.light(drawn.place),
                     std::fmax(probability, std::numeric_limits<double>::min())});
}

double BuiltCutOctree::expected(const Receiver& point, const Weights& weights,
                                LightIndex light) const {
    if (!weights.cut || !(weights.total > 0)) return 0;
    const std::uint32_t place = state_->tree.place_of(light);
    const std::size_t entry = weights.cut->entry_of(place);
    if (entry >= weights.cut->entries()) return 0;
    const LightCluster& c = weights.cut->cluster(entry);
    if (!c.holds(place) || !(weights.weight[entry] > 0)) return 0;
    return weights.weight[entry] / weights.total * probability_of(state_->tree, c, point, place);
}

void BuiltCutOctree::choose(const Receiver& point, const Key& key, LightPicks& picks) const {
    Weights weights;
    weigh_choice(point, {}, weights);
    choose(point, weights, key, uniform(key, Purpose::light_choice), picks);
}

double BuiltCutOctree::expected(const Receiver& point, const Key&, LightIndex light) const {
    Weights weights;
    weigh_choice(point, {}, weights);
    return expected(point, weights, light);
}

std::size_t BuiltCutOctree::memory_bytes() const {
    return state_->tree.memory_bytes() + state_->bytes;
}

std::size_t BuiltCutOctree::cells() const { return state_->cells; }

BuiltCutOctree::At::At(const BuiltCutOctree& octree, const LightQuery& query)
    : octree_(octree),
      receiver_(query.receiver),
      bsdf_(octree.state_->only_volumes ? nullptr : query.bsdf) {
    if (query.scene)
        octree.weigh(query, weights_);
    else
        octree.weigh_choice(receiver_, query.lobes, weights_);
    if (!bsdf_) return;
    by_surface_ =
        weights_.as_scattered ? 1 : max_by_surface * std::sqrt(bsdf_->specular_probability);
    by_outlook_ = (1 - by_surface_) * weights_.by_direction;
    by_choice_ = 1 - (by_surface_ + by_outlook_);
}

double BuiltCutOctree::At::pdf(const Vec3& direction, double expected, double of_point) const {
    return (by_surface_ > 0 ? by_surface_ * bsdf_->pdf(direction) : 0) +
           (by_outlook_ > 0 ? by_outlook_ * LightGuide::density(weights_.outlook, direction) : 0) +
           (by_choice_ > 0 ? by_choice_ * expected * of_point : 0);
}

void BuiltCutOctree::At::sample(const Key& key, LightSamples& samples) const {
    const double u = uniform(key, Purpose::light_choice), by_direction = by_surface_ + by_outlook_;
    if (u >= by_direction) {
        octree_.choose(receiver_, weights_, key, (u - by_direction) / by_choice_, samples.picks);
    } else if (u < by_surface_) {
        samples.direction = bsdf_->sample(place_on_light(key));
    } else {
        samples.direction = LightGuide::draw(weights_.outlook, place_on_light(key)).direction;
    }
}

}  // namespace candelabra
