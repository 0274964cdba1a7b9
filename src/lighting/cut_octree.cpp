// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/cut_octree.h"

#include "base/short_list.h"
#include "lighting/cell_survey.h"
#include "lighting/draw.h"
#include "lighting/light_cells.h"
#include "lighting/tuning.h"

#include <algorithm>
#include <mutex>
#include <span>
#include <vector>

namespace candelabra {

namespace {

/// Number of levels beyond the deepest one by which cells that are too large may still be divided:
/// enough for every ratio of lengths in single precision.
constexpr int more_levels = 160;
/// Adds entries for lights that face away from a cell: twice as many if all shine one way.
/// Where there are luminaires and light sources, each kind has as many as by itself.
int entries_for(int cut, const ChoosableLights& lights, const LightTree& tree) {
    if (tree.has_both_laws()) cut *= 2;
    double one_way = 0;  // number of lights that shine one way only
    for_single_lights(
        lights, [&](LightIndex light) { one_way += 2 * length(lights.bounds(light).bent_normal); });
    const double share = lights.size() > 0 ? one_way / static_cast<double>(lights.size()) : 0;
    return static_cast<int>(std::lround(cut * (1 + share)));
}

}  // namespace

struct BuiltCutOctree::Cell {
    Box box;
    int depth = -1;                    ///< 0 for the root
    int too_large = 0;                 ///< number of the cells around it that are too large
    bool in_air = false;               ///< for points between surfaces
    std::optional<LightCut> cut;       ///< none: the cell is divided
    std::optional<CellSurvey> survey;  ///< none: there was no scene to survey
    mutable std::once_flag looked;
    mutable std::vector<EntryLook> looks;  ///< of the entries; see looks_in()
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
    std::shared_ptr<const ChoosableLights> lights;
    LightTree tree;
    CutRule rule;
    CellSurveyor survey;
    std::optional<Vec3> eye;
    /// Maximum size of small cells, at distance 1 from the eye if there is one.
    double coarse = 0;
    double view = 0, even = 0;  ///< see LightScene
    Box cube;
    std::atomic<Cell*> root;
    std::atomic<Cell*> air;  ///< for points between surfaces
    Cell above, above_air;   ///< parents of the two roots
    std::atomic<std::size_t> cells = 0, bytes = 0;

