// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/cameras.h"

#include "appearance/normals.h"
#include "appearance/textures.h"
#include "bind/films.h"
#include "objects/model_block.h"
#include "objects/objects.h"
#include "reading/transforms.h"
#include "text/message.h"
#include "vocabulary/manual.h"

#include <map>

namespace candelabra {

namespace {

View& view_of(Camera& camera) {
    return std::visit([](auto& c) -> View& { return c; }, camera);
}

/// Reads the meshes of a mesh_camera { ... }.
class CameraMeshes : public SimpleReader {
public:
    CameraMeshes(OpenBlock& block, std::vector<CameraMesh>& meshes)
        : block_(block), meshes_(meshes) {}

    bool take(const Element& element) {
        ObjectHandle object;
        if (block_.makes_object(element))
            object = read_object(block_.binder, element);
        else if (element.kind == Element::Kind::value)
            object = element.value.handle<Object>();
        else
            return false;
        const bool block = element.kind == Element::Kind::block;
        if (!object) {
            block_.broken |= block;
            return block;
        }
        add(std::move(object), element.word_span);
        return true;
    }
    void finish() {
        if (meshes_.empty() && !block_.broken)
            block_.report(error(Fault::missing, block_.span, "`mesh_camera` needs a mesh")
                              .with_help(block_.help()));
    }
    void add_words(WordList& words) const { words.insert(words.end(), {"mesh", "mesh2"}); }

private:
    void add(ObjectHandle object, Span span) {
        const auto* shape = std::get_if<Shape>(&object->form);
        const auto* mesh = shape ? std::get_if<Shared<Mesh>>(shape) : nullptr;
        if (!mesh) {
            block_.report(
                error(Fault::wrong_type, span, "the rays of `mesh_camera` start at meshes")
                    .with_help(block_.help()));
            return;
        }
        Handle<std::vector<CameraFace>>& faces = known_[&**mesh];
        if (!faces) faces = faces_of(**mesh);
        meshes_.push_back({faces, object->transform ? *object->transform : Transform()});
        kept_.push_back(std::move(object));
    }

    static Handle<std::vector<CameraFace>> faces_of(const Mesh& mesh) {
        std::vector<CameraFace> faces;
        faces.reserve(mesh.faces.size());
        for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
            const MeshTriangle triangle = face(mesh, i);
            faces.push_back({triangle.corners, triangle.normals, face_uvs(mesh, i)});
        }
        return make_handle<std::vector<CameraFace>>(std::move(faces));
    }

    OpenBlock& block_;
    std::vector<CameraMesh>& meshes_;
    std::map<const Mesh*, Handle<std::vector<CameraFace>>> known_;
    std::vector<ObjectHandle> kept_;  ///< keeps the addresses in known_ unique
};

bool read_mesh_rays(Binder& binder, const Element& element, MeshRays& rays) {
    OpenBlock block(binder, "mesh_camera", element.word_span);
    block.form = "{ rays, distribution mesh { ... } ... [smooth] }";
    block.item = &MeshRays::vocabulary;
    ItemReader fields(block, *block.item, &rays);
    CameraMeshes meshes(block, rays.meshes);
    block.read(element.body, meshes, fields);
    if (!block.broken && rays.distribution == 0 && static_cast<int>(rays.meshes.size()) < rays.rays)
        block.report(error(Fault::wrong_count, element.word_span,
                           "with distribution 0 each ray of a pixel has a mesh of its own")
                         .with_help(block.help()));
    return !block.broken;
}

/// Reads the type, which is the first word, and the fields of all cameras.
class CameraReader {
public:
    CameraReader(OpenBlock& block, Camera& camera)
        : block_(block), camera_(camera), fields_(block, *Kinds<Camera>::infos[0], nullptr) {
        follow();
    }

    bool waiting() const { return fields_.waiting(); }
    bool wants() const { return fields_.wants() || block_.taken == 0; }

