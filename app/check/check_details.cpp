#include "app/check/check_details.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "app/look/text.h"
#include "app/widgets/follow_theme.h"

namespace app {

CheckDetails::CheckDetails(QWidget* parent) : QWidget(parent) {
    const auto label = [this](const QString& text = {}) {
        auto* made = new QLabel(text, this);
        made->setWordWrap(true);
        made->setTextFormat(Qt::PlainText);
        made->setTextInteractionFlags(Qt::TextSelectableByMouse);
        return made;
    };
    m_id = new QLabel(this);
    m_title = label();
    m_title->setObjectName("checkTitle");
    m_verdict = label();
    m_verdict->setObjectName("checkVerdict");
    m_open = new QPushButton(tr("Open as scene"), this);
    m_open->setObjectName("checkOpen");
    m_formTitles = {label(tr("Naive")), label(tr("Ours"))};
    m_forms = {label(), label()};
    m_forms[0]->setObjectName("checkNaiveForm");
    m_forms[1]->setObjectName("checkOurForm");

    auto* head = new QHBoxLayout;
    head->addWidget(m_id);
    head->addWidget(m_title, 1);
    head->addWidget(m_open);
    auto* forms = new QGridLayout;
    for (int i = 0; i < 2; ++i) {
        forms->addWidget(m_formTitles[std::size_t(i)], 0, i);
        forms->addWidget(m_forms[std::size_t(i)], 1, i, Qt::AlignTop);
        forms->setColumnStretch(i, 1);
    }
    // Words in one pair of columns, what was found in another.
    auto* lines = new QGridLayout;
    const std::array names{tr("input"),      tr("measure"), tr("against"), tr("naive gives"),
                           tr("ours gives"), tr("bound"),   tr("outcome")};
    for (std::size_t i = 0; i < kLines; ++i) {
        m_names[i] = new QLabel(names[i], this);
        m_names[i]->setProperty("tone", 3);
        m_lines[i] = label();
        const int row = i < NaiveGives ? int(i) : int(i) - NaiveGives, column = i < NaiveGives ? 0 : 2;
        lines->addWidget(m_names[i], row, column, Qt::AlignTop);
        lines->addWidget(m_lines[i], row, column + 1, Qt::AlignTop);
    }
    m_lines[NaiveGives]->setObjectName("checkNaiveGives");
    m_lines[OursGives]->setObjectName("checkOursGives");
    lines->setColumnStretch(1, 3);
    lines->setColumnStretch(3, 2);
    auto* column = spaced(new QVBoxLayout(this), {12, 10, 12, 12}, 12);
    column->addLayout(head);
    column->addLayout(forms);
    column->addLayout(lines);
    column->addWidget(m_verdict);
    connect(m_open, &QPushButton::clicked, this, &CheckDetails::openAsked);
    followTheme(this, [this, forms, lines] {
        const Theme& theme = Theme::current();
        forms->setHorizontalSpacing(theme.px(16));
        lines->setHorizontalSpacing(theme.px(10));
        lines->setVerticalSpacing(theme.px(4));
        m_id->setFont(theme.mono(15));
        m_title->setFont(theme.text(15, 600));
        m_verdict->setFont(theme.text(13, 600));
        for (QLabel* form : m_forms) form->setFont(theme.text(15));
        for (QLabel* name : m_names) name->setFont(theme.text(13));
        for (QLabel* line : m_lines) line->setFont(theme.text(13));
        const auto title = [&](QLabel* of, const QColor& color) {
            of->setFont(theme.text(13, 600));
            of->setStyleSheet(QStringLiteral("color: %1;").arg(color.name()));
        };
        title(m_formTitles[0], theme.colors().failed);
        title(m_formTitles[1], theme.colors().N);
    });
}

void CheckDetails::setCase(const pipeline::check::Case& which,
                           const std::optional<pipeline::check::CaseResult>& result) {
    m_id->setText(toQString(which.id));
    m_title->setText(toQString(which.title));
    m_forms[0]->setText(toQString(which.naive));
    m_forms[1]->setText(toQString(which.stable));
    const QString none = tr("not run");
    m_lines[GoesIn]->setText(toQString(which.input));
    m_lines[Measure]->setText(toQString(which.measure));
    m_lines[Reference]->setText(toQString(which.reference));
    m_lines[NaiveGives]->setText(result ? toQString(result->naiveText()) : none);
    m_lines[OursGives]->setText(result ? toQString(result->oursText()) : none);
    m_lines[Bound]->setText(toQString(pipeline::check::measured(which.bound, which.unit)));
    m_lines[EndsIn]->setText(toQString(name(which.outcome)));
    m_verdict->setText(!result         ? QString()
                       : result->holds ? tr("● holds, in %1 ms").arg(result->milliseconds, 0, 'f', 1)
                                       : tr("▲ breaks: %1").arg(toQString(result->reason)));
    const ThemeColors& c = Theme::current().colors();
    m_verdict->setStyleSheet(QStringLiteral("color: %1;").arg((result && result->holds ? c.run : c.failed).name()));
    m_verdict->setVisible(result.has_value());
    m_open->setEnabled(which.scene != nullptr);
    m_open->setToolTip(which.scene ? tr("Opens the case in the main window (Enter in the table).")
                                   : tr("This case is numbers or a file: it has no scene."));
}

}  // namespace app
