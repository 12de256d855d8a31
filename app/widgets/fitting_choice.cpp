#include "app/widgets/fitting_choice.h"

#include <QComboBox>
#include <QVBoxLayout>

#include "app/look/accessible.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/segmented.h"

namespace app {

FittingChoice::FittingChoice(const QStringList& choices, const QString& name, const QString& listName, QWidget* parent)
    : QWidget(parent), m_segmented(new Segmented(choices, this)), m_list(new QComboBox(this)) {
    m_segmented->setAccessibleName(name);
    m_list->setObjectName(listName);
    m_list->addItems(choices);
    nameComboBox(*m_list, name);
    auto* column = spaced(new QVBoxLayout(this), {});
    column->addWidget(m_segmented);
    column->addWidget(m_list);
    connect(m_segmented, &Segmented::chosen, this, &FittingChoice::chosen);
    connect(m_list, &QComboBox::activated, this, &FittingChoice::chosen);
    setCurrent(0);
    setNarrow(false);
}

void FittingChoice::setNarrow(bool isNarrow) {
    m_segmented->setVisible(!isNarrow);
    m_list->setVisible(isNarrow);
}

void FittingChoice::setCurrent(int choice) {
    m_segmented->setCurrent(choice);
    m_list->setCurrentIndex(choice);
}

}  // namespace app
