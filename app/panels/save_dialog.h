#pragma once
#include <QString>

class QWidget;

namespace app {

// Asks where to save a file. A name without an ending gets `suffix`, as in "toml", and the file of that name is not
// replaced without a question. Empty where nothing is to be saved.
QString askWhereToSave(QWidget* parent, const QString& title, const QString& proposed, const QString& filter,
                       const QString& suffix);

}  // namespace app
