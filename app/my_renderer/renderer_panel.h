#pragma once
#include <QWidget>

#include "app/my_renderer/renderer_finding.h"

namespace app {

// Somebody else's renderer beside this one: which stage is the first that is wrong, what the error is called, and where to
// look. As much of that as the hints give away.
class RendererPanel : public QWidget {
    Q_OBJECT
public:
    explicit RendererPanel(Document& document, QWidget* parent = nullptr);

    RendererFinding& finding() { return m_finding; }

signals:
    void folderAsked();
    void filesAsked();
    void lessonAsked(const QString& lesson, const QString& heading);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* makeEmpty();
    QWidget* makeParts();
    void showState();

    RendererFinding m_finding;
    QWidget *m_empty, *m_parts;
};

}  // namespace app
