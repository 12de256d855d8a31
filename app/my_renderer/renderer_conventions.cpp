#include "app/my_renderer/renderer_conventions.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "app/look/accessible.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"

namespace app {

RendererConventions::RendererConventions(RendererCheck& renderer, QWidget* parent)
    : QWidget(parent), m_renderer(renderer), m_grid(new QGridLayout(this)) {
    setObjectName("rendererConventions");
    m_grid->setColumnStretch(1, 1);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_grid->setContentsMargins(0, 0, 0, 0);
        m_grid->setHorizontalSpacing(theme.px(8));
        m_grid->setVerticalSpacing(theme.px(4));
    });
}

void RendererConventions::addRow(const pipeline::foreign::ConventionChoice& choice, int row) {
    const bool byHand = m_renderer.byHand().contains(choice.key);
    auto* key = new QLabel(toQString(choice.key), this);
    auto* list = new QComboBox(this);
    list->setObjectName("convention:" + toQString(choice.key));
    nameComboBox(*list, toQString(choice.key));
    list->setToolTip(toQString(choice.buffers));
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    list->setMinimumContentsLength(8);
    for (const std::string& value : choice.values) list->addItem(toQString(value));
    list->setCurrentText(toQString(choice.value));
    connect(list, &QComboBox::textActivated, this,
            [this, key = choice.key](const QString& value) { m_renderer.state(key, value.toStdString()); });
    QWidget* beside = nullptr;
    if (byHand) {
        auto* back = new QPushButton(tr("by hand: put back"), this);
        back->setObjectName("putBack:" + toQString(choice.key));
        back->setProperty("kind", "link");
        back->setToolTip(tr("Read the files as they were found to be written"));
        connect(
            back, &QPushButton::clicked, this, [this, key = choice.key] { m_renderer.state(key, {}); },
            Qt::QueuedConnection);
        beside = back;
    } else {
        auto* certainty = styled(new QLabel(toQString(choice.certainty), this), {.tone = 2, .wraps = true});
        beside = certainty;
    }
    m_grid->addWidget(key, row, 0);
    m_grid->addWidget(list, row, 1);
    m_grid->addWidget(beside, row, 2);
    followTheme(key, [key, list, beside] {
        const Theme& theme = Theme::current();
        key->setFont(theme.text(12));
        list->setFont(theme.text(12));
        beside->setFont(theme.text(12));
    });
}

void RendererConventions::show(const pipeline::foreign::Report& report) {
    // A list that has just been changed by its keys gives them to the one that takes its place.
    QString focused;
    for (auto* list : findChildren<QComboBox*>())
        if (list->hasFocus()) focused = list->objectName();
    while (QLayoutItem* item = m_grid->takeAt(0)) {
        item->widget()->hide();
        item->widget()->setObjectName({});
        item->widget()->deleteLater();
        delete item;
    }
    const auto choices = conventionChoices(report);
    int row = 0;
    for (const pipeline::foreign::ConventionChoice& choice : choices) addRow(choice, row++);
    const auto found = std::ranges::count_if(choices, [](const auto& choice) { return !choice.certainty.empty(); });
    const auto byHand = m_renderer.byHand().size();
    m_sentence = byHand > 0   ? tr("%1 by hand").arg(byHand)
                 : found == 0 ? tr("as this program's")
                              : tr("%1 found, read as such").arg(found);
    if (auto* list = focused.isEmpty() ? nullptr : findChild<QComboBox*>(focused)) list->setFocus();
}

}  // namespace app