    bool take(const Element& element) {
        if (element.kind == Element::Kind::value) return take_field(element);
        const bool meshes =
            element.kind == Element::Kind::block && element.word == "mesh_camera"_word;
        const std::size_t kind = element.kind == Element::Kind::word || meshes
                                     ? Kinds<Camera>::find(block_.spelling(element.word))
                                     : Kinds<Camera>::count;
        if (kind == Kinds<Camera>::count) return take_field(element);
        if (block_.taken > 0 && !in_order()) {
            block_.report(error(Fault::misplaced, element.span,
                                message("the type `", Kinds<Camera>::infos[kind]->name,
                                        "` must come first in `camera`"))
                              .with_help(usage(*Kinds<Camera>::infos[kind], "camera")));
            return true;
        }
        const View view = view_of(camera_);
        camera_ = Kinds<Camera>::make(kind);
        view_of(camera_) = view;
        if (in_order()) settle_type();
        follow();
        if (meshes) {
            MeshRays rays;
            block_.broken |= !read_mesh_rays(block_.binder, element, rays);
            std::get<MeshCamera>(camera_).from = make_handle<MeshRays>(std::move(rays));
        }
        return true;
    }

    void finish() {
        fields_.finish();
        const auto* meshes = std::get_if<MeshCamera>(&camera_);
        if (meshes && !meshes->from && !block_.broken)
            block_.report(error(Fault::missing, block_.span, "`mesh_camera` needs meshes in braces")
                              .with_help("camera { mesh_camera { 1, 0 mesh { ... } } }"));
    }
    void add_words(WordList& words) const {
        fields_.add_words(words);
        for (const ItemInfo* info : Kinds<Camera>::infos) words.push_back(info->name);
    }

    /// Adapts the field reader to the camera's current type.
    void follow() {
        fields_.rebind(*Kinds<Camera>::infos[camera_.index()], Kinds<Camera>::address(camera_));
    }

private:
    bool take_field(const Element& element) {
        const bool taken = fields_.take(element);
        std::optional<double>& angle = view_of(camera_).angle;
        if (angle == 0.0 && in_order()) angle.reset();
        if (!taken || !in_order()) return taken;
        looked_at_ = view_of(camera_).look_at.value_or(looked_at_);
        settle(camera_);
        return true;
    }

    /// Applies the effect of the type: an orthographic camera covers as much at the look_at point
    /// as the current perspective view does.
    void settle_type() {
        settle(camera_);
        auto* parallel = std::get_if<Orthographic>(&camera_);
        if (!parallel) return;
        const double size = length(looked_at_ - parallel->location) / length(*parallel->direction);
        *parallel->right *= size;
        *parallel->up *= size;
    }

    /// Before language version 3.5 each word had its effect at once, and the type might come late.
    bool in_order() const { return block_.binder.evaluator.version() < 3.5; }

    OpenBlock& block_;
    Camera& camera_;
    ItemReader fields_;
    Vec3 looked_at_ = Vec3(0, 0, 1);
};

/// Reads the functions of a user_defined camera: location { ... } and direction { ... }.
class UserRays : public SimpleReader {
public:
    UserRays(OpenBlock& block, Camera& camera) : block_(block), camera_(camera) {}

    bool take(const Element& element) {
        auto* user = std::get_if<UserDefinedCamera>(&camera_);
        if (!user || element.kind != Element::Kind::block ||
            (element.word != "location"_word && element.word != "direction"_word))
            return false;
        OpenBlock inner(block_.binder, block_.spelling(element.word), element.word_span);
        inner.form = "{ function { ... } function { ... } function { ... } }";
        inner.item = &CameraFunctions::vocabulary;
        CameraFunctions& functions = element.word == "location"_word ? user->from : user->towards;
        functions = {};
        ItemReader fields(inner, CameraFunctions::vocabulary, &functions);
        inner.read(element.body, fields);
        block_.broken |= inner.broken;
        return true;
    }
    void add_words(WordList&) const {}

private:
    OpenBlock& block_;
    Camera& camera_;
};

/// Reads model { ... }: a camera of a model. What stands behind it may change it.
template <class Follow>
class CameraOfModel : public SimpleReader {
public:
    CameraOfModel(OpenBlock& block, Camera& camera, Follow follow)
        : block_(block), camera_(camera), follow_(follow) {}

    bool take(const Element& element) {
        const ItemInfo& info = ModelSettings::vocabulary;
        if (element.kind != Element::Kind::block || block_.spelling(element.word) != info.name)
            return false;
        OpenBlock inner(block_.binder, info.name, element.word_span);
        inner.item = &info;
        ModelSettings settings;
        ItemReader fields(inner, info, &settings);
        inner.read(element.body, fields);
        if (!inner.broken)
            if (const auto content = model_content(inner, settings))
                if (const auto placed = placed_camera(inner, *content, settings.part))
                    show(*placed);
        block_.broken |= inner.broken;
        return true;
    }
    void add_words(WordList& words) const { words.push_back(ModelSettings::vocabulary.name); }

private:
    void show(const PlacedCamera& placed) {
        const RunFacts& facts = block_.binder.evaluator.facts();
        const double aspect = static_cast<double>(facts.image_width) / facts.image_height;
        if (placed.parallel && std::holds_alternative<Perspective>(camera_)) {
            const View view = view_of(camera_);
            view_of(camera_ = Orthographic()) = view;
            follow_();
        }
        View& view = view_of(camera_);
        const double height = placed.height > 0 ? placed.height : placed.width / aspect;
        view.location = placed.location;
        view.direction = placed.direction;
        view.right = height * aspect * placed.right;
        view.up = height * placed.up;
        view.look_at.reset();
        view.angle.reset();
    }

