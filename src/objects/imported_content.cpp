// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/imported_content.h"

#include "appearance/model_files.h"
#include "appearance/webs.h"
#include "base/degrees.h"
#include "base/long_work.h"
#include "meshing/library.h"
#include "objects/object_draft.h"
#include "photometry/light_colour.h"
#include "text/message.h"
#include "text/nearest.h"
#include "text/printable.h"

#include <algorithm>
#include <numbers>

namespace candelabra {

namespace {

/// The mesh in the space of scenes; null if it has no faces. Seen from outside, corners run the
/// other way in a mirrored space, which is how scenes have them: clockwise.
Handle<Mesh> mirrored(Mesh&& mesh) {
    if (mesh.faces.empty()) return nullptr;
    constexpr std::uint64_t points_of_step = 4;
    count_long_work((mesh.vertices.size() + mesh.faces.size()) / points_of_step);
    for (auto* list : {&mesh.vertices, &mesh.normals})
        for (Vec3& each : *list) each.z = -each.z;
    return make_handle<Mesh>(std::move(mesh));
}

/// The same for a file without parts and materials.
Handle<Mesh> mirrored(const MeshFile& file) {
    Mesh made = mesh(file.shape);
    dress(made, file.look);
    return mirrored(std::move(made));
}

/// A node's transformation in the space of scenes.
Affine mirrored(const std::array<double, 12>& m) {
    const auto row = [&](std::size_t column) {
        return Vec3(m[column], m[4 + column], -m[8 + column]);
    };
    return {{row(0), row(1), -row(2)}, row(3)};
}

/// Says once what of the file is left out.
void report_left_out(OpenBlock& block, const ImportedModel& model, const LeftOutLooks& looks) {
    std::string all;
    const auto add = [&](auto count, std::string_view what) {
        if (count > 0) all += message(all.empty() ? "" : ", ", what);
    };
    add(looks.heights, "its maps of heights");
    add(looks.dim, "the colours of materials whose light has another picture");
    add(std::ranges::count(model.meshes, true, &ImportedMesh::coloured),
        "the colours of its points");
    add(model.lights_left_out, "its lights, as the format states no units for them");
    add(model.animated ? 1 : 0, "its movements");
    if (!all.empty())
        block.report(warning(Fault::no_effect, block.file_place(),
                             message("this is left out of the model: ", all)));
    if (looks.averaged > 0)
        block.report(warning(Fault::no_effect, block.file_place(),
                             "maps of metallic and roughness in the model count by their means"));
}

using Content = std::shared_ptr<ImportedContent>;

/// The name of a profile of the model, for messages and for the text of the scene.
std::string profile_name(const ImportedModel& model, std::size_t number) {
    const std::string& file = model.profiles[number].file;
    return file.empty() ? message("light profile ", number, " of the model") : name_beside(file);
}

/// Reads a profile of lights. Its web is null, with a warning, if that cannot be done. Gamma 0 is
/// along -z of its node in the file, and C270 along x, which leaves y for C0.
WebPlace read_profile(OpenBlock& block, const ImportedModel& model, std::size_t number,
                      const std::string& path) {
    const ImportedFile& file = model.profiles[number];
    const std::string name = profile_name(model, number);
    std::string bytes = file.bytes, wrong = "it is not beside the model";
    bool is_there = file.file.empty();
    WebPlace loaded;
    loaded.aim = {0, 0, 1};
    loaded.c0 = {0, 1, 0};
    if (is_there) {
        loaded.ies = path;
        loaded.profile = static_cast<int>(number);
    }
    if (!is_there && !name.empty()) {
        auto found = block.binder.evaluator.loader().load(name, directory_of(path), FileKind::data);
        is_there = found.has_value();
        if (found) {
            bytes = std::move(found->text);
            loaded.ies = found->path;
        }
    }
    if (is_there)
        static_cast<LoadedWeb&>(loaded) = read_web(block, printable(name), bytes, 1, wrong);
    if (!loaded.web)
        block.report(warning(Fault::io, block.file_place(),
                             message("lights of the model are left out, whose measured file `",
                                     printable(name), "` cannot be read: ", wrong)));
    return loaded;
}

/// Reads a file of parts and materials.
Content read_parts(OpenBlock& block, const Found& file) {
    auto model = read_model(block, file);
    if (!model) return nullptr;
    const auto made = std::make_shared<ImportedContent>();
    made->model = std::move(model->model);
    ImportedLooks looks(block, made->model, file.path);
    for (const ImportedMaterial& material : made->model.materials)
        made->looks.push_back(looks.look(material));
    for (std::size_t i = 0; i < made->model.profiles.size(); ++i)
        made->webs.push_back(read_profile(block, made->model, i, file.path));
    report_left_out(block, made->model, looks.left_out());
    for (Mesh& each : model->meshes) made->meshes.push_back(mirrored(std::move(each)));
    made->model.pictures.clear();
    return made;
}

/// Reads a file that is one mesh.
Content read_mesh(OpenBlock& block, const Found& file) {
    const auto read =
        read_mesh_file(file, block.binder.evaluator.diagnostics(), block.file_place());
    if (!read) return nullptr;
    const auto made = std::make_shared<ImportedContent>();
    ImportedNode& root = made->model.nodes.emplace_back();
    root.transform = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    root.meshes = {0};
    made->model.meshes.emplace_back();
    made->meshes.push_back(mirrored(*read));
    return made;
}

/// A light with the intensities of a file.
void use_profile(PointLight& light, const WebPlace& profile, const LightUnits& units) {
    const double factor = light_luminance(light.colour);
    if (!profile.web || !(factor > 0)) {
        light.colour = Rgb(0);
        return;
    }
    static_cast<WebPlace&>(light) = profile;
    light.multiplier = factor;
    light.per_candela = units.intensity(factor);
    if (!measure(light).empty()) light.colour = Rgb(0);
}

PlacedLight placed_light(const ImportedLight& from, const ImportedContent& content,
                         const LightUnits& units, Span span) {
    PlacedLight placed{PointLight(), span};
    PointLight& light = placed.light;
    light.colour = {from.colour[0], from.colour[1], from.colour[2]};
    if (from.kind == ImportedLight::measured) {
        use_profile(light, content.webs[static_cast<std::size_t>(from.profile)], units);
        return placed;
    }
    if (from.kind == ImportedLight::sun) {
        // Its rays come from beyond whatever they light.
        constexpr double far = 1e6;
        light.location = {0, 0, -far};
        light.point_at = Vec3(0);
        light.parallel = true;
        light.colour *= units.colour(1);
        return placed;
    }
    if (from.kind == ImportedLight::spot) {
        constexpr double greatest = 89.9;
        light.beam = cone;
        light.falloff = std::clamp(from.outer / radians_per_degree, 0.0, greatest);
        light.radius = std::clamp(from.inner / radians_per_degree, 0.0, *light.falloff);
    }
    light.intensity = units.intensity(light_luminance(light.colour));
    if (!measure(light).empty()) light.colour = Rgb(0);
    return placed;
}

/// Makes the objects of nodes.
class Assembly {
public:
    Assembly(OpenBlock& block, const ImportedContent& content, const Replacements& replaced)
        : block_(block),
          content_(content),
          replaced_(replaced),
          meshes_(content.meshes.size()),
          parts_(content.model.nodes.size()) {}

