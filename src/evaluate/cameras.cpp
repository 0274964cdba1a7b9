// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/cameras.h"

#include "evaluate/normals.h"
#include "evaluate/transforms.h"
#include "text/message.h"
#include "vocabulary/manual.h"

namespace {

View& view_of(Camera& camera) {
    return std::visit([](auto& c) -> View& { return c; }, camera);
}

/// The type, as the first word, and what all cameras have.
class CameraReader {
public:
    CameraReader(OpenBlock& block, Camera& camera)
        : block_(block), camera_(camera), fields_(block, *Kinds<Camera>::infos[0], nullptr) {
        follow();
    }

    bool waiting() const { return fields_.waiting(); }
    bool wants() const { return fields_.wants() || block_.taken == 0; }

    bool take(const Element& element) {
        if (element.kind == Element::Kind::value) {
            if (fields_.take(element)) return true;
            return false;
        }
        const std::size_t kind = element.kind == Element::Kind::word
                                     ? Kinds<Camera>::find(block_.spelling(element.word))
                                     : Kinds<Camera>::count;
        if (kind == Kinds<Camera>::count) return fields_.take(element);
        if (block_.taken > 0) {
            block_.report(error(Fault::misplaced, element.span,
                                message("the type `", Kinds<Camera>::infos[kind]->name,
                                        "` must come first in `camera`"))
                              .with_help(usage(*Kinds<Camera>::infos[kind], "camera")));
            return true;
        }
        const View view = view_of(camera_);
        camera_ = Kinds<Camera>::make(kind);
        view_of(camera_) = view;
        follow();
        return true;
    }

    void finish() { fields_.finish(); }
    void add_words(WordList& words) const {
        fields_.add_words(words);
        for (const ItemInfo* info : Kinds<Camera>::infos) words.push_back(info->name);
    }

    /// The camera has another type.
    void follow() {
        fields_.rebind(*Kinds<Camera>::infos[camera_.index()], Kinds<Camera>::address(camera_));
    }

private:
    OpenBlock& block_;
    Camera& camera_;
    ItemReader fields_;
};

/// normal { ... }
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
    CameraNormal normal(block, made.normal);
    block.read(element.body, declared, fields, normal, moves);
    if (block.broken) return false;
    const std::string wrong = problem(camera);
    if (!wrong.empty())
        block.report(error(Fault::degenerate, element.word_span, wrong).with_help(block.help()));
    return !block.broken;
}
