#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QVBoxLayout>

#include "app/lesson/answer_body.h"
#include "app/lesson/prose_view.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"

namespace app {

namespace {

// Rows that are moved with Alt and the arrows, or dragged. As high as they are together.
class OrderList : public QListWidget {
public:
    explicit OrderList(QWidget* parent) : QListWidget(parent) {
        setDragDropMode(InternalMove);
        setDefaultDropAction(Qt::MoveAction);
        setDragDropOverwriteMode(false);
        setWordWrap(true);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    }
    QSize sizeHint() const override {
        int height = 2 * frameWidth();
        for (int i = 0; i < count(); ++i) height += sizeHintForRow(i) + 2 * spacing();
        return {QListWidget::sizeHint().width(), height};
    }
    QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }
    void move(int by) {
        const int from = currentRow(), to = from + by;
        if (from < 0 || to < 0 || to >= count()) return;
        model()->moveRow({}, from, {}, by < 0 ? to : to + 1);
    }

protected:
    void keyPressEvent(QKeyEvent* event) override {
        const bool up = event->key() == Qt::Key_Up, down = event->key() == Qt::Key_Down;
        if ((event->modifiers() & ~Qt::KeypadModifier) == Qt::AltModifier && (up || down)) return move(up ? -1 : 1);
        if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return event->ignore();  // checks
        QListWidget::keyPressEvent(event);
    }
    void resizeEvent(QResizeEvent* event) override {
        QListWidget::resizeEvent(event);
        doItemsLayout();
        updateGeometry();  // words may need another number of lines
    }
};

class OrderBody : public AnswerBody {
public:
    OrderBody(const LessonRun& run, QWidget* parent) : AnswerBody(parent), m_list(new OrderList(this)) {
        const auto& order = std::get<lessons::OrderQuestion>(run.current().question->kind);
        const auto end = [&](const std::string& name, const QString& otherwise) {
            auto* label = new QLabel(name.empty() ? otherwise : toQString(name), this);
            label->setTextFormat(Qt::PlainText);
            label->setProperty("tone", 2);
            return label;
        };
        QLabel *first = end(order.first, tr("first")), *last = end(order.last, tr("last"));
        m_list->setObjectName("order");
        m_list->setAccessibleName(tr("From %1 to %2").arg(first->text(), last->text()));
        for (const std::string& words : run.texts()->options) {
            auto* item = new QListWidgetItem(m_list);
            item->setData(kWords, plainText(toQString(words)));
            item->setData(kIndex, m_list->count() - 1);
        }
        m_list->setCurrentRow(0);
        number();
        m_column->addWidget(first);
        m_column->addWidget(m_list);
        m_column->addWidget(last);
        connect(m_list->model(), &QAbstractItemModel::rowsInserted, this, &OrderBody::number, Qt::QueuedConnection);
        connect(m_list->model(), &QAbstractItemModel::rowsMoved, this, &OrderBody::number);
        followTheme(this, [this, first, last] {
            const Theme& theme = Theme::current();
            for (QLabel* label : {first, last}) label->setFont(theme.text(12));
            m_list->setFont(theme.text());
            m_list->setSpacing(theme.px(3));
            m_list->updateGeometry();
        });
    }
    std::optional<lessons::Given> given() const override {
        lessons::Ordered ordered;
        for (int i = 0; i < m_list->count(); ++i)
            ordered.items.push_back(std::size_t(m_list->item(i)->data(kIndex).toInt()));
        return ordered;
    }
    void takeFocus() override { m_list->setFocus(); }
    void choose(QChar key) override {
        const int number = key.digitValue();
        if (number < 1 || number > m_list->count()) return;
        m_list->setFocus();
        m_list->setCurrentRow(number - 1);
    }
    QString advice() const override { return tr("Move a row with Alt+↑, Alt+↓ or the mouse, then Enter checks."); }

private:
    static constexpr int kWords = Qt::UserRole, kIndex = Qt::UserRole + 1;

    // Each row says its place, which a screen reader reads too, and its letter, by which an answer is recorded.
    void number() {
        for (int i = 0; i < m_list->count(); ++i) {
            QListWidgetItem& item = *m_list->item(i);
            const QString words = item.data(kWords).toString();
            item.setText(QStringLiteral("%1   %2").arg(i + 1).arg(words));
            item.setData(Qt::AccessibleTextRole, tr("%1, %2 of %3").arg(words).arg(i + 1).arg(m_list->count()));
        }
        emit changed();
    }

    OrderList* m_list;
};

}  // namespace

AnswerBody* makeOrderBody(const LessonRun& run, QWidget* parent) { return new OrderBody(run, parent); }

}  // namespace app