    /// The node `first` with all that belongs to it, transformed by `movement` in the place of its
    /// own transformation if there is one, as a union; null if there is nothing in it.
    ObjectHandle object(std::size_t first, const std::optional<Affine>& movement) {
        const std::vector<ImportedNode>& nodes = content_.model.nodes;
        std::vector<char> inside(nodes.size());
        inside[first] = 1;
        for (std::size_t i = first + 1; i < nodes.size(); ++i)
            inside[i] = nodes[i].parent >= 0 && inside[static_cast<std::size_t>(nodes[i].parent)];
        // Children come after their parents, so the last ones are complete first.
        for (std::size_t i = nodes.size(); i-- > first;) {
            if (!inside[i]) continue;
            ObjectHandle made =
                part(i, i == first && movement ? *movement : mirrored(nodes[i].transform));
            if (i == first && made && !std::holds_alternative<Union>(made->form))
                made = together({std::move(made)}, Affine());
            if (i == first) return made;
            if (made) parts_[static_cast<std::size_t>(nodes[i].parent)].push_back(std::move(made));
        }
        return nullptr;
    }

private:
    ObjectHandle part(std::size_t number, const Affine& movement) {
        const ImportedNode& node = content_.model.nodes[number];
        const double volume = determinant(movement);
        if (!(volume != 0 && std::isfinite(1 / volume))) return nullptr;
        if (const auto own = replaced_.objects.find(node.name); own != replaced_.objects.end()) {
            parts_[number].clear();
            return together({own->second}, movement);
        }
        std::vector<ObjectHandle> inner;
        for (const int each : node.meshes)
            if (ObjectHandle shown = mesh_object(static_cast<std::size_t>(each)))
                inner.push_back(std::move(shown));
        if (node.light >= 0) inner.push_back(as_object(light(node.light)));
        std::vector<ObjectHandle>& children = parts_[number];
        inner.insert(inner.end(), children.rbegin(), children.rend());
        children.clear();
        if (inner.empty()) return nullptr;
        if (movement == Affine() && inner.size() == 1) return inner.front();
        return together(std::move(inner), movement);
    }

