// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/model_reader.h"

#include "base/elementary.h"
#include "base/long_work.h"
#include "csg/solid.h"
#include "meshing/object_mesh.h"
#include "objects/objects.h"
#include "shape/tessellation.h"
#include "text/message.h"

namespace candelabra {

namespace {

constexpr std::string_view hull_word = "convex_hull";

/// Larger meshes would exceed the memory of most machines.
constexpr double max_faces = 3e7;

/// A direction that is unlikely to be parallel to any edge of a model.
constexpr Vec3 odd_direction(0.36, 0.48, 0.8);

/// Reads points and objects in any order.
class HullReader : public SimpleReader {
public:
    HullReader(OpenBlock& block, std::vector<Vec3>& points, std::vector<ObjectHandle>& objects)
        : block_(block), points_(points), objects_(objects) {}

    bool wants() const { return block_.taken == 0; }
    bool take(const Element& element) {
        if (block_.makes_object(element)) {
            ObjectHandle made = read_object(block_.binder, element);
            block_.broken |= !made;
            if (made) objects_.push_back(std::move(made));
            return true;
        }
        if (element.kind != Element::Kind::value) return false;
        if (ObjectHandle declared = element.value.handle<Object>()) {
            objects_.push_back(std::move(declared));
            return true;
        }
        const auto point = converted(block_, element, FieldType::vector3,
                                     {[] { return std::string("a point of `convex_hull`"); },
                                      [&] { return block_.help(); }});
        if (point) points_.push_back(std::get<Vec3>(*point));
        return true;
    }

private:
    OpenBlock& block_;
    std::vector<Vec3>& points_;
    std::vector<ObjectHandle>& objects_;
};

template <std::size_t count>
bool all_finite(const std::vector<std::array<double, count>>& list) {
    return std::ranges::all_of(list, [](const std::array<double, count>& each) {
        return std::ranges::all_of(each, [](double x) { return std::isfinite(x); });
    });
}

}  // namespace

ModelReader::ModelReader(OpenBlock& block, ObjectDraft& draft, bool is_mesh)
    : block_(block), draft_(draft), is_mesh_(is_mesh) {}

void ModelReader::add_words(WordList& words) const {
    if (is_mesh_) words.insert(words.end(), {hull_word, "union", "intersection", "difference"});
}

bool ModelReader::take(const Element& element) {
    if (!is_mesh_ || element.kind != Element::Kind::block) return false;
    const bool hull = block_.spelling(element.word) == hull_word;
    if (!hull && !block_.binder.blocks.makes_object(element.word)) return false;
    if (object_ || hull_) {
        block_.report(error(Fault::misplaced, element.word_span,
                            "a `mesh` is made of one object or hull, and this is a second")
                          .with_help("mesh { union { ... } } makes one of several"));
        return true;
    }
    span_ = element.word_span;
    if (hull)
        read_hull(element);
    else
        take_object(element);
    return true;
}

void ModelReader::take_object(const Element& element) {
    object_ = read_object(block_.binder, element);
    block_.broken |= !object_;
    if (!object_) return;
    if (object_->texture) {
        draft_.texture.replace(object_->texture);
        draft_.textured = true;
    }
    draft_.made.edit().interior = object_->interior;
}

void ModelReader::read_hull(const Element& element) {
    hull_.emplace();
    OpenBlock inner(block_.binder, hull_word, element.word_span);
    inner.form = "{ points and objects, in any order }";
    HullReader reader(inner, hull_->points, hull_->objects);
    inner.read(element.body, reader);
    block_.broken |= inner.broken;
}

void ModelReader::wrong(const std::string& why) {
    Diagnostic fault = error(Fault::degenerate, object_ || hull_ ? span_ : block_.span,
                             message("this does not become a mesh: ", why));
    if (object_)
        fault = std::move(fault).with_help(
            "what becomes a mesh is closed and has an end; planes may cut it");
    block_.report(std::move(fault));
}

std::optional<Polyhedron> ModelReader::source(const TriangleMesh& asked, const Polyhedra* library) {
    Evaluator& evaluator = block_.binder.evaluator;
    if (!asked.file.empty()) {
        const auto file = evaluator.load_found(asked.file, block_.file_place());
        if (!file) return std::nullopt;
        std::optional<MeshFile> read =
            read_mesh_file(*file, evaluator.diagnostics(), block_.file_place());
        if (!read) return std::nullopt;
        look_ = std::move(read->look);
        if (look_.materials)
            block_.report(warning(Fault::no_effect, block_.file_place(),
                                  "the materials of this file are left out")
                              .with_help("the mesh has its own texture, pigment and finish"));
        return std::move(read->shape);
    }
    SolidMesh solid;
    if (object_) {
        solid = solid_mesh(*object_, asked.resolution, library);
    } else if (hull_) {
        std::vector<Polyhedron::Point> points;
        const auto add = [&](const std::vector<Vec3>& all) {
            for (const Vec3& p : all) points.push_back({p.x, p.y, p.z});
        };
        add(hull_->points);
        Solids solids;
        for (const ObjectHandle& each : hull_->objects)
            add(seen_tessellation(solids.composite(each), asked.resolution).vertices);
        constexpr std::uint64_t work_of_point = 100;
        count_long_work(work_of_point * points.size());
        solid.problem = library->hull(points, solid.polyhedron);
    } else {
        solid.polyhedron = polyhedron(as_mesh(asked));
    }
    if (solid.problem.empty()) return std::move(solid.polyhedron);
    wrong(solid.problem);
    return std::nullopt;
}

bool ModelReader::refine(Polyhedron& mesh, int steps, const Polyhedra* library) {
    const auto faces = static_cast<double>(mesh.faces.size());
    if (faces * math::pow(4.0, steps) > max_faces) {
        block_.report(error(Fault::out_of_range, block_.span,
                            message("`subdivide ", steps, "` would make more than ", max_faces,
                                    " faces of ", faces)));
        return false;
    }
    constexpr double work_of_face = 50;
    count_long_work(static_cast<std::uint64_t>(work_of_face * faces * math::pow(4.0, steps)));
    Polyhedron finer;
    const std::string why = library->subdivide(mesh, SubdivisionRule::loop, steps, finer);
    if (!why.empty()) wrong(why);
    mesh = std::move(finer);
    return why.empty();
}

std::optional<Mesh> ModelReader::made(const TriangleMesh& asked) {
    const bool triangles = !asked.triangles.empty() || !asked.smooth_triangles.empty();
    const bool file = !asked.file.empty(), modelled = object_ || hull_;
    if (file + triangles + modelled > 1) {
        block_.report(error(Fault::misplaced, block_.span,
                            "a `mesh` is made of triangles, a file, an object or a hull, not of "
                            "several of these"));
        return std::nullopt;
    }
    const bool changed = triangles && (asked.subdivide > 0 || asked.smooth);
    if (!file && !modelled && !changed) return std::nullopt;
    const bool alone = object_ && std::holds_alternative<Shape>(object_->form);
    const bool helped = (modelled && !alone) || asked.subdivide > 0;
    const Polyhedra* library =
        helped ? modelling_library(block_.binder.evaluator.diagnostics(), block_.span) : nullptr;
    std::optional<Polyhedron> mesh;
    if (library || !helped) mesh = source(asked, library);
    if (mesh && !(all_finite(mesh->points) && all_finite(look_.normals) && all_finite(look_.uvs))) {
        wrong("a point of it is not a number");
        mesh.reset();
    }
    if (mesh && asked.subdivide > 0 && !refine(*mesh, asked.subdivide, library)) mesh.reset();
    block_.broken |= !mesh;
    if (!mesh) return std::nullopt;
    Mesh result = asked.smooth ? smooth_mesh(*mesh) : candelabra::mesh(*mesh);
    if (asked.subdivide == 0) dress(result, look_);
    result.inside_vector = asked.inside_vector;
    // A mesh made from a solid remains one.
    if (!result.inside_vector && modelled) result.inside_vector = odd_direction;
    return result;
}

}  // namespace candelabra
