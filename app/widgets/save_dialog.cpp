#include "app/widgets/save_dialog.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "app/look/shown_name.h"

namespace app {

bool askToReplace(QWidget* parent, const QString& title, const QStringList& names) {
    const QString question = names.size() == 1 ? QMessageBox::tr("%1 already exists. Replace it?")
                                               : QMessageBox::tr("%1 already exist. Replace them?");
    QMessageBox box(QMessageBox::NoIcon, title, question.arg(names.join(QMessageBox::tr(" and "))),
                    QMessageBox::Yes | QMessageBox::No, parent);
    box.button(QMessageBox::Yes)->setText(QMessageBox::tr("Replace"));
    box.button(QMessageBox::No)->setText(QMessageBox::tr("Cancel"));
    box.setDefaultButton(QMessageBox::No);
    return box.exec() == QMessageBox::Yes;
}

QString askWhereToSave(QWidget* parent, const QString& title, const QString& proposed, const QString& filter,
                       const QString& suffix, const std::function<QStringList(const QString&)>& written) {
    const QString ending = '.' + suffix;
    QString file = proposed, chosen;
    for (;;) {
        const QString named = QFileDialog::getSaveFileName(parent, title, file, filter, &chosen);
        if (named.isEmpty()) return {};
        if (!chosen.isEmpty() && !chosen.contains('*' + ending)) return named;  // of another kind
        // Not by QFileDialog::setDefaultSuffix: dialogs of a desktop's own ask about the name without it, too. And
        // "lecture 1.2" has a suffix, but not this one.
        file = named.endsWith(ending, Qt::CaseInsensitive) ? named : named + ending;
        QStringList there;  // about which the dialog has not asked
        for (const QString& one : written ? written(file) : QStringList{file})
            if (one != named && QFileInfo::exists(one)) there += shownName(one);
        if (there.isEmpty() || askToReplace(parent, title, there)) return file;
    }
}

}  // namespace app
