#include "app/widgets/segmented.h"

#include <QHBoxLayout>
#include <QPushButton>

#include "app/widgets/follow_theme.h"

namespace app {
namespace {

QFont segmentFont() { return Theme::current().text(13, 500); }
int padding() { return Theme::current().px(6); }

}  // namespace

int Segmented::widthFor(const QStringList& choices) {
    int width = 0;
    for (const QString& choice : choices)
        width += QFontMetrics(segmentFont()).horizontalAdvance(choice) + 2 * padding() + 2;
    return width;
}

Segmented::Segmented(const QStringList& choices, QWidget* parent) : QWidget(parent) {
    auto* row = spaced(new QHBoxLayout(this), {}, 0);
    for (int i = 0; i < choices.size(); ++i) {
        auto* button = new QPushButton(choices[i], this);
        button->setCheckable(true);
        button->setAutoExclusive(true);  // makes it a radio button to a screen reader; the group decides
        button->setProperty("kind", "segment");
        button->setAccessibleName(choices[i]);
        row->addWidget(button, 1);
        m_group.addButton(button, i);
        followTheme(button, [button] {
            button->setFont(segmentFont());
            button->setStyleSheet(QStringLiteral("QPushButton { padding: 0 %1px; }").arg(padding()));
        });
    }
    connect(&m_group, &QButtonGroup::idClicked, this, &Segmented::chosen);
}

void Segmented::setCurrent(int choice) {
    if (QAbstractButton* button = m_group.button(choice)) button->setChecked(true);
    // One stop of Tab, at the choice; from there the arrows choose.
    for (QAbstractButton* button : m_group.buttons())
        button->setFocusPolicy(button->isChecked() ? Qt::StrongFocus : Qt::ClickFocus);
}

}  // namespace app
