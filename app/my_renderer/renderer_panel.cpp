#include "app/my_renderer/renderer_panel.h"

#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/my_renderer/renderer_body.h"
#include "app/my_renderer/renderer_head.h"
#include "app/widgets/follow_theme.h"

namespace app {

namespace {

QVBoxLayout* tightColumn(QWidget* parent) {
    auto* column = spaced(new QVBoxLayout(parent), {}, 0);
    return column;
}

}  // namespace

RendererPanel::RendererPanel(Document& document, QWidget* parent) : QWidget(parent), m_finding(document) {
    setObjectName("rendererPanel");
    setAccessibleName(tr("My renderer"));
    setFocusPolicy(Qt::StrongFocus);
    auto* scroll = new QScrollArea(this);
    auto* content = new QWidget(scroll);
    QVBoxLayout* column = tightColumn(content);
    m_empty = makeEmpty();
    m_parts = makeParts();
    column->addWidget(m_empty, 1);
    column->addWidget(m_parts, 1);
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    content->setAutoFillBackground(false);
    tightColumn(this)->addWidget(scroll);
    connect(&m_finding.check(), &RendererCheck::changed, this, &RendererPanel::showState);
    connect(&m_finding, &RendererFinding::changed, this, &RendererPanel::showState);
    showState();
}

QWidget* RendererPanel::makeEmpty() {
    auto* all = new QWidget(this);
    auto* rows = spaced(new QVBoxLayout(all), {12, 12, 12, 12}, 8);
    auto* heading = rendererText("rendererDrop", 15, 600, all);
    heading->setText(tr("Drop the folder of your renderer here"));
    auto* what = rendererText("rendererWhat", 13, 400, all);
    what->setText(tr(
        "Shadescope compares what your renderer has written with this scene, and says which stage is the first that is "
        "wrong. Any of these files is enough: color.png, depth.npy, normal.npy, …"));
    auto* folder = rendererButton(tr("Choose a folder…"), "chooseFolder", all);
    folder->setProperty("kind", "primary");
    auto* files = rendererButton(tr("Choose files…"), "chooseFiles", all);
    auto* starter = rendererText("rendererStarter", 12, 400, all);
    starter->setProperty("tone", 2);
    starter->setText(
        tr("No files yet? shadescope compare --starter python -o mine writes a scene and a writer of files."));
    for (QWidget* part : std::initializer_list<QWidget*>{heading, what, folder, files, starter}) rows->addWidget(part);
    rows->addStretch(1);
    connect(folder, &QPushButton::clicked, this, &RendererPanel::folderAsked);
    connect(files, &QPushButton::clicked, this, &RendererPanel::filesAsked);
    return all;
}

QWidget* RendererPanel::makeParts() {
    auto* all = new QWidget(this);
    auto* head = new RendererHead(m_finding, all);
    auto* body = new RendererBody(m_finding, all);
    QVBoxLayout* column = tightColumn(all);
    column->addWidget(head);
    column->addWidget(body, 1);
    column->addStretch(0);  // below the head while there is nothing to say yet
    connect(head, &RendererHead::folderAsked, this, &RendererPanel::folderAsked);
    connect(body, &RendererBody::lessonAsked, this, &RendererPanel::lessonAsked);
    return all;
}

void RendererPanel::showState() {
    m_empty->setVisible(!m_finding.check().isOpen());
    m_parts->setVisible(m_finding.check().isOpen());
}

void RendererPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_finding.check().setFollowed(true);
}

void RendererPanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    m_finding.check().setFollowed(false);
}

void RendererPanel::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy)) return m_finding.copy();
    if (event->key() == Qt::Key_W && event->modifiers() == Qt::NoModifier) return m_finding.goToWorst();
    if (event->key() == Qt::Key_F5) return m_finding.check().readAgain();
    QWidget::keyPressEvent(event);
}

}  // namespace app