    OpenBlock& block_;
    Camera& camera_;
    Follow follow_;
};

/// Reads normal { ... }.
class CameraNormal : public SimpleReader {
public:
    CameraNormal(OpenBlock& block, Bump& normal) : block_(block), normal_(normal) {}

    bool take(const Element& element) {
        if (element.kind != Element::Kind::block || element.word != "normal"_word) return false;
        block_.broken |= !read_normal(block_.binder, element, normal_);
        return true;
    }
    void add_words(WordList& words) const { words.push_back("normal"); }

private:
    OpenBlock& block_;
    Bump& normal_;
};

/// Reads bokeh { ... }: numbers, or a pigment.
class CameraBokeh : public SimpleReader {
public:
    CameraBokeh(OpenBlock& block, DeclaredCamera& made) : block_(block), made_(made) {}

    bool take(const Element& element) {
        if (element.kind != Element::Kind::block || element.word != "bokeh"_word) return false;
        OpenBlock inner(block_.binder, Bokeh::vocabulary.name, element.word_span);
        inner.item = &Bokeh::vocabulary;
        ItemReader fields(inner, Bokeh::vocabulary, &view_of(made_.camera).bokeh);
        made_.bokeh = nullptr;
        Picture picture(inner, made_.bokeh);
        inner.read(element.body, picture, fields);
        block_.broken |= inner.broken;
        return true;
    }
    void add_words(WordList& words) const { words.push_back("bokeh"); }

private:
    class Picture : public SimpleReader {
    public:
        Picture(OpenBlock& block, Handle<Pigment>& pigment) : block_(block), pigment_(pigment) {}

        bool take(const Element& element) {
            if (element.kind != Element::Kind::block || element.word != "pigment"_word)
                return false;
            Pigment read;
            block_.broken |= !read_pigment(block_.binder, element, read);
            pigment_ = make_handle<Pigment>(std::move(read));
            return true;
        }
        void add_words(WordList& words) const { words.push_back("pigment"); }

    private:
        OpenBlock& block_;
        Handle<Pigment>& pigment_;
    };

    OpenBlock& block_;
    DeclaredCamera& made_;
};

}  // namespace

bool read_camera(Binder& binder, const Element& element, DeclaredCamera& made) {
    Camera& camera = made.camera;
    OpenBlock block(binder, "camera", element.word_span);
    block.item = &Perspective::vocabulary;
    CameraReader fields(block, camera);
    auto declared = named<DeclaredCamera>(block, [&](const Handle<DeclaredCamera>& other) {
        made = *other;
        fields.follow();
    });
    const auto apply = [&](const Transform& transform) {
        View& view = view_of(camera);
        view.transform = view.transform.then(transform);
    };
    TransformReader moves(block, apply);
    CameraOfModel of_model(block, camera, [&] { fields.follow(); });
    CameraNormal normal(block, made.normal);
    FilmReader film(block, made.film);
    CameraBokeh bokeh(block, made);
    UserRays rays(block, camera);
    block.read(element.body, declared, of_model, rays, fields, normal, film, bokeh, moves);
    if (block.broken) return false;
    const std::string wrong = problem(camera);
    if (!wrong.empty())
        block.report(error(Fault::degenerate, element.word_span, wrong).with_help(block.help()));
    else if (is_flattened(camera))
        block.report(warning(Fault::degenerate, element.word_span,
                             "`direction`, `right` and `up` lie in one plane: this camera sees "
                             "stripes, or nothing")
                         .with_help(block.help()));
    const auto* user = std::get_if<UserDefinedCamera>(&camera);
    if (user && user->look_at && user->towards.given())
        block.report(warning(Fault::no_effect, element.word_span,
                             "`look_at` has no effect: functions give the directions of the rays")
                         .with_help(block.help()));
    return !block.broken;
}

}  // namespace candelabra
