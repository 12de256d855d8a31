#include "app/settings/settings_panel.h"

#include <algorithm>

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include "app/frames/equation_symbols.h"
#include "app/look/text.h"
#include "app/settings/setting_row.h"
#include "app/widgets/follow_theme.h"

namespace app {
namespace {

using pipeline::SettingGroup;

// The tabs after the selected thing's.
constexpr std::array kGroups{SettingGroup::Shading, SettingGroup::Depth, SettingGroup::Shadow};
// More settings than this without effect are folded away.
constexpr int kMostIdleRows = 3;

QString tabName(const pipeline::Scene& scene, const SceneItem& item) {
    if (item.kind == SceneItem::Kind::Scene) return QStringLiteral("Picture");
    for (const OutlineRow& row : outline(scene)) {
        if (row.item != item) continue;
        QString name = row.name;
        name[0] = name[0].toUpper();
        return name;
    }
    return QStringLiteral("Picture");
}

}  // namespace

SettingsPanel::SettingsPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_tabs(new QTabBar(this)),
      m_scroll(new QScrollArea(this)),
      m_changed(styled(new QLabel(this), {.name = "lastChange", .tone = 2, .size = 12, .wraps = true})) {
    setObjectName("settings");
    auto* column = spaced(new QVBoxLayout(this), {}, 0);
    column->addWidget(m_tabs);
    column->addWidget(m_scroll, 1);
    column->addWidget(m_changed);

    m_tabs->addTab(QString());
    for (const SettingGroup group : kGroups) m_tabs->addTab(toQString(name(group)));
    m_tabs->setDrawBase(false);
    m_tabs->setExpanding(false);
    m_tabs->setElideMode(Qt::ElideNone);  // large letters make it scroll
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_changed->setTextFormat(Qt::RichText);
    m_changed->setContextMenuPolicy(Qt::NoContextMenu);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_tabs->setFont(theme.text(13, 500));
        m_changed->setMargin(theme.px(8));
        showLastChange();  // its link has the theme's accent in it
        build();           // what stands side by side depends on the letters' size
    });

    connect(m_tabs, &QTabBar::currentChanged, this, &SettingsPanel::build);
    connect(m_changed, &QLabel::linkActivated, this, [this] { m_document.history().stack()->undo(); });
    connect(&document, &Document::sceneOpened, this, [this] {
        const auto& scene = m_document.scene();
        select(scene.objects.empty() ? SceneItem{} : SceneItem{SceneItem::Kind::Material, 0});
    });
    connect(&document, &Document::sceneChanged, this, [this] {
        if (!isIn(m_document.scene(), m_item)) return select({});  // it has gone
        foldIdle();
        showLastChange();
    });
    // What the last change was is known only after the scene has changed.
    connect(document.history().stack(), &QUndoStack::indexChanged, this, &SettingsPanel::showLastChange);
    if (document.hasScene()) select({});
}

void SettingsPanel::select(const SceneItem& item) {
    m_item = item;
    m_tabs->setTabText(0, tabName(m_document.scene(), item));
    m_unfolded = false;
    if (m_tabs->currentIndex() == 0) return build();
    m_tabs->setCurrentIndex(0);  // builds
}

void SettingsPanel::showSetting(const QString& key) {
    const pipeline::Scene& scene = m_document.scene();
    const auto found = pipeline::findSetting(scene, key.toStdString());
    if (!found) return;
    const auto has = [&](const auto& settings) { return std::ranges::find(settings, *found) != settings.end(); };
    for (std::size_t i = 0; i < kGroups.size(); ++i)
        if (has(settingsOf(scene, kGroups[i]))) m_tabs->setCurrentIndex(int(i) + 1);
    for (const OutlineRow& row : outline(scene))
        if (has(settingsOf(scene, row.item))) select(row.item);
    // A number is typed over what the field says; others by their own control.
    QWidget* control = m_scroll->findChild<QLineEdit*>(key);
    for (QWidget* other : m_scroll->findChildren<QWidget*>(key))
        if (!control && other->focusPolicy() != Qt::NoFocus) control = other;
    if (!control) return;
    control->setFocus(Qt::OtherFocusReason);
    if (auto* field = qobject_cast<QLineEdit*>(control)) field->selectAll();
    m_scroll->ensureWidgetVisible(control);
}

std::vector<pipeline::SettingRef> SettingsPanel::settingsOnShow() const {
    const int tab = m_tabs->currentIndex();
    return tab == 0 ? settingsOf(m_document.scene(), m_item)
                    : settingsOf(m_document.scene(), kGroups[std::size_t(tab - 1)]);
}

void SettingsPanel::build() {
    if (!m_document.hasScene()) return;
    auto* page = new QWidget;
    auto* form = new QGridLayout(page);
    const Theme& theme = Theme::current();
    form->setContentsMargins(theme.px(12), theme.px(10), theme.px(12), theme.px(4));
    form->setHorizontalSpacing(theme.px(8));
    form->setVerticalSpacing(theme.px(4));
    form->setColumnStretch(1, 1);
    m_rows.clear();
    int row = 0;
    for (const pipeline::SettingRef& setting : settingsOnShow()) {
        m_rows += new SettingRow(m_document, setting, *form, row, page);
        row += 3;
    }
    m_fold = new QPushButton(page);
    m_fold->setProperty("kind", "link");
    form->addWidget(m_fold, row, 0, 1, 3);
    form->setRowStretch(row + 1, 1);
    connect(m_fold, &QPushButton::clicked, this, [this] {
        m_unfolded = !m_unfolded;
        foldIdle();
    });
    m_scroll->setWidget(page);           // deletes the page before
    page->setAutoFillBackground(false);  // the dock's surface shows
    foldIdle();
    arrange();
}

// Large letters in a narrow dock: labels stand above, in all rows alike. The scroll bar has its room whether it is there
// or not, so that what stands beside each other does not hang on it.
void SettingsPanel::arrange() {
    if (!m_scroll->widget()) return;
    const QMargins margins = m_scroll->widget()->layout()->contentsMargins();
    const int around = m_scroll->verticalScrollBar()->sizeHint().width() + margins.left() + margins.right();
    const int room = width() - around;
    const bool stacked = std::ranges::any_of(m_rows, [&](const SettingRow* row) { return row->widthBeside() > room; });
    int least = 0;
    for (SettingRow* row : m_rows) {
        row->setStacked(stacked);
        least = std::max(least, row->widthStacked());
    }
    m_scroll->setMinimumWidth(least + around);
}

void SettingsPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void SettingsPanel::foldIdle() {
    if (!m_fold) return;
    const auto idle = std::ranges::count_if(m_rows, &SettingRow::isIdle);
    const bool foldable = idle > kMostIdleRows;
    m_fold->setVisible(foldable);
    m_fold->setText(m_unfolded ? QStringLiteral("Hide these") : QStringLiteral("%1 without effect").arg(idle));
    for (SettingRow* row : m_rows) row->setShown(!row->isIdle() || !foldable || m_unfolded);
}

void SettingsPanel::showLastChange() {
    const auto change = m_document.history().lastChange();
    m_changed->setVisible(change.has_value());
    if (!change) return;
    m_changed->setText(
        QStringLiteral("%1 was %2. <a href=\"undo\" style=\"color:%3;text-decoration:none\">Put back</a> (Ctrl+Z)")
            .arg(labelWithSymbol(labelOf(change->setting)),
                 toQString(formatSetting(change->setting, change->before)).toHtmlEscaped(),
                 Theme::current().colors().accent.name()));
}

}  // namespace app
