// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/cut_octree.h"

#include "lighting/draw.h"
#include "lighting/light_cells.h"

#include <algorithm>

namespace {

/// Clusters nearer than so many of their radii are taken apart at the point itself.
constexpr double near_radii = 2;
/// Cells are divided when their noise is above the bound by this factor: less is made up for by
/// weighing the entries at each point.
constexpr double divided_above = 20;
/// Probabilities may fall this far before the random number that is used up level by level is
/// replaced.
constexpr double worn_out = 1e-7;
/// Lines that tell how crowded the luminaires are.
constexpr std::uint32_t trials = 4;

bool near(const Glow& g, const Vec3& position) {
    const Vec3 v = g.centre - position;
    return dot(v, v) < near_radii * near_radii * g.radius * g.radius;
}

struct Halves {
    LightCluster first, second;
    double share;  ///< probability of the first
};

/// How a cluster that is near is divided at a point: by what its halves give there, else by their
/// strength. Nothing when it is drawn from as it is.
std::optional<Halves> divided(const LightTree& tree, const LightCluster& c,
                              const ShadingPoint& point) {
    if (c.count == 1 || !near(tree.glow(c), point.position)) return {};
    const auto [first, second] = tree.halves(c);
    if (tree.dark(first)) return Halves{first, second, 0};
    if (tree.dark(second)) return Halves{first, second, 1};
    const double a = irradiance(tree.glow(first), point), b = irradiance(tree.glow(second), point);
    if (!(a + b > 0)) return {};
    return Halves{first, second, a / (a + b)};
}

}  // namespace

struct BuiltCutOctree::Cell {
    Box box;
    int depth = 0;
    std::optional<LightCut> cut;  ///< none: it is divided
    double crowding = 1;          ///< see Weights
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
    double unit = 1;
    std::span<const Luminaire> luminaires;
    bool even = true;
    LightTree tree;
    std::unique_ptr<Cell> root;
    std::atomic<std::size_t> cells = 0, bytes = 0;
};

BuiltCutOctree::BuiltCutOctree(BuiltCutOctree&&) noexcept = default;
BuiltCutOctree& BuiltCutOctree::operator=(BuiltCutOctree&&) noexcept = default;
BuiltCutOctree::~BuiltCutOctree() = default;

BuiltCutOctree::BuiltCutOctree(const LightOctree& settings, const LightScene& scene)
    : state_(std::make_unique<State>()) {
    state_->rule = {settings.eta, settings.cut};
    state_->settings = settings;
    state_->luminaires = scene.luminaires;
    state_->even = std::ranges::all_of(scene.luminaires, [](const Luminaire& luminaire) {
        return std::holds_alternative<SphereEmitter>(luminaire.emitter);
    });
    state_->tree = LightTree(scene.luminaires);
    if (scene.luminaires.empty()) return;
    LightBounds lights;
    lights.box = state_->tree.box(state_->tree.root());
    Box cube = cube_to_light(scene, {&lights, 1});
    if (cube.empty()) cube = lights.box;
    state_->unit = std::fmax(max_component(cube.size()), 1e-100);
    state_->root = make(cube, 0);
}

const LightTree& BuiltCutOctree::tree() const { return state_->tree; }
const LightOctree& BuiltCutOctree::settings() const { return state_->settings; }

std::unique_ptr<BuiltCutOctree::Cell> BuiltCutOctree::make(const Box& box, int depth) const {
    auto cell = std::make_unique<Cell>();
    cell->box = box;
    cell->depth = depth;
    cell->cut.emplace(state_->tree, state_->luminaires, box, state_->rule, state_->unit);
    const double bound = divided_above * state_->rule.noise;
    if (cell->cut->noise() > bound && depth < state_->settings.max_depth)
        cell->cut.reset();
    else
        cell->crowding = crowding(*cell);
    return cell;
}

double BuiltCutOctree::crowding(const Cell& cell) const {
    // Lines from some points of the cell. The numbers are the same for each cell.
    Weights weights;
    weights.cut = &*cell.cut;
    LightPicks picks;
    LightMeetings met;
    int lines = 0;
    for (std::uint32_t i = 0; i < trials; ++i) {
        const auto number = [&](std::uint32_t n) {
            return uniform(Key{n, i, 0, 0}, Purpose::light_representative);
        };
        const Vec3 place(number(0), number(1), number(2));
        const Vec3 position = cell.box.low + place * cell.box.size();
        const ShadingPoint point{position, Vec3(0, 1, 0), true};
        weights.cut->weigh(point, weights);
        picks.clear();
        choose(point, weights, Key{3, i, 0, 0}, number(3), picks);
        if (picks.empty()) continue;
        const auto drawn =
            sample(state_->luminaires[picks.front().light], position, {number(4), number(5)});
        if (!drawn) continue;
        ++lines;
        state_->tree.along(position, drawn->direction, [&](LightIndex light) {
            meet(state_->luminaires[light], point, drawn->direction, met);
        });
    }
    return lines > 0 ? static_cast<double>(met.size()) / lines : 1;
}

