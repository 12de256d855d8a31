#pragma once
#include <QStringList>
#include <functional>

class QWidget;

namespace app {

// Whether what has these names already is to be replaced.
bool askToReplace(QWidget* parent, const QString& title, const QStringList& names);

// Asks for the file to save to; empty if the user cancels. A name without `suffix`, as in "toml", gets it, and no file
// is replaced without a question. written: the files that are written for a name, if there are several.
QString askWhereToSave(QWidget* parent, const QString& title, const QString& proposed, const QString& filter,
                       const QString& suffix, const std::function<QStringList(const QString&)>& written = {});

}  // namespace app
