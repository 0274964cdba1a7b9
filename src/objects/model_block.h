// SPDX-License-Identifier: GPL-3.0-or-later
// Reads what `model { }` has beside modifiers of objects: a file, a part of it, and looks of the
// scene in the place of its own. Called by the reader of objects.
#pragma once

#include "objects/imported_content.h"
#include "scene/model_settings.h"

namespace candelabra {

/// Reads `replace "material" texture { ... }`, or with `material { ... }`.
class ReplacedLookReader : public SimpleReader {
public:
    explicit ReplacedLookReader(OpenBlock& block) : block_(block) {}

    bool waiting() const { return stage_ != Stage::none; }
    bool wants() const { return stage_ != Stage::none; }
    bool take(const Element&);
    void finish();
    void add_words(WordList& words) const { words.push_back("replace"); }

    const ReplacedLooks& looks() const { return looks_; }

private:
    /// What comes next.
    enum class Stage { none, name, look };

    bool take_look(const Element&);
    std::optional<ImportedLook> look_of(const Element&);

    OpenBlock& block_;
    Stage stage_ = Stage::none;
    std::string name_;
    ReplacedLooks looks_;
};

/// The object of the block once it has been read; null after a diagnostic.
ObjectHandle model_object(OpenBlock&, const ModelSettings&, const ReplacedLooks&);

}  // namespace candelabra