std::size_t BuiltCutOctree::entries_at(const Vec3& point) const {
    return cell_at(point).cut->entries();
}

const BuiltCutOctree::Cell& BuiltCutOctree::cell_at(const Vec3& point) const {
    Cell* cell = state_->root.get();
    while (!cell->cut) {
        const Vec3 middle = cell->box.centre();
        Box part = cell->box;
        std::size_t which = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const bool upper = point[axis] >= middle[axis];
            which |= std::size_t{upper} << axis;
            (upper ? part.low : part.high)[axis] = middle[axis];
        }
        std::atomic<Cell*>& place = cell->children[which];
        Cell* child = place.load(std::memory_order_acquire);
        if (!child) {
            std::unique_ptr<Cell> made = make(part, cell->depth + 1);
            if (place.compare_exchange_strong(child, made.get(), std::memory_order_acq_rel)) {
                child = made.release();
                state_->cells += 1;
                state_->bytes += sizeof(Cell) + (child->cut ? child->cut->memory_bytes() : 0);
            }
        }
        cell = child;
    }
    return *cell;
}

void BuiltCutOctree::weigh(const ShadingPoint& point, Weights& weights) const {
    if (!state_->root) return;
    const Cell& cell = cell_at(point.position);
    weights.even = state_->even;
    weights.cut = &*cell.cut;
    weights.crowding = cell.crowding;
    weights.cut->weigh(point, weights);
}

std::uint32_t BuiltCutOctree::descend(const ShadingPoint& point, LightCluster c, const Key& key,
                                      double u, double& probability) const {
    double since_fresh = 1;
    for (std::uint64_t level = 1;; ++level) {
        const auto halves = divided(state_->tree, c, point);
        if (!halves) break;
        const double share = halves->share;
        const bool first = u < share;
        u = first ? u / share : (u - share) / (1 - share);
        u = std::fmin(u, 1 - 0x1p-53);
        const double step = first ? share : 1 - share;
        probability *= step;
        since_fresh *= step;
        c = first ? halves->first : halves->second;
        if (since_fresh < worn_out) {
            u = draw(key, Purpose::light_choice, level);
            since_fresh = 1;
        }
    }
    const std::uint32_t place = state_->tree.draw(c, u);
    probability *= state_->tree.share(c, place);
    return place;
}

void BuiltCutOctree::choose(const ShadingPoint& point, const Weights& weights, const Key& key,
                            double u, LightPicks& picks) const {
    if (!weights.cut || !(weights.total > 0)) return;
    double target = u * weights.total;
    const std::size_t entry = weights.cut->find(weights, target);
    const double weight = weights.weight[entry];
    double probability = weight / weights.total;
    const std::uint32_t place =
        descend(point, weights.cut->cluster(entry), key, target / weight, probability);
    picks.push_back(
        {state_->tree.light(place), std::fmax(probability, std::numeric_limits<double>::min())});
}

double BuiltCutOctree::expected(const ShadingPoint& point, const Weights& weights,
                                LightIndex light) const {
    if (!weights.cut || !(weights.total > 0)) return 0;
    const std::uint32_t place = state_->tree.place_of(light);
    const std::size_t entry = weights.cut->entry_of(place);
    if (entry >= weights.cut->entries()) return 0;
    LightCluster c = weights.cut->cluster(entry);
    if (!c.holds(place) || !(weights.weight[entry] > 0)) return 0;
    double probability = weights.weight[entry] / weights.total;
    while (const auto halves = divided(state_->tree, c, point)) {
        const bool first = halves->first.holds(place);
        probability *= first ? halves->share : 1 - halves->share;
        c = first ? halves->first : halves->second;
    }
    if (state_->tree.dark(c)) return 0;
    probability *= state_->tree.share(c, place);
    return probability;
}

void BuiltCutOctree::choose(const ShadingPoint& point, const Key& key, LightPicks& picks) const {
    Weights weights;
    weigh(point, weights);
    choose(point, weights, key, uniform(key, Purpose::light_choice), picks);
}

double BuiltCutOctree::expected(const ShadingPoint& point, const Key&, LightIndex light) const {
    Weights weights;
    weigh(point, weights);
    return expected(point, weights, light);
}

std::size_t BuiltCutOctree::memory_bytes() const {
    return state_->tree.memory_bytes() + state_->bytes;
}

std::size_t BuiltCutOctree::cells() const { return state_->cells; }
