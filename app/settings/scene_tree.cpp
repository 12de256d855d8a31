#include "app/settings/scene_tree.h"

#include <algorithm>

#include <QPainter>
#include <QStyledItemDelegate>

#include "app/look/icons.h"
#include "app/widgets/follow_theme.h"

namespace app {
namespace {

constexpr int kKindRole = Qt::UserRole, kDetailRole = Qt::UserRole + 1;

QString iconName(SceneItem::Kind kind) {
    switch (kind) {
        case SceneItem::Kind::Scene: return "file";
        case SceneItem::Kind::Object: return "cube";
        case SceneItem::Kind::Material: return "material";
        case SceneItem::Kind::Light: return "light";
        case SceneItem::Kind::Ambient: return "light";
        case SceneItem::Kind::Camera: return "eye";
    }
    return "file";
}

// Nothing for a row that no view can mark.
std::optional<lessons::Selection> selectionOf(const SceneItem& item) {
    using Kind = lessons::Selection::Kind;
    switch (item.kind) {
        case SceneItem::Kind::Object: return lessons::Selection{Kind::Object, item.index};
        case SceneItem::Kind::Light: return lessons::Selection{Kind::Light, item.index};
        case SceneItem::Kind::Scene:
        case SceneItem::Kind::Material:
        case SceneItem::Kind::Ambient:
        case SceneItem::Kind::Camera: break;
    }
    return std::nullopt;
}

// Nothing for a polygon or a vertex, which have no row.
std::optional<SceneItem> itemOf(const lessons::Selection& selection) {
    using Kind = lessons::Selection::Kind;
    switch (selection.kind) {
        case Kind::Object: return SceneItem{SceneItem::Kind::Object, selection.index};
        case Kind::Light: return SceneItem{SceneItem::Kind::Light, selection.index};
        case Kind::Polygon:
        case Kind::Vertex: break;
    }
    return std::nullopt;
}

// Icon, name, and at the right the detail in small letters; parts stand a step in.
class RowPainter : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override {
        return {0, Theme::current().px(24)};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const Theme& theme = Theme::current();
        const ThemeColors& c = theme.colors();
        const auto kind = SceneItem::Kind(index.data(kKindRole).toInt());
        QRect box = option.rect.adjusted(theme.px(8), 0, -theme.px(8), 0);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        const bool isSelected = option.state & QStyle::State_Selected;
        if (isSelected || option.state & QStyle::State_MouseOver) {
            painter->setPen(Qt::NoPen);
            painter->setBrush(isSelected ? c.tint : c.hover);
            painter->drawRoundedRect(box.adjusted(1, 1, -1, -1), theme.px(4), theme.px(4));
        }
        box.adjust(theme.px(kind == SceneItem::Kind::Scene ? 6 : 16), 0, -theme.px(6), 0);
        const int side = theme.px(16);
        painter->drawPixmap(box.left(), box.center().y() - side / 2 + 1,
                            iconPixmap(iconName(kind), c.text2, side, painter->device()->devicePixelRatioF()));
        box.setLeft(box.left() + side + theme.px(8));

        painter->setFont(theme.text(13, kind == SceneItem::Kind::Scene ? 600 : 400));
        painter->setPen(c.text);
        const QString name = painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, box.width());
        painter->drawText(box, Qt::AlignVCenter, name);
        const int left = box.left() + painter->fontMetrics().horizontalAdvance(name) + theme.px(12);
        painter->setFont(theme.text(12));
        painter->setPen(isSelected ? c.text2 : c.text3);
        box.setLeft(left);
        painter->drawText(
            box, Qt::AlignVCenter | Qt::AlignRight,
            painter->fontMetrics().elidedText(index.data(kDetailRole).toString(), Qt::ElideRight, box.width()));
        painter->restore();
    }
};

}  // namespace

SceneTree::SceneTree(Document& document, QWidget* parent) : QListWidget(parent), m_document(document) {
    setObjectName("sceneTree");
    setAccessibleName(tr("Scene"));
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setMouseTracking(true);
    setItemDelegate(new RowPainter(this));
    followTheme(this, [this] { doItemsLayout(), updateGeometry(); });
    connect(this, &QListWidget::currentRowChanged, this, &SceneTree::choose);
    // The current row too: a picked pixel may have ended its selection since.
    connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { choose(row(item)); });
    connect(&document, &Document::sceneOpened, this, [this] {
        m_rows.clear();
        rebuild();
        // The first material: what one changes first.
        const auto material = std::ranges::find(m_rows, SceneItem{SceneItem::Kind::Material, 0}, &OutlineRow::item);
        setCurrentRow(material == m_rows.end() ? 0 : int(material - m_rows.begin()));
    });
    connect(&document, &Document::sceneChanged, this, &SceneTree::rebuild);
    connect(&document.pointing(), &Pointing::selectionChanged, this, &SceneTree::followSelection);
    if (document.hasScene()) rebuild();
}

QSize SceneTree::sizeHint() const {
    const int rows = std::clamp(int(m_rows.size()), 6, 12);
    return {Theme::current().px(200), rows * Theme::current().px(24) + Theme::current().px(8)};
}

// A row that no view can mark ends the selection of an object or a light. A selected polygon or vertex stays: one changes a
// material to see what becomes of it.
void SceneTree::choose(int row) {
    if (row < 0) return;
    const SceneItem item = m_rows[std::size_t(row)].item;
    Pointing& pointing = m_document.pointing();
    if (const auto thing = selectionOf(item))
        pointing.select(thing);
    else if (pointing.selection() && itemOf(*pointing.selection()))
        pointing.select(std::nullopt);
    emit selected(item);
}

// An object or a light that is selected elsewhere shows its settings.
void SceneTree::followSelection() {
    const auto& selection = m_document.pointing().selection();
    const auto item = selection ? itemOf(*selection) : std::nullopt;
    if (!item) return;
    const auto row = std::ranges::find(m_rows, *item, &OutlineRow::item);
    if (row != m_rows.end()) setCurrentRow(int(row - m_rows.begin()));
}

// Keeps the selection where the rows stand for the same things as before.
void SceneTree::rebuild() {
    std::vector<OutlineRow> rows = outline(m_document.scene());
    const bool same = std::ranges::equal(rows, m_rows, {}, &OutlineRow::item, &OutlineRow::item);
    m_rows = std::move(rows);
    if (!same) {
        const QSignalBlocker quiet(this);
        clear();
        for (std::size_t i = 0; i < m_rows.size(); ++i) addItem(QString());
        updateGeometry();
    }
    for (int i = 0; i < count(); ++i) {
        const OutlineRow& row = m_rows[std::size_t(i)];
        item(i)->setText(row.name);
        item(i)->setData(kKindRole, int(row.item.kind));
        item(i)->setData(kDetailRole, row.detail);
    }
}

}  // namespace app