    State(const LightOctree& of_scene, const LightScene& scene, int threads)
        : settings(of_scene),
          lights(scene.lights),
          tree(*lights, threads),
          rule{settings.eta, entries_for(settings.cut, *lights, tree)},
          survey(*lights, tree, {scene.eye, scene.axis}, settings.outlook),
          eye(scene.eye),
          coarse(std::clamp(tuning::coarse_pixels * scene.pixel, tuning::min_coarse,
                            tuning::greatest_coarse)),
          view(scene.view),
          even(scene.even) {
        above_air.in_air = true;
        LightBounds all;
        if (tree.lights() > 0)
            all.box = tree.box(tree.root());
        else if (eye)  // what is lit is about where it is seen from
            all.box = {*eye - 1.0, *eye + 1.0};
        cube = cube_to_light(scene, {&all, 1});
        if (cube.empty()) cube = all.box.empty() ? Box{Vec3(-1), Vec3(1)} : all.box;
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        delete root.load();
        delete air.load();
    }
};

BuiltCutOctree::BuiltCutOctree(BuiltCutOctree&&) noexcept = default;
BuiltCutOctree& BuiltCutOctree::operator=(BuiltCutOctree&&) noexcept = default;
BuiltCutOctree::~BuiltCutOctree() = default;

BuiltCutOctree::BuiltCutOctree(const LightOctree& settings, const LightScene& scene, int threads)
    : state_(scene.count() > 0 || scene.has_sky()
                 ? std::make_unique<State>(settings, scene, threads)
                 : nullptr) {}

const LightTree& BuiltCutOctree::tree() const { return state_->tree; }

std::unique_ptr<BuiltCutOctree::Cell> BuiltCutOctree::make(const Box& box, const Cell& parent,
                                                           const LightProbe* probe) const {
    auto cell = std::make_unique<Cell>();
    cell->box = box;
    cell->depth = parent.depth + 1;
    cell->in_air = parent.in_air;
    cell->cut.emplace(state_->tree, *state_->lights, box, state_->rule);
    const double coarse = state_->coarse * (cell->in_air ? tuning::coarser_in_air : 1);
    const double away = state_->eye ? length(box.centre() - *state_->eye) : 0;
    const double size = length(box.size());
    // However large the scene is, a cell is no larger than what is seen in it.
    const double widest = state_->eye        ? std::fmax(coarse, tuning::greatest_coarse) * away
                          : state_->view > 0 ? tuning::most_views * state_->view
                                             : INFINITY;
    const bool too_large = size > widest;
    const bool small = size <= coarse * away, large = too_large || (state_->eye && !small),
               learns = probe && !state_->settings.alone;
    const double noise = cell->cut->noise(), bound = state_->rule.noise;
    const bool several = cell->cut->entries() > 1 || state_->lights->sky();
    const bool uneven = large ? noise > bound || ((learns || too_large) && several)
                              : !(learns && small) && noise > tuning::divided_above * bound;
    cell->too_large = parent.too_large + (too_large ? 1 : 0);
    const int deepest = state_->settings.max_depth,
              finer = learns ? 0 : std::min(tuning::finer_levels, deepest);
    const int depth_limit =
        too_large ? deepest + more_levels : std::max(deepest, cell->too_large + finer);
    if (uneven && cell->depth < depth_limit)
        cell->cut.reset();
    else if (learns)
        cell->survey = state_->survey(box, cell->in_air, *cell->cut, *probe);
    return cell;
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

/// Only highlights ask how the entries look, so that is found when the first one asks.
std::span<const EntryLook> BuiltCutOctree::looks_in(const Cell& cell) const {
    std::call_once(cell.looked, [&] { cell.looks = state_->survey.looks_of(*cell.cut, cell.box); });
    return cell.looks;
}

std::size_t BuiltCutOctree::memory_bytes() const {
    return state_ ? state_->tree.memory_bytes() + state_->bytes : 0;
}

std::size_t BuiltCutOctree::cells() const { return state_ ? state_->cells.load() : 0; }

BuiltCutOctree::At::At(const BuiltCutOctree& octree, const LightQuery& query)
    : octree_(octree), receiver_(query.receiver) {
    if (!octree.state_) return;
    if (!octree.state_->survey.no_surfaces()) bsdf_ = query.bsdf;
    take_weights(query, octree.cell_at(receiver_, query.scene));
}

void BuiltCutOctree::At::take_weights(const LightQuery& query, const Cell& cell) {
    const CellSurvey* survey = query.scene && cell.survey ? &*cell.survey : nullptr;
    cut_ = &*cell.cut;
    cut_->weigh(receiver_, weights_);
    takes_sky_ = query.sky && survey && survey->sky;
    double by_direction = (weights_.total > 0 || takes_sky_) && survey ? survey->by_direction : 0;
    const double noise = survey ? survey->noise * weights_.total : -1;
    if (noise >= 0) ray_ = {survey->irradiance * weights_.total, noise};
    if (takes_sky_) {
        const SharedDraw choice = survey->among_all(receiver_, weights_.total);
        sky_ = choice.sky;
        ray_ = survey->ray_of(choice);
    }
    if (octree_.state_->even > 0 && !survey) cut_->share_evenly(octree_.state_->even, weights_);
    if (query.lobes.count > 0 && weights_.total > 0) {
        const double arriving = weights_.total;
        cut_->weigh_answers(receiver_, query.lobes, weights_);
        response_ = weights_.total / arriving;
        lobes_.emplace(query.lobes);
    }
    if (!bsdf_) return;  // directions are not wanted
    const bool as_scattered = survey && survey->as_scattered;
    if (!as_scattered && by_direction > 0) {
        survey->outlook->weigh(receiver_, outlook_);
        if (!(outlook_.total > 0)) by_direction = 0;
    }
    // The more of the expected light highlights reflect, the more their directions find.
    double shining = bsdf_->specular_probability;
    if (response_) shining = std::fmax(shining, 1 - query.lobes.diffuse / *response_);
    by_surface_ = as_scattered ? 1 : tuning::max_by_surface * std::sqrt(shining);
    if (response_ && survey && !as_scattered) {
        const double wanted =
            survey->knows_by_surface()
                ? survey->by_surface(weights_, query.lobes, octree_.looks_in(cell))
                : 1;
        by_surface_ =
            std::fmin(by_surface_, std::fmax(wanted, tuning::least_by_surface * by_surface_));
        // Directions from the BSDF find what nearly touches the point.
        by_direction = std::fmax(by_direction - tuning::min_by_direction * shining, 0);
    }
    by_outlook_ = (1 - by_surface_) * by_direction;
    if (cut_->has_both_laws() && weights_.total > 0) keep_for_sources();
    by_choice_ = 1 - (by_surface_ + by_outlook_);
}

/// Light sources, which no direction hits, keep their fraction of the shadow rays.
void BuiltCutOctree::At::keep_for_sources() {
    const double chosen = 1 - (by_surface_ + by_outlook_);
    const double hit = 1 - (1 - sky_) * cut_->share_of_sources(weights_);
    by_surface_ *= hit;
    by_outlook_ *= hit;
    sky_ *= chosen / (1 - (by_surface_ + by_outlook_));
    cut_->dim_luminaires(chosen, weights_);
}

double BuiltCutOctree::At::expected(const Key&, LightIndex light) const {
    if (!cut_ || !(by_choice_ > 0)) return 0;
    if (light == sky_light) return by_choice_ * sky_;
    return by_choice_ * (1 - sky_) *
           expected_from(*cut_, weights_, octree_.tree(), receiver_, light, lobes());
}

double BuiltCutOctree::At::pdf(const Vec3& direction, double expected, double of_point) const {
    return (by_surface_ > 0 ? by_surface_ * bsdf_->pdf(direction) : 0) +
           (by_outlook_ > 0 ? by_outlook_ * LightGuide::density(outlook_, direction) : 0) +
           (expected > 0 ? expected * of_point : 0);
}

std::optional<LightEstimate> BuiltCutOctree::At::estimate() const {
    if (!cut_) return std::nullopt;
    return LightEstimate{ray_ ? ray_->irradiance : weights_.total * cut_->unit(), ray_, response_};
}

/// Samples a direction or the sky, or chooses an entry, of which a luminaire is to be drawn.
std::optional<OpenPick> BuiltCutOctree::At::begin(const Key& key, LightSamples& samples) const {
    const double u = uniform(key, Purpose::light_choice), by_direction = by_surface_ + by_outlook_;
    if (u < by_surface_) {
        samples.direction = bsdf_->sample(place_on_light(key));
        return {};
    }
    if (u < by_direction) {
        samples.direction = LightGuide::draw(outlook_, place_on_light(key)).direction;
        return {};
    }
    if (!cut_) return {};
    const double rest = (u - by_direction) / by_choice_;
    if (rest < sky_) {
        samples.picks.push_back({sky_light, by_choice_ * sky_});
        return {};
    }
    const double among_lamps = sky_ > 0 ? (rest - sky_) / (1 - sky_) : rest;
    return open_pick(*cut_, weights_, octree_.tree(), receiver_, key, among_lamps, lobes());
}

void BuiltCutOctree::At::finish(const OpenPick& open, LightSamples& samples) const {
    LightPick pick = open.pick(octree_.tree());
    pick.expected *= by_choice_ * (1 - sky_);
    samples.picks.push_back(pick);
}

void BuiltCutOctree::At::sample(const Key& key, LightSamples& samples) const {
    sample({&key, 1}, {&samples, 1});
}

void BuiltCutOctree::At::sample(std::span<const Key> keys, std::span<LightSamples> samples) const {
    ShortList<OpenPick, draws_together> open;
    ShortList<LightSamples*, draws_together> of_open;
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (auto pick = begin(keys[i], samples[i])) {
            open.push_back(*pick);
            of_open.push_back(&samples[i]);
        }
    ShortList<MemberDraw*, draws_together> members;
    for (OpenPick& pick : open) members.push_back(&pick.member);
    descend_together({members.data(), members.size()});
    for (std::size_t i = 0; i < open.size(); ++i) finish(open[i], *of_open[i]);
}

}  // namespace candelabra
