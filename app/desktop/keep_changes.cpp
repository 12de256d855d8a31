#include "app/desktop/keep_changes.h"

#include <QMessageBox>
#include <QPushButton>

namespace app {

KeepChanges askToKeep(QWidget* window, const QString& name) {
    QMessageBox box(QMessageBox::NoIcon, QMessageBox::tr("Changes"),
                    QMessageBox::tr("Save the changes to %1?").arg(name), QMessageBox::NoButton, window);
    box.setObjectName("keepChanges");
    // In this order on every desktop: what is safe first.
    QPushButton* save = box.addButton(QMessageBox::tr("Save"), QMessageBox::YesRole);
    const QPushButton* discard = box.addButton(QMessageBox::tr("Discard"), QMessageBox::NoRole);
    QPushButton* cancel = box.addButton(QMessageBox::tr("Cancel"), QMessageBox::RejectRole);
    box.setDefaultButton(save);
    box.setEscapeButton(cancel);
    box.exec();
    if (box.clickedButton() == save) return KeepChanges::Save;
    return box.clickedButton() == discard ? KeepChanges::Discard : KeepChanges::Cancel;
}

}  // namespace app
