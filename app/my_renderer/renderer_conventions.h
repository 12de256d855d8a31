#pragma once
#include <QWidget>

#include "app/document/renderer_check.h"
#include "pipeline/compare/handed_in/convention_choices.h"

class QGridLayout;

namespace app {

// How somebody else's files are read, key by key of mine.toml; each can be changed by hand and put back.
class RendererConventions : public QWidget {
    Q_OBJECT
public:
    explicit RendererConventions(RendererCheck& renderer, QWidget* parent = nullptr);

    void show(const pipeline::foreign::Report& report);
    QString sentence() const { return m_sentence; }  // "4 found, read as such"

private:
    void addRow(const pipeline::foreign::ConventionChoice& choice, int row);

    RendererCheck& m_renderer;
    QGridLayout* m_grid;
    QString m_sentence;
};

}  // namespace app
