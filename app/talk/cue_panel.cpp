#include "app/talk/cue_panel.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPainter>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QToolButton>

#include "app/document/session_file.h"
#include "app/look/icons.h"
#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"

namespace app {
namespace {

// Two lines: number and name, bold for the cue on show, and where it stands.
class CueRow : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override {
        return {Theme::current().px(120), Theme::current().px(42)};
    }
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const Theme& theme = Theme::current();
        const bool current = index.data(CueModel::CurrentRole).toBool();
        painter->save();
        if (option.state & (QStyle::State_Selected | QStyle::State_MouseOver))
            painter->fillRect(option.rect,
                              option.state & QStyle::State_Selected ? theme.colors().tint : theme.colors().hover);
        const QRect inner = option.rect.adjusted(theme.px(10), theme.px(3), -theme.px(8), -theme.px(3));
        if (current)
            painter->fillRect(QRect(option.rect.left(), option.rect.top(), theme.px(3), option.rect.height()),
                              theme.colors().accent);
        const auto line = [&](const QFont& font, const QColor& color, const QString& text, Qt::Alignment where) {
            painter->setFont(font);
            painter->setPen(color);
            painter->drawText(inner, int(where), QFontMetrics(font).elidedText(text, Qt::ElideRight, inner.width()));
        };
        line(theme.text(13, current ? 600 : 500), theme.colors().text, index.data().toString(),
             Qt::AlignTop | Qt::AlignLeft);
        line(theme.text(12), theme.colors().text2, index.data(CueModel::PlaceRole).toString(),
             Qt::AlignBottom | Qt::AlignLeft);
        painter->restore();
    }
};

}  // namespace

CuePanel::CuePanel(Document& document, QWidget* parent)
    : QWidget(parent),
      m_model(new CueModel(SessionFile::usualFolder() + "/talk" + lessons::kCueEnding, this)),
      m_list(new QListView(this)) {
    Q_UNUSED(document)
    setObjectName("cues");
    m_list->setModel(m_model);
    m_list->setItemDelegate(new CueRow(m_list));
    m_list->setAccessibleName(tr("Cues"));
    m_list->setObjectName("cueList");
    m_list->setDragDropMode(QAbstractItemView::InternalMove);
    m_list->setDefaultDropAction(Qt::MoveAction);
    m_list->setDragDropOverwriteMode(false);
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_list->setMouseTracking(true);
    m_list->installEventFilter(this);
    m_empty = styled(new QLabel(tr("No cues yet. Ctrl+B keeps what you see as a cue."), this),
                     {.tone = 3, .size = 13, .wraps = true});
    m_empty->setAlignment(Qt::AlignCenter);
    m_putBack = new QPushButton(this);
    m_putBack->setProperty("kind", "link");
    m_putBack->setText(tr("Put the removed cue back"));
    connect(m_putBack, &QPushButton::clicked, m_model, &CueModel::putBack);
    auto* column = spaced(new QVBoxLayout(this), {}, 0);
    column->addWidget(makeHead());
    column->addWidget(m_empty, 1);
    column->addWidget(m_list, 2);
    column->addWidget(m_putBack, 0, Qt::AlignLeft);
    column->addWidget(makeEditor(), 1);
    connect(m_list, &QListView::clicked, this, [this](const QModelIndex& row) { emit asked(row.row()); });
    connect(m_model, &CueModel::changed, this, &CuePanel::showCurrent);
    followTheme(this, [this] { m_list->doItemsLayout(); });
    showCurrent();
}