    ObjectHandle together(std::vector<ObjectHandle> inner, const Affine& movement) {
        ObjectHandle whole = block_.binder.pool.make();
        Object& object = whole.edit();
        object.span = block_.span;
        Union& all = object.form.emplace<Union>();
        for (ObjectHandle& each : inner) {
            take_lights(*each, all);
            nest(object, *each);
            all.children.push_back(std::move(each));
        }
        if (movement != Affine())
            object.transform = block_.binder.transform_pool.make(Transform(movement));
        return whole;
    }

    /// The object of a mesh, which all nodes with this mesh share; null if it has no faces.
    ObjectHandle mesh_object(std::size_t number) {
        ObjectHandle& known = meshes_[number];
        if (known || !content_.meshes[number]) return known;
        known = block_.binder.pool.make();
        Object& object = known.edit();
        object.form = Shape(Shared<Mesh>(content_.meshes[number]));
        object.span = block_.span;
        const int material = content_.model.meshes[number].material;
        if (material < 0) return known;
        const auto place = static_cast<std::size_t>(material);
        const auto other = replaced_.looks.find(content_.model.materials[place].name);
        const ImportedLook& look =
            other == replaced_.looks.end() ? content_.looks[place] : other->second;
        object.texture = look.texture;
        object.interior = look.interior;
        return known;
    }

    PlacedLight light(int number) {
        return placed_light(content_.model.lights[static_cast<std::size_t>(number)], content_,
                            block_.binder.evaluator.use_light_units(), block_.span);
    }

    OpenBlock& block_;
    const ImportedContent& content_;
    const Replacements& replaced_;
    std::vector<ObjectHandle> meshes_;
    std::vector<std::vector<ObjectHandle>> parts_;  ///< of each node: its children, last first
};

/// Whether nodes nest deeper than objects may.
bool nests_too_deeply(const ImportedModel& model, std::size_t most) {
    std::vector<std::size_t> depths(model.nodes.size());
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const int parent = model.nodes[i].parent;
        depths[i] = parent < 0 ? 0 : depths[static_cast<std::size_t>(parent)] + 1;
        if (depths[i] > most) return true;
    }
    return false;
}

/// Lists names that a word may be, for a message: the nearest one, or the first ones.
std::string names_help(std::string_view wanted, const std::vector<std::string_view>& names) {
    if (const std::string near = nearest(wanted, names); !near.empty())
        return message("did you mean \"", printable(near), "\"?");
    constexpr std::size_t most = 12;
    std::string all;
    for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
        all += message(i > 0 ? ", \"" : "\"", printable(names[i]), '"');
    if (names.empty()) return "the file has no names";
    return message("the file has ", all, names.size() > most ? " and others" : "");
}

std::vector<std::string_view> names_of(const std::vector<ImportedNode>& nodes) {
    std::vector<std::string_view> names;
    for (const ImportedNode& node : nodes)
        if (!node.name.empty()) names.push_back(node.name);
    return names;
}

/// Reports what the file does not have.
void report_unknown(OpenBlock& block, std::string_view what, std::string_view name,
                    const std::vector<std::string_view>& names) {
    block.report(error(Fault::unknown_name, block.span,
                       message("the model has no ", what, " \"", printable(name), '"'))
                     .with_help(names_help(name, names)));
}

/// Reports names of materials and parts that the file does not have.
void check_names(OpenBlock& block, const ImportedModel& model, const Replacements& replaced) {
    const auto check = [&](std::string_view what, const auto& named,
                           const std::vector<std::string_view>& names) {
        for (const auto& [name, made] : named)
            if (std::ranges::find(names, name) == names.end())
                report_unknown(block, what, name, names);
    };
    std::vector<std::string_view> materials;
    for (const ImportedMaterial& material : model.materials) materials.push_back(material.name);
    check("material", replaced.looks, materials);
    if (!replaced.objects.empty()) check("part", replaced.objects, names_of(model.nodes));
}

}  // namespace

