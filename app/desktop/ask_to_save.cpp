#include "app/desktop/ask_to_save.h"

#include <QMessageBox>
#include <QPushButton>

namespace app {

SaveChanges askToSave(QWidget* window, const QString& name) {
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
    if (box.clickedButton() == save) return SaveChanges::Save;
    return box.clickedButton() == discard ? SaveChanges::Discard : SaveChanges::Cancel;
}

}  // namespace app
