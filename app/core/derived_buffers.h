#pragma once
#include <map>
#include <vector>

#include "app/core/derived_job.h"

namespace app {

class Document;

// The derived buffers of a document that somebody looks at, computed for each newest frame. Also the text of the
// condition and the expression. Another scene begins without a text.
class DerivedBuffers : public QObject {
    Q_OBJECT
public:
    explicit DerivedBuffers(Document& document);

    const QString& text() const { return m_text; }
    void setText(const QString& text);
    lessons::DerivedRecipe recipe() const;

    // The buffers that `who` looks at; others are not computed. Forgotten when `who` is deleted.
    void want(const QObject* who, std::vector<pipeline::BufferName> names);
    // Null if nobody wants it.
    DerivedJob* find(const pipeline::BufferName& name) const;
    // The buffer in the size of the newest frame, or null.
    const lessons::DerivedBuffer* made(const pipeline::BufferName& name) const;
    // Why a view cannot show it now, or how far it is; empty if it can.
    QString whyNot(const pipeline::BufferName& name) const;

    // "Column 3: found x, expected y": the error in the text.
    static QString sentenceOf(const pipeline::Error& error);

signals:
    void textChanged();
    void changed(const pipeline::BufferName& name);  // arrived, gone, or further on its way

private:
    void settle();  // after a change of what is wanted
    void ask();

    Document& m_document;
    QString m_text;
    std::map<const QObject*, std::vector<pipeline::BufferName>> m_wanted;
    std::map<std::string, std::unique_ptr<DerivedJob>> m_jobs;  // by name
};

}  // namespace app
