#pragma once
#include <QStringList>

#include "app/document/document.h"

namespace app {

// The settings with different values in two scenes, in the order of the table. Settings that only one scene has are
// left out.
std::vector<pipeline::SettingRef> differingSettings(const pipeline::Scene& a, const pipeline::Scene& b);

// The changes that turn the scene of the document's file into the current scene. If the document did not read the file
// last, it is read once, on first use.
class ChangedSettings {
public:
    explicit ChangedSettings(const Document& document) : m_document(document) {}

    // "--set", "KEY=VALUE" for every changed setting, as words for a shell. Empty if the scene has other objects or
    // lights than its file, or if the file cannot be read.
    QStringList words(const pipeline::Scene& scene);

private:
    const pipeline::Scene* original(const pipeline::Scene& scene);

    const Document& m_document;
    std::optional<pipeline::Result<pipeline::Scene>> m_read;
};

}  // namespace app
