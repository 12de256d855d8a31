#include "app/panels/save_dialog.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace app {

bool askToReplace(QWidget* parent, const QString& title, const QString& name) {
    QMessageBox box(QMessageBox::NoIcon, title, QMessageBox::tr("%1 already exists. Replace it?").arg(name),
                    QMessageBox::Yes | QMessageBox::No, parent);
    box.button(QMessageBox::Yes)->setText(QMessageBox::tr("Replace"));
    box.button(QMessageBox::No)->setText(QMessageBox::tr("Go back"));
    box.setDefaultButton(QMessageBox::No);
    return box.exec() == QMessageBox::Yes;
}

QString askWhereToSave(QWidget* parent, const QString& title, const QString& proposed, const QString& filter,
                       const QString& suffix) {
    QString file = proposed, chosen;
    for (;;) {
        file = QFileDialog::getSaveFileName(parent, title, file, filter, &chosen);
        const bool another = !chosen.isEmpty() && !chosen.contains("*." + suffix);
        if (file.isEmpty() || another || !QFileInfo(file).suffix().isEmpty()) return file;
        // Not by QFileDialog::setDefaultSuffix: dialogs of a desktop's own ask about the name without it, too.
        file += '.' + suffix;
        if (!QFileInfo::exists(file) || askToReplace(parent, title, QFileInfo(file).fileName())) return file;
    }
}

}  // namespace app
