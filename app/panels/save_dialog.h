#pragma once
#include <QStringList>
#include <functional>

class QWidget;

namespace app {

// Whether what has these names already is to be replaced.
bool askToReplace(QWidget* parent, const QString& title, const QStringList& names);

// Asks where to save a file. Under a filter of `suffix`, as in "toml", a name that does not end in it gets it, and no file
// is replaced without a question. written: the files that come of the name, where it is not that one alone. Empty where
// nothing is to be saved.
QString askWhereToSave(QWidget* parent, const QString& title, const QString& proposed, const QString& filter,
                       const QString& suffix, const std::function<QStringList(const QString&)>& written = {});

}  // namespace app
