#pragma once
#include <map>
#include <vector>

#include "app/core/derived_job.h"

namespace app {

class Document;

// The derived buffers of a document's frame that somebody looks at, each of the newest frame as soon as it is made; and
// the text that a condition and an expression are made after. Another scene begins without a text.
class DerivedBuffers : public QObject {
    Q_OBJECT
public:
    explicit DerivedBuffers(Document& document);

    const QString& text() const { return m_text; }
    void setText(const QString& text);
    lessons::DerivedRecipe recipe() const;

    // What `who` looks at. What nobody does is not made. Forgotten with `who`.
    void want(const QObject* who, std::vector<pipeline::BufferName> names);
    // Null where nobody wants it.
    DerivedJob* find(const pipeline::BufferName& name) const;
    // Made of the newest frame's size, or null.
    const lessons::DerivedBuffer* made(const pipeline::BufferName& name) const;
    // Why a view cannot show it now, with what is on its way; empty where it can.
    QString whyNot(const pipeline::BufferName& name) const;

    // "Column 3: found x, expected y": what is wrong in the text.
    static QString sentenceOf(const pipeline::Error& error);

signals:
    void textChanged();
    void changed(const pipeline::BufferName& name);  // it came, or went, or is farther on its way

private:
    void settle();  // who wants what has changed
    void ask();

    Document& m_document;
    QString m_text;
    std::map<const QObject*, std::vector<pipeline::BufferName>> m_wanted;
    std::map<std::string, std::unique_ptr<DerivedJob>> m_jobs;  // by name
};

}  // namespace app
