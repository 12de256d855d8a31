#include <QButtonGroup>
#include <QVBoxLayout>

#include "app/lesson/answer_body.h"
#include "app/lesson/option_button.h"
#include "app/lesson/pick_watch.h"
#include "app/lesson/prose_view.h"
#include "app/look/text.h"

namespace app {

namespace {

// One of several rows, or any number of them.
class OptionsBody : public AnswerBody {
public:
    OptionsBody(const LessonRun& run, bool several, Document& document, QWidget* parent)
        : AnswerBody(parent), m_several(several) {
        const PageTexts& texts = *run.texts();
        auto* group = new QButtonGroup(this);
        group->setExclusive(!several);
        for (std::size_t i = 0; i < texts.options.size(); ++i) {
            const QString words = plainText(toQString(texts.options[i]));
            const int key = int(i) + 1;
            QAbstractButton* row = nullptr;
            if (several) {
                auto* box = new OptionButton<QCheckBox>(words, key, this);
                m_setOff.push_back([box](bool off) { box->setOff(off); });
                row = box;
            } else {
                auto* radio = new OptionButton<QRadioButton>(words, key, this);
                m_setOff.push_back([radio](bool off) { radio->setOff(off); });
                row = radio;
            }
            row->setObjectName(QStringLiteral("option%1").arg(key));
            group->addButton(row, int(i));
            m_column->addWidget(row);
            m_rows.push_back(row);
            connect(row, &QAbstractButton::toggled, this, &AnswerBody::changed);
        }
        for (const lessons::Option& option : optionsOf(*run.current().question)) {
            m_things.push_back(option.thing);
            if (option.thing) m_what = toQString(name(option.thing->kind));
        }
        if (!m_what.isEmpty()) new PickWatch(document, this, [this](const auto& thing) { toggle(thing); });
    }
    std::optional<lessons::Given> given() const override {
        lessons::Chosen chosen;
        for (std::size_t i = 0; i < m_rows.size(); ++i)
            if (m_rows[i]->isChecked() && m_rows[i]->isEnabled()) chosen.options.push_back(i);
        if (chosen.options.empty()) return {};
        return chosen;
    }
    void takeAttempt(const lessons::Attempt& attempt) override {
        for (std::size_t i = 0; i < m_rows.size(); ++i) m_setOff[i](attempt.isOff(i));
        emit changed();
    }
    void takeFocus() override {
        for (QAbstractButton* row : m_rows)
            if (row->isEnabled()) return row->setFocus();
    }
    void choose(QChar key) override {
        const int number = key.digitValue();
        if (number < 1 || number > int(m_rows.size()) || !m_rows[std::size_t(number - 1)]->isEnabled()) return;
        QAbstractButton* row = m_rows[std::size_t(number - 1)];
        row->setFocus();
        m_several ? row->toggle() : row->setChecked(true);
    }
    QString advice() const override {
        QStringList keys;
        for (std::size_t i = 0; i < m_rows.size(); ++i)
            if (m_rows[i]->isEnabled()) keys << QString::number(i + 1);
        const QString last = keys.takeLast();
        return tr("Choose with %1, then Enter checks.")
            .arg(keys.isEmpty() ? last : tr("%1 or %2").arg(keys.join(QStringLiteral(", ")), last));
    }

    QString banner() const override {
        return m_what.isEmpty() ? QString() : tr("Click a %1 here, or choose in the question.").arg(m_what);
    }

private:
    void toggle(const lessons::Thing& thing) {
        for (std::size_t i = 0; i < m_things.size(); ++i)
            if (m_things[i] == thing && m_rows[i]->isEnabled()) m_rows[i]->click();
    }

    bool m_several;
    QString m_what;  // can be clicked in a view
    std::vector<std::optional<lessons::Thing>> m_things;
    std::vector<QAbstractButton*> m_rows;
    std::vector<std::function<void(bool)>> m_setOff;
};

}  // namespace

AnswerBody* makeOptionsBody(const LessonRun& run, bool several, Document& document, QWidget* parent) {
    return new OptionsBody(run, several, document, parent);
}

}  // namespace app