QWidget* CuePanel::makeHead() {
    auto* head = new QWidget(this);
    auto* row = spaced(new QHBoxLayout(head), {10, 2, 4, 4});
    m_title = styled(new QLabel(head), {.tone = 2, .size = 12});
    m_present = new QPushButton(tr("Present"), head);
    m_present->setToolTip(tr("Shows the cues on the whole screen (Ctrl+F11)."));
    connect(m_present, &QPushButton::clicked, this, &CuePanel::presentAsked);
    auto* more = new QToolButton(head);
    more->setIcon(icon("more"));
    more->setAccessibleName(tr("More about the cues"));
    more->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(more);
    menu->addAction(tr("Keep what you see as a cue"), this, &CuePanel::keepAsked);
    QAction* replace = menu->addAction(tr("Replace this cue by what you see"), this, &CuePanel::replaceAsked);
    menu->addSeparator();
    menu->addAction(tr("Open a list…"), this, &CuePanel::openAsked);
    QAction* again = menu->addAction(tr("Read the list again"), m_model, &CueModel::readAgain);
    menu->addAction(tr("Save the list as…"), this, &CuePanel::saveAsAsked);
    menu->addAction(tr("New list"), m_model, &CueModel::clear);
    menu->addSeparator();
    menu->addAction(tr("How long the talk is…"), this, [this] {
        bool taken = false;
        const int minutes =
            QInputDialog::getInt(this, tr("The talk"), tr("Minutes"), m_model->list().minutes, 1, 600, 5, &taken);
        if (taken) m_model->setMinutes(minutes);
    });
    connect(menu, &QMenu::aboutToShow, this, [this, replace, again] {
        replace->setEnabled(m_model->current() >= 0);
        again->setEnabled(QFileInfo::exists(m_model->file()));
    });
    more->setMenu(menu);
    row->addWidget(m_title, 1);
    row->addWidget(m_present);
    row->addWidget(more);
    followTheme(head, [this, more] {
        const Theme& theme = Theme::current();
        m_present->setFont(theme.text(12, 500));
        more->setIconSize(QSize(theme.px(16), theme.px(16)));
    });
    return head;
}

QWidget* CuePanel::makeEditor() {
    m_editor = new QWidget(this);
    auto* column = spaced(new QVBoxLayout(m_editor), {8, 4, 8, 8}, 4);
    m_caption = new QLineEdit(m_editor);
    m_caption->setPlaceholderText(tr("Caption; the name where there is none"));
    m_caption->setAccessibleName(tr("Caption of the cue"));
    m_caption->setObjectName("cueCaption");
    m_note = new QPlainTextEdit(m_editor);
    m_note->setPlaceholderText(tr("Notes, for you alone"));
    m_note->setAccessibleName(tr("Notes of the cue"));
    m_note->setObjectName("cueNote");
    m_note->setTabChangesFocus(true);
    column->addWidget(m_caption);
    column->addWidget(m_note);
    connect(m_caption, &QLineEdit::textEdited, this, [this](const QString& text) {
        if (m_model->current() >= 0) m_model->setCaption(m_model->current(), text);
    });
    connect(m_note, &QPlainTextEdit::textChanged, this, [this] {
        if (!m_fills && m_model->current() >= 0) m_model->setNote(m_model->current(), m_note->toPlainText());
    });
    followTheme(m_editor, [this] {
        const Theme& theme = Theme::current();
        m_caption->setFont(theme.text());
        m_note->setFont(theme.text());
        m_note->setMinimumHeight(theme.px(46));
        m_list->setMinimumHeight(theme.px(90));
    });
    return m_editor;
}

void CuePanel::showCurrent() {
    const bool any = m_model->size() > 0;
    m_list->setVisible(any);
    m_empty->setVisible(!any);
    m_present->setEnabled(any);
    m_putBack->setVisible(m_model->canPutBack());
    m_title->setText(shownName(m_model->file()));
    m_title->setToolTip(onOneLine(m_model->file().toStdString()));
    const lessons::Cue* cue = m_model->currentCue();
    m_editor->setVisible(cue != nullptr);
    if (!cue) return;
    const QModelIndex row = m_model->index(m_model->current());
    if (!m_list->selectionModel()->isSelected(row)) m_list->setCurrentIndex(row);
    const QString caption = toQString(cue->caption), note = toQString(cue->note);
    if (m_caption->text() != caption) {
        m_caption->setText(caption);
        m_caption->setCursorPosition(0);  // a long one is read from its beginning
    }
    if (m_note->toPlainText() == note) return;
    m_fills = true;
    m_note->setPlainText(note);
    m_fills = false;
}

int CuePanel::selected() const { return m_list->currentIndex().isValid() ? m_list->currentIndex().row() : -1; }

bool CuePanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_list || event->type() != QEvent::KeyPress || selected() < 0)
        return QWidget::eventFilter(watched, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    const int row = selected();
    const bool moves = key->modifiers() & Qt::AltModifier;
    switch (key->key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter: emit asked(row); return true;
        case Qt::Key_Delete: m_model->remove(row); return true;
        case Qt::Key_Up:
            if (moves) return m_model->move(row, row - 1), true;
            break;
        case Qt::Key_Down:
            if (moves) return m_model->move(row, row + 1), true;
            break;
        default: break;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace app