Content imported_content(OpenBlock& block, const std::string& file) {
    Evaluator& evaluator = block.binder.evaluator;
    const Span place = block.file_place();
    Content& known =
        block.binder.models[{directory_of(evaluator.sources().name(place.source)), file}];
    if (known) return known;
    const auto found = evaluator.load_found(file, place);
    if (!found) return nullptr;
    return known = has_parts(found->path) ? read_parts(block, *found) : read_mesh(block, *found);
}

std::optional<PlacedCamera> placed_camera(OpenBlock& block, const ImportedContent& content,
                                          const std::string& name) {
    const std::vector<ImportedNode>& nodes = content.model.nodes;
    const auto camera_of = [&](std::size_t node) -> const ImportedCamera& {
        return content.model.cameras[static_cast<std::size_t>(nodes[node].camera)];
    };
    std::vector<std::string_view> names;
    std::optional<std::size_t> found, inside;
    std::vector<char> below(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const int parent = nodes[i].parent;
        below[i] =
            nodes[i].name == name || (parent >= 0 && below[static_cast<std::size_t>(parent)]);
        if (nodes[i].camera < 0) continue;
        const std::string& own = camera_of(i).name;
        const std::string& called = nodes[i].name.empty() ? own : nodes[i].name;
        if (!called.empty()) names.push_back(called);
        if (!found && (name.empty() || nodes[i].name == name || own == name)) found = i;
        if (!inside && below[i]) inside = i;
    }
    if (!found) found = inside;
    if (!found) {
        const std::string called =
            name.empty() || names.empty() ? "" : message(" \"", printable(name), '"');
        block.report(error(Fault::unknown_name, block.file_place(),
                           message("the model has no camera", called))
                         .with_help(names.empty() ? "camera { location <0, 2, -6> look_at 0 }"
                                                  : names_help(name, names)));
        return std::nullopt;
    }
    Affine whole = mirrored(nodes[*found].transform);
    for (int i = nodes[*found].parent; i >= 0; i = nodes[static_cast<std::size_t>(i)].parent) {
        const Affine outer = mirrored(nodes[static_cast<std::size_t>(i)].transform);
        for (Vec3& row : whole.rows) row = outer.direction(row);
        whole.translation = outer.point(whole.translation);
    }
    const ImportedCamera& from = camera_of(*found);
    const auto in_scene = [](const std::array<double, 3>& v) { return Vec3(v[0], v[1], -v[2]); };
    PlacedCamera made;
    made.location = whole.point(in_scene(from.location));
    made.direction = unit(whole.direction(in_scene(from.direction)));
    const Vec3 up = whole.direction(in_scene(from.up));
    made.right = unit(cross(up, made.direction));
    made.up = cross(made.direction, made.right);
    made.parallel = from.parallel;
    made.width = from.width;
    made.height = from.height;
    if (made.right != Vec3(0) && std::isfinite(dot(made.location, made.location))) return made;
    block.report(
        error(Fault::degenerate, block.file_place(), "the camera of the model has no direction"));
    return std::nullopt;
}

ObjectHandle imported_object(OpenBlock& block, const ImportedContent& content,
                             const std::string& part, const Replacements& replaced) {
    const std::vector<ImportedNode>& nodes = content.model.nodes;
    check_names(block, content.model, replaced);
    if (nests_too_deeply(content.model, block.binder.evaluator.limits().nesting))
        block.report(error(Fault::recursion_limit, block.file_place(),
                           "the parts of the model are nested too deeply"));
    if (block.broken) return nullptr;
    std::size_t first = 0;
    std::optional<Affine> movement;
    if (!part.empty()) {
        const auto found = std::ranges::find(nodes, part, &ImportedNode::name);
        if (found == nodes.end()) {
            report_unknown(block, "part", part, names_of(nodes));
            return nullptr;
        }
        first = static_cast<std::size_t>(found - nodes.begin());
        Affine whole = mirrored(found->transform);
        for (int i = found->parent; i >= 0; i = nodes[static_cast<std::size_t>(i)].parent) {
            const Affine outer = mirrored(nodes[static_cast<std::size_t>(i)].transform);
            for (Vec3& row : whole.rows) row = outer.direction(row);
        }
        whole.translation = Vec3(0);
        movement = whole;
    }
    ObjectHandle made =
        nodes.empty() ? nullptr : Assembly(block, content, replaced).object(first, movement);
    if (!made)
        block.report(error(Fault::missing, block.file_place(), "there is nothing in the model"));
    return made;
}

}  // namespace candelabra
