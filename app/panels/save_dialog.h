#pragma once
#include <QString>

class QWidget;

namespace app {

// Whether what has this name already is to be replaced.
bool askToReplace(QWidget* parent, const QString& title, const QString& name);

// Asks where to save a file. Under a filter of its ending a name without one gets `suffix`, as in "toml", and the file of
// that name is not replaced without a question. Empty where nothing is to be saved.
QString askWhereToSave(QWidget* parent, const QString& title, const QString& proposed, const QString& filter,
                       const QString& suffix);

}  // namespace app
