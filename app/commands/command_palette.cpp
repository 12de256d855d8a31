#include "app/commands/command_palette.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QStyledItemDelegate>

#include "app/look/word_match.h"
#include "app/widgets/follow_theme.h"

namespace app {
namespace {

constexpr int kPlaceRole = Qt::UserRole, kRightRole = Qt::UserRole + 1, kOffRole = Qt::UserRole + 2;

// Name and place at the left; at the right the key, or why it cannot be done.
class CommandPainter : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override {
        return {0, Theme::current().px(32)};
    }
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const Theme& theme = Theme::current();
        const ThemeColors& c = theme.colors();
        painter->save();
        if (option.state & QStyle::State_Selected) painter->fillRect(option.rect, c.tint);
        QRect box = option.rect.adjusted(theme.px(14), 0, -theme.px(14), 0);
        const bool off = index.data(kOffRole).toBool();
        const auto write = [&](const QString& text, const QFont& font, const QColor& color, Qt::Alignment side) {
            painter->setFont(font);
            painter->setPen(color);
            const QString fitting = painter->fontMetrics().elidedText(text, Qt::ElideRight, box.width());
            painter->drawText(box, int(side | Qt::AlignVCenter), fitting);
            return painter->fontMetrics().horizontalAdvance(fitting) + theme.px(10);
        };
        box.setLeft(box.left() + write(index.data().toString(), theme.text(), off ? c.text3 : c.text, Qt::AlignLeft));
        box.setLeft(box.left() + write(index.data(kPlaceRole).toString(), theme.text(12), c.text3, Qt::AlignLeft));
        write(index.data(kRightRole).toString(), theme.text(12), off ? c.text2 : c.text3, Qt::AlignRight);
        painter->restore();
    }
};

}  // namespace

int matchQuality(const QString& typed, const QString& name) {
    if (typed.isEmpty()) return 1;
    if (QString(name).remove(QChar(0x2026)).compare(typed, Qt::CaseInsensitive) == 0) return 2000;
    const qsizetype whole = name.indexOf(typed, 0, Qt::CaseInsensitive);
    if (whole == 0) return 1000;
    if (whole > 0) return name[whole - 1].isLetterOrNumber() ? 500 : 800;
    switch (matchWords(typed, name)) {
        case WordMatch::Beginnings: return 600;
        case WordMatch::Inside: return 400;
        case WordMatch::None: break;
    }
    qsizetype from = 0;
    int quality = 100;
    for (const QChar letter : typed) {
        const qsizetype at = name.indexOf(letter, from, Qt::CaseInsensitive);
        if (at < 0) return 0;
        quality -= int(std::min<qsizetype>(at - from, 5));
        from = at + 1;
    }
    return std::max(1, quality);
}

int matchQuality(const QString& typed, const PaletteEntry& entry) {
    constexpr int kInPlace = 300, kByWords = 550;
    const bool inPlace = !typed.isEmpty() && matchWords(typed, entry.place + ' ' + entry.name) != WordMatch::None;
    const bool byWords = !typed.isEmpty() && matchWords(typed, entry.words) == WordMatch::Beginnings;
    return std::max({matchQuality(typed, entry.name), byWords ? kByWords : 0, inPlace ? kInPlace : 0});
}

