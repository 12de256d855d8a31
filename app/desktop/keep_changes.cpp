#include "app/desktop/keep_changes.h"

#include <QMessageBox>
#include <QPushButton>

namespace app {

KeepChanges askToKeep(QWidget* window, const QString& name) {
    QMessageBox box(QMessageBox::NoIcon, QMessageBox::tr("Changes"),
                    QMessageBox::tr("Keep the changes to %1?").arg(name), QMessageBox::NoButton, window);
    box.setObjectName("keepChanges");
    // In this order on every desktop: what is safe first.
    QPushButton* keep = box.addButton(QMessageBox::tr("Keep"), QMessageBox::YesRole);
    const QPushButton* drop = box.addButton(QMessageBox::tr("Drop"), QMessageBox::NoRole);
    QPushButton* back = box.addButton(QMessageBox::tr("Go back"), QMessageBox::RejectRole);
    box.setDefaultButton(keep);
    box.setEscapeButton(back);
    box.exec();
    if (box.clickedButton() == keep) return KeepChanges::Keep;
    return box.clickedButton() == drop ? KeepChanges::Drop : KeepChanges::GoBack;
}

}  // namespace app
