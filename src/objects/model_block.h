// SPDX-License-Identifier: GPL-3.0-or-later
// Reads what `model { }` has beside modifiers of objects: a file, a part of it, and looks of the
// scene in the place of its own. Called by the reader of objects.
#pragma once

#include "objects/imported_content.h"
#include "scene/model_settings.h"

namespace candelabra {

/// Reads `replace "material" texture { ... }`, or with `material { ... }`; and `replace "part"`
/// with an object.
class ReplacementReader : public SimpleReader {
public:
    explicit ReplacementReader(OpenBlock& block) : block_(block) {}

    bool waiting() const { return stage_ != Stage::none; }
    bool wants() const { return stage_ != Stage::none; }
    bool take(const Element&);
    void finish();
    void add_words(WordList& words) const { words.push_back("replace"); }

    const Replacements& made() const { return made_; }

private:
    /// What comes next.
    enum class Stage { none, name, look };

    bool take_own(const Element&);
    ObjectHandle object_of(const Element&);
    std::optional<ImportedLook> look_of(const Element&);

    OpenBlock& block_;
    Stage stage_ = Stage::none;
    std::string name_;
    Replacements made_;
};

/// The file of the settings; null after a diagnostic.
std::shared_ptr<ImportedContent> model_content(OpenBlock&, const ModelSettings&);

/// The object of the block once it has been read; null after a diagnostic.
ObjectHandle model_object(OpenBlock&, const ModelSettings&, const Replacements&);

}  // namespace candelabra
