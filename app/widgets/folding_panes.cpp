#include "app/widgets/folding_panes.h"

#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

#include "app/widgets/follow_theme.h"
#include "app/widgets/segmented.h"

namespace app {
namespace {

int leastWidth(const QWidget& pane) { return std::max(pane.minimumWidth(), pane.minimumSizeHint().width()); }

}  // namespace

FoldingPanes::FoldingPanes(const QList<QWidget*>& panes, const QStringList& names, QWidget* parent)
    : QWidget(parent),
      m_panes(panes),
      m_splitter(new QSplitter(Qt::Horizontal, this)),
      m_names(new Segmented(names, this)) {
    m_splitter->setChildrenCollapsible(false);
    for (QWidget* pane : panes) m_splitter->addWidget(pane);
    m_names->setObjectName("paneNames");
    m_names->setAccessibleName(tr("Part of the window"));
    m_names->setCurrent(0);
    m_names->hide();
    auto* column = spaced(new QVBoxLayout(this), {}, 8);
    column->addWidget(m_names);
    column->addWidget(m_splitter, 1);
    connect(m_names, &Segmented::chosen, this, &FoldingPanes::bringToFront);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_splitter->setHandleWidth(theme.px(8));
        fold();
    });
}

void FoldingPanes::setWishes(const QList<int>& px) {
    QList<int> sizes;
    for (const int wish : px) sizes += Theme::current().px(wish);
    m_splitter->setSizes(sizes);
}

void FoldingPanes::bringToFront(int pane) {
    m_front = pane;
    m_names->setCurrent(pane);
    fold();
}

void FoldingPanes::fold() {
    int least = int(m_panes.size() - 1) * m_splitter->handleWidth();
    for (const QWidget* pane : m_panes) least += leastWidth(*pane);
    m_isFolded = least > width();
    m_names->setVisible(m_isFolded);
    for (int i = 0; i < m_panes.size(); ++i) m_panes[i]->setVisible(!m_isFolded || i == m_front);
}

// Of the part that needs most: folded there is one.
QSize FoldingPanes::minimumSizeHint() const {
    QSize least;
    for (const QWidget* pane : m_panes)
        least =
            least.expandedTo({leastWidth(*pane), std::max(pane->minimumHeight(), pane->minimumSizeHint().height())});
    if (m_isFolded) least.rheight() += m_names->sizeHint().height() + layout()->spacing();
    return least;
}

void FoldingPanes::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fold();
}

}  // namespace app
