#include "app/lesson/answer_body.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "app/look/text.h"
#include "app/widgets/follow_theme.h"

namespace app {

namespace {

// A field with the unit behind it.
class NumberBody : public AnswerBody {
public:
    NumberBody(const lessons::NumberQuestion& question, QWidget* parent)
        : AnswerBody(parent), m_field(new QLineEdit(this)) {
        const QString unit = toQString(question.unit);
        auto* behind = new QLabel(unit, this);
        auto* forms = styled(new QLabel(tr("Accepted too: 1,5   3/2   sqrt(2)/2   −1.5e3"), this),
                             {.tone = 3, .size = 12, .wraps = true});
        m_field->setObjectName("answer");
        m_field->setAccessibleName(unit.isEmpty() ? tr("Answer") : tr("Answer in %1").arg(unit));
        m_field->setMaxLength(200);
        auto* row = spaced(new QHBoxLayout, {}, 8);
        row->addWidget(m_field);
        row->addWidget(behind);
        row->addStretch(1);
        m_column->addLayout(row);
        m_column->addWidget(forms);
        connect(m_field, &QLineEdit::textChanged, this, &AnswerBody::changed);
        followTheme(this, [this, behind] {
            const Theme& theme = Theme::current();
            m_field->setFont(theme.mono());
            m_field->setFixedWidth(theme.px(130));
            behind->setFont(theme.text());
        });
    }
    std::optional<lessons::Given> given() const override {
        const QString typed = m_field->text().trimmed();
        if (typed.isEmpty()) return {};
        return lessons::Typed{typed.toStdString()};
    }
    void takeFocus() override {
        m_field->setFocus();
        m_field->selectAll();
    }
    void choose(QChar key) override {
        m_field->setFocus();
        m_field->insert(key);
    }
    QString advice() const override { return tr("Type the number, then Enter checks."); }

private:
    QLineEdit* m_field;
};

// One for each kind of question, so that the compiler asks for that of a new one.
struct BodyOf {
    LessonRun& run;
    Document& document;
    QWidget* parent;

    AnswerBody* operator()(const lessons::NumberQuestion& number) const { return makeNumberBody(number, parent); }
    AnswerBody* operator()(const lessons::ChoiceQuestion&) const {
        return makeOptionsBody(run, false, document, parent);
    }
    AnswerBody* operator()(const lessons::SeveralQuestion&) const {
        return makeOptionsBody(run, true, document, parent);
    }
    AnswerBody* operator()(const lessons::ClickQuestion& click) const { return makePickBody(click, document, parent); }
    AnswerBody* operator()(const lessons::UntilQuestion& until) const {
        return makeUntilBody(until, run, document, parent);
    }
    AnswerBody* operator()(const lessons::WriteQuestion& write) const { return makeWriteBody(write, run, parent); }
    AnswerBody* operator()(const lessons::OrderQuestion&) const { return makeOrderBody(run, parent); }
};

}  // namespace

AnswerBody::AnswerBody(QWidget* parent) : QWidget(parent), m_column(new QVBoxLayout(this)) {
    m_column->setContentsMargins(0, 0, 0, 0);
    followTheme(m_column, [this] { m_column->setSpacing(Theme::current().px(4)); });
}

AnswerBody* makeNumberBody(const lessons::NumberQuestion& question, QWidget* parent) {
    return new NumberBody(question, parent);
}

AnswerBody* makeAnswerBody(LessonRun& run, Document& document, QWidget* parent) {
    return std::visit(
        [&](const auto& kind) {
            return BodyOf{run, document, parent}(kind);
        },
        run.current().question->kind);
}

}  // namespace app