CommandPalette::CommandPalette(QWidget* window)
    : Popover(window),
      m_field(new QLineEdit(this)),
      m_list(new QListWidget(this)),
      m_count(new QLabel(this)),
      m_none(new QLabel(tr("No match"), this)) {
    setObjectName("commandPalette");
    m_field->setObjectName("commandField");
    m_field->setPlaceholderText(tr("Find an action, a buffer, a scene, a lesson or a setting"));
    m_field->setAccessibleName(tr("Run a command"));
    m_field->installEventFilter(this);
    m_list->setItemDelegate(new CommandPainter(this));
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_count->setProperty("tone", 3);
    m_none->setProperty("tone", 2);
    m_none->setAlignment(Qt::AlignCenter);
    auto* hint = new QLabel(tr("Enter runs    arrows move    Esc closes"), this);
    hint->setProperty("tone", 2);
    auto* top = new QHBoxLayout;
    top->addWidget(m_field, 1);
    top->addWidget(m_count);
    auto* column = spaced(new QVBoxLayout(this), {1, 12, 1, 8});
    column->addLayout(top);
    column->addWidget(m_list, 1);
    column->addWidget(m_none, 1);
    column->addWidget(hint);
    followTheme(this, [this, column, hint] {
        const Theme& theme = Theme::current();
        for (QLabel* label : {m_count, hint}) {
            label->setFont(theme.text(12));
            label->setContentsMargins(theme.px(14), 0, theme.px(14), 0);
        }
        m_field->setFont(theme.text(15));
        m_field->setMinimumHeight(theme.px(30));
        static_cast<QHBoxLayout*>(column->itemAt(0)->layout())->setContentsMargins(theme.px(12), 0, 0, 0);
        if (isVisible()) place();
    });
    connect(m_field, &QLineEdit::textChanged, this, &CommandPalette::filter);
    connect(m_list, &QListWidget::itemClicked, this, &CommandPalette::run);
    // The list never has the focus: the field tells where the arrows have come to.
    connect(m_list, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* now) {
        QStringList words;
        words << (now ? QString() : m_none->text());
        if (now) words << now->text() << now->data(kPlaceRole).toString() << now->data(kRightRole).toString();
        words.removeAll(QString());
        m_field->setAccessibleDescription(words.join(QStringLiteral(", ")));
    });
}

QSize CommandPalette::sizeHint() const { return {Theme::current().px(640), Theme::current().px(420)}; }

void CommandPalette::open(std::vector<PaletteEntry> commands) {
    m_commands = std::move(commands);
    m_field->clear();
    filter();
    Popover::open(m_field);
}

void CommandPalette::filter() {
    const QString typed = m_field->text().trimmed();
    std::vector<std::pair<int, std::size_t>> found;
    for (std::size_t i = 0; i < m_commands.size(); ++i)
        if (const int quality = matchQuality(typed, m_commands[i])) found.emplace_back(quality, i);
    std::ranges::stable_sort(found, std::greater{}, [](const auto& entry) { return entry.first; });
    m_shown.clear();
    m_list->clear();
    for (const auto& [quality, i] : found) {
        const PaletteEntry& command = m_commands[i];
        m_shown.push_back(i);
        auto* item = new QListWidgetItem(command.name, m_list);
        item->setData(kPlaceRole, command.place);
        item->setData(kRightRole, command.whyNot.isEmpty() ? command.keys : command.whyNot);
        item->setData(kOffRole, !command.whyNot.isEmpty());
    }
    m_list->setCurrentRow(0);
    m_list->setVisible(!m_shown.empty());
    m_none->setVisible(m_shown.empty());
    m_count->setText(tr("%1 of %2").arg(m_shown.size()).arg(m_commands.size()));
}

void CommandPalette::run() {
    const int row = m_list->currentRow();
    if (row < 0) return;
    const PaletteEntry command = m_commands[m_shown[std::size_t(row)]];
    if (!command.whyNot.isEmpty()) return;
    close();
    command.run();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_field && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int step = key == Qt::Key_Down       ? 1
                         : key == Qt::Key_Up       ? -1
                         : key == Qt::Key_PageDown ? 8
                         : key == Qt::Key_PageUp   ? -8
                                                   : 0;
        if (step != 0) {
            m_list->setCurrentRow(std::clamp(m_list->currentRow() + step, 0, std::max(0, m_list->count() - 1)));
            return true;
        }
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            run();
            return true;
        }
    }
    return Popover::eventFilter(watched, event);
}

}  // namespace app
