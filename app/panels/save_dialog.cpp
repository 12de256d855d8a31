#include "app/panels/save_dialog.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

namespace app {

QString askWhereToSave(QWidget* parent, const QString& title, const QString& proposed, const QString& filter,
                       const QString& suffix) {
    QString file = proposed;
    for (;;) {
        file = QFileDialog::getSaveFileName(parent, title, file, filter);
        if (file.isEmpty() || !QFileInfo(file).suffix().isEmpty()) return file;
        // Not by QFileDialog::setDefaultSuffix: dialogs of a desktop's own ask about the name without it, too.
        file += '.' + suffix;
        if (!QFileInfo::exists(file)) return file;
        const QString question = QFileDialog::tr("%1 already exists.\nDo you want to replace it?");
        if (QMessageBox::warning(parent, title, question.arg(QFileInfo(file).fileName()),
                                 QMessageBox::Yes | QMessageBox::No, QMessageBox::No) == QMessageBox::Yes)
            return file;
    }
}

}  // namespace app
