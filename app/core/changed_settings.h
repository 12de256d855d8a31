#pragma once
#include <QStringList>

#include "app/core/document.h"

namespace app {

// What is to be changed in the file of the document's scene to have the scene on show. A file that the document has not
// read last is read once, when first asked for.
class ChangedSettings {
public:
    explicit ChangedSettings(const Document& document) : m_document(document) {}

    // "--set", "KEY=VALUE" for every setting, as a shell takes them; nothing where the scene has other objects or lights
    // than its file, or the file cannot be read.
    QStringList words(const pipeline::Scene& scene);

private:
    const pipeline::Scene* original(const pipeline::Scene& scene);

    const Document& m_document;
    std::optional<pipeline::Result<pipeline::Scene>> m_read;
};

}  // namespace app
