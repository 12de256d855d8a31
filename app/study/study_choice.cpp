#include "app/study/study_choice.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>

#include "app/look/accessible.h"
#include "app/look/text.h"
#include "app/widgets/elided_label.h"
#include "app/widgets/follow_theme.h"
#include "pipeline/export/study/study_text.h"
#include "pipeline/study/analysis.h"

namespace app {

using pipeline::ErrorChoice;
using pipeline::ErrorKind;

StudyChoice::StudyChoice(QWidget* parent) : QWidget(parent) {
    auto* row = spaced(new QHBoxLayout(this), {}, 8);
    const auto combo = [&](const QString& title, const QString& name) {
        auto* box = new QComboBox(this);
        box->setObjectName(name);
        box->setToolTip(title);
        nameComboBox(*box, title);
        row->addWidget(box);
        return box;
    };
    m_buffer = combo(tr("Buffer"), "studyBuffer");
    m_error = combo(tr("Error"), "studyError");
    m_error->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_reference = new ElidedLabel(this);
    m_reference->setObjectName("studyReference");
    m_reference->setTextFormat(Qt::PlainText);
    m_reference->setProperty("tone", 2);
    row->addWidget(m_reference, 1);
    connect(m_buffer, &QComboBox::activated, this, [this] {
        m_choice.buffer = m_buffer->currentText().toStdString();
        fillErrors();
        emit changed();
    });
    connect(m_error, &QComboBox::activated, this, [this](int at) {
        const QStringList parts = m_error->itemData(at).toStringList();
        m_choice.measure = parts[0].toStdString();
        m_choice.kind = static_cast<ErrorKind>(parts[1].toInt());
        showReference();
        emit changed();
    });
    followTheme(this, [this] {
        m_buffer->setFont(Theme::current().mono(12));
        m_reference->setFont(Theme::current().text(12));
    });
}

void StudyChoice::setReport(const pipeline::StudyReport& report) {
    m_report = report;
    const std::vector<ErrorChoice> all = choicesOf(report);
    const auto has = [&](const ErrorChoice& choice) { return std::find(all.begin(), all.end(), choice) != all.end(); };
    if (!has(m_choice)) m_choice = has(report.choice) || all.empty() ? report.choice : all.front();
    m_buffer->clear();
    for (const ErrorChoice& choice : all)
        if (m_buffer->findText(toQString(choice.buffer)) < 0) m_buffer->addItem(toQString(choice.buffer));
    m_buffer->setCurrentIndex(m_buffer->findText(toQString(m_choice.buffer)));
    fillErrors();
}

// Of the chosen buffer; the same measure again where it has it.
void StudyChoice::fillErrors() {
    m_error->clear();
    int chosen = -1;
    for (const ErrorChoice& choice : choicesOf(m_report)) {
        if (choice.buffer != m_choice.buffer) continue;
        if (choice == m_choice) chosen = m_error->count();
        m_error->addItem(tr("%1, %2 error").arg(toQString(choice.measure), toQString(name(choice.kind))),
                         QStringList{toQString(choice.measure), QString::number(int(choice.kind))});
    }
    if (chosen < 0 && m_error->count() > 0) {
        chosen = 0;
        const QStringList parts = m_error->itemData(0).toStringList();
        m_choice.measure = parts[0].toStdString();
        m_choice.kind = static_cast<ErrorKind>(parts[1].toInt());
    }
    m_error->setCurrentIndex(chosen);
    showReference();
}

void StudyChoice::showReference() {
    m_reference->setText(m_report.points.empty()
                             ? QString()
                             : tr("Reference, %1").arg(toQString(referenceText(m_report, m_choice.kind, m_choice))));
}

}  // namespace app
