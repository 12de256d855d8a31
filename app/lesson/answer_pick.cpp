#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "app/lesson/answer_body.h"
#include "app/lesson/pick_watch.h"
#include "app/look/accessible.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"

namespace app {

namespace {

using lessons::ThingKind;

// Clicked in a view, or chosen in a list by somebody who does not see the picture.
class PickBody : public AnswerBody {
public:
    PickBody(const lessons::ClickQuestion& question, Document& document, QWidget* parent)
        : AnswerBody(parent), m_document(document), m_kind(question.kind), m_said(new QLabel(this)) {
        m_said->setObjectName("picked");
        m_column->addWidget(m_said);
        if (m_kind != ThingKind::Pixel) addList();
        followTheme(this, [this] { m_said->setFont(Theme::current().text()); });
        if (m_kind == ThingKind::Pixel)
            connect(&document.pointing(), &Pointing::pixelChanged, this, &PickBody::takePixel);
        else
            new PickWatch(document, this, [this](const lessons::Thing& thing) {
                if (thing.kind == m_kind) take(thing);
            });
        tell();
    }
    std::optional<lessons::Given> given() const override {
        if (!m_pick) return {};
        return *m_pick;
    }
    void takeFocus() override { m_list ? m_list->setFocus() : setFocus(); }
    QString advice() const override {
        return m_kind == ThingKind::Pixel ? tr("Click a pixel, or type its place with Ctrl+G; Enter checks.")
                                          : tr("Click in a view, or choose in the list; Enter checks.");
    }
    QString banner() const override { return tr("Click the %1 that answers the question.").arg(what()); }

private:
    QString what() const { return toQString(lessons::name(m_kind)); }

    void addList() {
        constexpr std::size_t kMost = 200;  // a longer list helps nobody
        m_list = new QComboBox(this);
        m_list->setObjectName("things");
        nameComboBox(*m_list, tr("Your answer"));
        m_list->addItem(tr("No %1 yet").arg(what()));
        const std::size_t count = std::min(kMost, countOf(m_kind, m_document.scene()));
        for (std::size_t i = 0; i < count; ++i) m_list->addItem(QStringLiteral("%1 %2").arg(what()).arg(i));
        m_column->addWidget(m_list, 0, Qt::AlignLeft);
        connect(m_list, &QComboBox::activated, this, [this](int row) {
            if (row > 0) take(lessons::Thing{m_kind, std::size_t(row - 1)});
        });
    }
    void takePixel() {
        const auto pixel = m_document.pointing().pixel();
        if (!pixel) return;
        lessons::Pick pick;
        pick.x = pixel->x, pick.y = pixel->y;
        m_pick = pick;
        tell();
    }
    void take(const lessons::Thing& thing) {
        m_pick = pickOf(thing);
        m_index = int(thing.index);
        if (m_list && m_index + 1 < m_list->count()) m_list->setCurrentIndex(m_index + 1);
        tell();
    }
    void tell() {
        if (!m_pick)
            m_said->setText(tr("No %1 is picked yet.").arg(what()));
        else if (m_kind == ThingKind::Pixel)
            m_said->setText(tr("Your pixel: %1, %2").arg(*m_pick->x).arg(*m_pick->y));
        else
            m_said->setText(tr("Your %1: %2").arg(what()).arg(m_index));
        emit changed();
    }

    Document& m_document;
    ThingKind m_kind;
    QLabel* m_said;
    QComboBox* m_list = nullptr;
    std::optional<lessons::Pick> m_pick;
    int m_index = 0;
};

}  // namespace

AnswerBody* makePickBody(const lessons::ClickQuestion& question, Document& document, QWidget* parent) {
    return new PickBody(question, document, parent);
}

}  // namespace app
