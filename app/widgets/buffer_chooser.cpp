#include "app/widgets/buffer_chooser.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/frames/derived_buffers.h"
#include "app/look/icons.h"
#include "app/look/text.h"
#include "app/look/word_match.h"
#include "app/widgets/follow_theme.h"
#include "pipeline/plan/needs.h"

namespace app {

using pipeline::BufferName;

BufferChooser::BufferChooser(const Document& document, QWidget* parent)
    : QToolButton(parent),
      m_document(document),
      m_popup(new QFrame(this, Qt::Popup)),
      m_field(new QLineEdit(m_popup)),
      m_list(new QTreeWidget(m_popup)) {
    setAccessibleName(tr("Buffer"));
    setToolTip(tr("Choose a buffer"));
    connect(this, &QToolButton::clicked, this, &BufferChooser::open);

    m_popup->setProperty("kind", "panel");
    auto* column = new QVBoxLayout(m_popup);
    column->setContentsMargins(8, 8, 8, 8);
    column->addWidget(m_field);
    column->addWidget(m_list);
    m_field->setPlaceholderText(tr("Type a part of the name"));
    m_field->setAccessibleName(tr("Filter of buffers"));
    m_field->installEventFilter(this);
    m_list->setColumnCount(2);
    m_list->setHeaderHidden(true);
    m_list->setRootIsDecorated(false);
    m_list->setIndentation(0);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->header()->setStretchLastSection(true);
    connect(m_field, &QLineEdit::textChanged, this, &BufferChooser::filter);
    connect(m_field, &QLineEdit::returnPressed, this, &BufferChooser::accept);
    connect(m_list, &QTreeWidget::itemClicked, this, &BufferChooser::accept);
    // The list never has the focus: the field tells where the arrows have come to.
    connect(m_list, &QTreeWidget::currentItemChanged, this,
            [this](const QTreeWidgetItem* now) { m_field->setAccessibleDescription(now ? now->text(0) : QString()); });
    followTheme(this, [this] {
        setFont(Theme::current().mono(13));
        updateGeometry();
        m_popup->resize(Theme::current().px(520), Theme::current().px(440));
    });
}

void BufferChooser::setName(const BufferName& name) {
    m_name = name;
    setText(toQString(name.text()));
    updateGeometry();
}

QSize BufferChooser::sizeHint() const {
    const Theme& theme = Theme::current();
    return {fontMetrics().horizontalAdvance(text()) + theme.px(30), theme.px(24)};
}

// The name, then the chevron.
void BufferChooser::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(hasFocus() ? QPen(c.focus, 2) : QPen(Qt::NoPen));
    painter.setBrush(underMouse() ? c.hover : c.surface);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
    painter.setPen(c.text);
    const int side = theme.px(12), padding = theme.px(6);
    const QRect name = rect().adjusted(padding, 0, -side - padding, 0);
    painter.drawText(name, Qt::AlignVCenter | Qt::AlignLeft,
                     fontMetrics().elidedText(text(), Qt::ElideMiddle, name.width()));
    app::icon("chevron-down").paint(&painter, QRect(width() - side - padding, (height() - side) / 2, side, side));
}

void BufferChooser::open() {
    fill();
    m_field->clear();
    filter({});
    m_popup->move(mapToGlobal(QPoint(0, height() + 2)));
    m_popup->show();
    m_field->setFocus();
}

void BufferChooser::fill() {
    m_list->clear();
    if (!m_document.hasScene()) return;
    const Theme& theme = Theme::current();
    const auto addGroup = [&](const QString& text) {
        auto* group = new QTreeWidgetItem(m_list, {text});
        group->setFlags(Qt::NoItemFlags);
        group->setFont(0, theme.text(12, 600));
    };
    const auto add = [&](const BufferName& name, const QString& useless) {
        auto* item = new QTreeWidgetItem(
            m_list, {toQString(name.text()), useless.isEmpty() ? toQString(bufferInfo(name.id).meaning) : useless});
        item->setFont(0, theme.mono(13));
        item->setFont(1, theme.text(12));
        item->setForeground(1, useless.isEmpty() ? theme.colors().text2 : theme.colors().text3);
        item->setToolTip(1, item->text(1));
        item->setData(0, Qt::UserRole, item->text(0));
        if (name == m_name) m_list->setCurrentItem(item);
    };
    const pipeline::Scene& scene = m_document.scene();
    auto stage = pipeline::StageId::Shading;
    for (const BufferName& name : pipeline::allBuffers(scene.lights.size())) {
        const pipeline::BufferInfo& info = bufferInfo(name.id);
        if (m_list->topLevelItemCount() == 0 || info.stage != stage) {
            stage = info.stage;
            addGroup(toQString(pipeline::stageInfo(stage).label));
        }
        const std::string useless = whyUseless(scene, name.id);
        add(name, useless.empty() ? QString() : tr("left out: ") + toQString(useless));
    }
    addGroup(tr("Derived"));
    for (const BufferName& name : pipeline::allDerived(scene.lights.size())) {
        const auto buffers = buffersFor(name, m_document.derived().recipe(), scene);
        add(name, buffers ? QString() : toQString(buffers.errors().front().found));
    }
    m_list->resizeColumnToContents(0);
}

void BufferChooser::filter(const QString& text) {
    QTreeWidgetItem* first = nullptr;
    QTreeWidgetItem* group = nullptr;
    for (int i = 0; i < m_list->topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = m_list->topLevelItem(i);
        if (item->data(0, Qt::UserRole).isNull()) {
            group = item;
            group->setHidden(true);
            continue;
        }
        const bool fits = matchWords(text, item->text(0)) != WordMatch::None;
        item->setHidden(!fits);
        if (fits && group) group->setHidden(false);
        if (fits && !first) first = item;
    }
    if (!text.isEmpty() || !m_list->currentItem()) m_list->setCurrentItem(first);
    if (m_list->currentItem()) m_list->scrollToItem(m_list->currentItem(), QAbstractItemView::PositionAtCenter);
}

void BufferChooser::accept() {
    const QTreeWidgetItem* item = m_list->currentItem();
    if (!item || item->isHidden()) return;
    const auto name = pipeline::findAnyBuffer(item->data(0, Qt::UserRole).toString().toStdString());
    if (!name) return;
    m_popup->hide();
    emit chosen(*name);
}

bool BufferChooser::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_field && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
        for (int i = m_list->indexOfTopLevelItem(m_list->currentItem()) + step;
             step != 0 && i >= 0 && i < m_list->topLevelItemCount(); i += step) {
            QTreeWidgetItem* item = m_list->topLevelItem(i);
            if (item->isHidden() || item->data(0, Qt::UserRole).isNull()) continue;
            m_list->setCurrentItem(item);
            break;
        }
        if (step != 0) return true;
    }
    return QToolButton::eventFilter(watched, event);
}

}  // namespace app
